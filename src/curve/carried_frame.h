// Rotation-minimising frames along a cubic to a bound of their angle: double reflection in as many steps as it takes.
#pragma once

#include <optional>

#include "curve/cubic.h"
#include "curve/frames.h"

namespace coaster::curve {

// rad (1e-5 degrees): how far frames may be from the exact rotation-minimising frame of the given control points, where
// the speed |B'| is nowhere below 1e-4 of its largest. Slower curves are as near as rounding allows.
inline constexpr double kFrameBound = 1e-5 * 3.14159265358979323846 / 180;

// Returns how far on either side of t (of t) the direction of travel has turned round, if it does so where |B'| is at
// most `stopped`, at an extreme of |B'| in (0,1): at a cusp, or where a curve runs back on its own line.
std::optional<double> reversal(const CoefficientsD& curve, double t, double stopped);

// The reversals in (0,1) where B' counts as 0 as for unit_tangent(), below 1e-9 of the longest leg. Ascending, within
// 1e-15. About 0.3 us.
struct Cusps {
  int count = 0;
  double t[2] = {0, 0};
};
Cusps cusps(const Cubic& cubic);

// Returns a bound in radians of the error of carrying a frame by one double reflection from t to t + h, or to any place
// between; infinity where the speed may fall below half of that at t, because then such a step says little.
double step_error(const CoefficientsD& curve, double t, double h);

// Returns a bound of the error of `steps` equal steps from 0 to 1, from the control points alone: cheap and coarse;
// infinity where a leg runs against the chord.
double steps_error(const Cubic& cubic, int steps);

// Carries a frame at t0 to t1 > t0, with the unit tangent there: within 1e-9 rad of the exact frame where the speed is
// not below 1e-4 of its largest. At a cusp the frame makes a half turn about `up`. At most 4096 steps between cusps.
// No libm function except sqrt: the same bits everywhere.
Frame carried(const Cubic& cubic, const Frame& from, double t0, double t1);

}  // namespace coaster::curve
