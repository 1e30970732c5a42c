// Tight places of a cubic: minima of its radius of curvature, and reversals of its direction (cusps, and straights that
// double back). Found by isolating the roots of polynomials, not by sampling.
#pragma once

#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

struct TightPlace {
  double t = 0;
  double radius = 0;      // m; 0 at a reversal
  bool reversal = false;  // B' vanishes there to the rounding of the control points, and the tangent turns round
  double half = 0;        // of t: of a reversal: within it on either side curvature is mostly rounding
  double apart = 0;       // m: the largest radius from here to the next place, or to t = 1
};

// Returns the local minima of the radius below `limit` (m) in [0,1], both ends included, and all interior reversals,
// ascending: t within 1e-9, or within 1e-6 of the width of a sharp bend; the radius within 1e-6 of itself. An end where
// B' vanishes has no radius. About 0.05 us for a gentle segment, 1 us for a half turn, 30 us for a tight one.
std::vector<TightPlace> tight_places(const Cubic& cubic, double limit);

// Returns |B'|^3 / |B' x B''| at t (m); infinite on a straight, 0 where B' vanishes.
double radius_at(const Cubic& cubic, double t);

}  // namespace coaster::curve
