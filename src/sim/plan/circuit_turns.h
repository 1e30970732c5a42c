// Ways home in plan: straight, turn, straight, turn, straight. They are Dubins' paths whose turns have ramps of
// curvature (Bend), so the curvature is continuous.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/plan/element_path.h"

namespace coaster::sim {

struct PlanPose {
  glm::dvec2 place{0};  // m, (x, z)
  double heading = 0;   // rad from +X towards +Z: rises to the right
};

struct Turns {
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
  Turns rough;
};

// Returns every way from one pose to the other with one of these radii and lengths of the outer straights, with up to
// one additional whole turn. Turns are at least `shortest` m long. About 0.1 ms per radius and pair of lengths.
std::vector<TurnChoice> turn_choices(const PlanPose& from, const PlanPose& to, std::span<const double> radii,
                                     std::span<const double> straights, double shortest = Bend::kShortest);
// Returns the turns of a choice, exact to rounding; nothing if the straight between them would be negative.
std::optional<Turns> exact_turns(const PlanPose& from, const PlanPose& to, const TurnChoice& choice);

}  // namespace coaster::sim
