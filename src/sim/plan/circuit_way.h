// A way home: leads, turns and heights, what riders feel on it, and its ideal curve.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "sim/plan/circuit_ends.h"
#include "sim/plan/circuit_heights.h"
#include "world/components.h"

namespace coaster::sim {

// The ends between which a track is to be completed, and the train.
struct CircuitTask {
  TrackEnd from;  // the open end
  TrackEnd home;  // the first knot, in the train's direction, with the curvature and spin of its own segment
  double from_slope = 0, home_slope = 0;  // rad/m^2, of the roll's rate just before `from` and just after `home`
  double speed = 10;                      // m/s at the open end
  bool coasts = true;                     // the speed follows from the energy; false: it is constant
  world::Resistance losses;               // of that train
  double rails = 0, riders = 0;           // m above the curve
  friend bool operator==(const CircuitTask&, const CircuitTask&) = default;
};

// Limits for what riders feel on a way home: the strictest, for durations over 4 s (docs/ride.md).
inline constexpr double kMostUp = 4.0, kLeastUp = -0.3, kMostSide = 1.2;  // g
// g, lateral, caused by rolling: ways home with less are preferred.
inline constexpr double kGentleSide = 0.55;
inline constexpr double kSlowestHome = 2;     // m/s, anywhere on the way; less for a train that arrives slower
inline constexpr double kSteepestHome = 0.7;  // m per metre in plan, between the bends
inline constexpr double kLowestRails = 1;     // m above the ground, or the lower end's height if that is less

struct FeltRange {
  double most = 1, least = 1, side = 0;  // g: vertical, and the largest lateral
  bool within() const { return most <= kMostUp && least >= kLeastUp && side <= kMostSide; }
};

struct CircuitWay {
  Lead in, out;
  Turns turns;
  Heights heights;
};

// Returns the least speed on the way, m/s.
inline double slowest(const CircuitTask& task) { return std::min(kSlowestHome, 0.8 * task.speed); }

// Returns the squared speed after rising by `rise` m over `length` m of track.
double square_speed(const CircuitTask& task, double rise, double length);

// Returns the lowest height of the curve between the leads, m.
double lowest_of(const Heights& heights);

// Returns what is felt on the curve between the leads, from `steps` positions on it; nothing if the train would be
// slower than slowest(). Lateral g is that of rolling with the bank. About 5 us for 48 steps.
std::optional<FeltRange> estimate(const CircuitTask& task, const CircuitWay& way, int steps);

// Returns positions of the rails about `step` m apart, with their up, for a first check of clearance: accurate to 5 cm.
struct WayPlace {
  double s;  // m
  glm::dvec3 rails, up;
};
std::vector<WayPlace> rough_line(const CircuitTask& task, const CircuitWay& way, double step);

// Returns the ideal curve. Its up is the felt direction, so lateral g is 0 on the curve itself; the roll of both ends,
// with its rate and the slope of that, fades into it (circuit_fade.h). Its last point is exactly `task.home`.
ElementCurve way_curve(const CircuitTask& task, const CircuitWay& way);
// Returns what riders feel on it, without the lateral g caused by the roll of both ends.
FeltRange felt_on(const CircuitTask& task, const ElementCurve& curve);

}  // namespace coaster::sim
