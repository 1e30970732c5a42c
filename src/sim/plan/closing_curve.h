// Closing sections in plan: straight, turn, straight, turn, straight. They are Dubins' paths whose turns have ramps of
// curvature (Bend), so the curvature is continuous; what the open end and the first knot ask of them; and the curve of
// one in space.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "sim/plan/closing_heights.h"
#include "sim/plan/element_path.h"
#include "sim/plan/element_shapes.h"
#include "world/components.h"

namespace coaster::sim {

struct PlanPose {
  glm::dvec2 place{0};  // m, (x, z)
  double heading = 0;   // rad from +X towards +Z: rises to the right
};

struct TurnsInPlan {
  double before = 0, between = 0, after = 0;  // m, of the straights
  Bend first{0, 0, 1}, second{0, 0, 1};       // turns of the heading
  double length() const { return before + first.length() + between + second.length() + after; }
  // Ends of the pieces, and of the parts of each turn: m from the start, ascending.
  std::vector<double> breaks() const;
  struct At {
    double angle, bend;  // rad, heading; 1/m, its derivative
  };
  At at(double u) const;  // u in [0, length()]
};

// A choice of turns; the first turn's angle lies between `low` and `high`.
struct TurnChoice {
  int first = 1, second = 1;                 // 1: to the right, -1: to the left
  int more_first = 0, more_second = 0;       // additional whole turns
  double radius = 1, before = 0, after = 0;  // m
  double shortest = Bend::kShortest;         // m, of a turn
  double low = 0, high = 0;                  // rad
  // The turns, accurate to about a centimetre, from interpolated displacements.
  TurnsInPlan rough;
};

// Returns every way from one pose to the other with one of these radii and lengths of the outer straights, with up to
// one additional whole turn. Turns are at least `shortest` m long. About 0.1 ms per radius and pair of lengths.
std::vector<TurnChoice> turn_choices(const PlanPose& from, const PlanPose& to, std::span<const double> radii,
                                     std::span<const double> straights, double shortest = Bend::kShortest);
// Returns the turns of a choice, exact to rounding; nothing if the straight between them would be negative.
std::optional<TurnsInPlan> exact_turns(const PlanPose& from, const PlanPose& to, const TurnChoice& choice);

inline constexpr double kGentle_deg = 32;

// A piece of curve in its own axes, as ElementPath adds it.
struct LeadPiece {
  glm::dvec3 forward, up, left;
  double length;  // m
  ElementPiece rate;
};

struct CircuitLead {
  std::vector<LeadPiece> pieces;
  PlanPose pose;                 // where the pieces end; for the first knot: where they begin, in the train's direction
  double height = 0, slope = 0;  // m; m per metre in plan
  double length = 0;             // m, along the track
  bool steep = false;            // up follows the pieces instead of the felt direction
};

// Returns the pieces after an end: its curvature falls to 0, then a steep end bends to a gentler slope with that
// radius, m. A vertical end bends towards the riders' heads if it points down, away from them if it points up, so that
// the track becomes upright.
CircuitLead lead_from(const TrackEnd& end, double radius);
// Returns the pieces before the first knot, `home`, whose direction is the train's.
CircuitLead lead_to(TrackEnd home, double radius);

void add_lead(const CircuitLead& lead, ElementPath& path);

// The ends between which a track is to be completed, and the train.
struct CircuitTask {
  TrackEnd from;  // the open end
  TrackEnd home;  // the first knot, in the train's direction, with the curvature and spin of its own segment
  double from_slope = 0, home_slope = 0;  // rad/m^2, of the roll's rate just before `from` and just after `home`
  double speed = 10;                      // m/s at the open end
  bool coasts = true;                     // the speed follows from the energy; false: it is constant
  world::Losses losses;                   // of that train
  double rails = 0, riders = 0;           // m above the curve
  std::optional<double> water = {};       // m, its level on a land, kNoWater if there is none; nothing without a land
  friend bool operator==(const CircuitTask&, const CircuitTask&) = default;
};

// Limits for what riders feel on a closing section: the strictest, for durations over 4 s (docs/ride.md).
inline constexpr double kMostUp = 4.0, kLeastUp = -0.3, kMostSide = 1.2;  // g
// g, lateral, caused by rolling: closing sections with less are preferred.
inline constexpr double kGentleSide = 0.55;
inline constexpr double kSlowestHome = 2;     // m/s, anywhere on it; less for a train that arrives slower
inline constexpr double kSteepestHome = 0.7;  // m per metre in plan, between the bends
// m above the ground, on a land above the water's level, or the lower end's height if that is less.
inline constexpr double kLowestRails = 1;

struct FeltRange {
  double most = 1, least = 1, side = 0;  // g: vertical, and the largest lateral
  bool within() const { return most <= kMostUp && least >= kLeastUp && side <= kMostSide; }
};

struct ClosingCurve {
  CircuitLead in, out;
  TurnsInPlan turns;
  HeightProfile heights;
};

// Returns the height (m) of what closing sections stay above, and its name.
inline double bottom(const CircuitTask& task) { return task.water.value_or(0); }
inline const char* bottom_name(const CircuitTask& task) { return task.water ? "water" : "ground"; }

// Returns the least speed on it, m/s.
inline double slowest(const CircuitTask& task) { return std::min(kSlowestHome, 0.8 * task.speed); }

// Returns the squared speed after rising by `rise` m over `length` m of track.
double square_speed(const CircuitTask& task, double rise, double length);

// Returns the lowest height of the curve between the leads, m.
double lowest_of(const HeightProfile& heights);

// Returns what is felt on the curve between the leads, from `steps` positions on it; nothing if the train would be
// slower than slowest(). Lateral g is that of rolling with the bank. About 5 us for 48 steps.
std::optional<FeltRange> estimate(const CircuitTask& task, const ClosingCurve& closing, int steps);

// Returns positions of the rails about `step` m apart, with their up, for a first check of clearance: accurate to 5 cm.
struct ClosingPlace {
  double s;  // m
  glm::dvec3 rails, up;
};
std::vector<ClosingPlace> rough_line(const CircuitTask& task, const ClosingCurve& closing, double step);

// Returns the ideal curve. Its up is the felt direction, so lateral g is 0 on the curve itself; the roll of both ends,
// with its rate and the slope of that, fades into it (closing_heights.h). Its last point is exactly `task.home`.
ElementCurve ideal_closing(const CircuitTask& task, const ClosingCurve& closing);
// Returns what riders feel on it, without the lateral g caused by the roll of both ends.
FeltRange felt_on(const CircuitTask& task, const ElementCurve& curve);

}  // namespace coaster::sim
