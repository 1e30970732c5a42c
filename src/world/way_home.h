// A way home as plain data, from which a section that completes a circuit is planned again.
#pragma once

#include "world/fields.h"

namespace coaster::world {

inline constexpr double kMostTurned_deg = 720, kWidestTurn = 10'000, kLongestStraight = 1'000;  // deg, m, m
inline constexpr double kHighestWay = 200'000, kFastestPlanned = 10'000;                        // m, m/s

// Straight, turn, straight, turn, straight in plan, with the heights and the speed of the plan.
struct WayHome {
  double first = 0, second = 0;  // deg, of the two turns; positive to the right
  double radius = 1;             // m, of both
  double before = 0, after = 0;  // m, of the straights before the first and after the second turn
  bool level = false;            // it has a level part; false: one constant slope
  double height = 0;             // m, of the level part; 0 without one
  bool tight = false;            // with the smaller radii of crests and valleys
  double speed = 10;             // m/s, at the start
  bool coasts = true;            // the speed follows from the energy; false: it is constant
  static constexpr void fields(auto visit) {
    visit(Field{"first", -kMostTurned_deg, kMostTurned_deg}, &WayHome::first);
    visit(Field{"second", -kMostTurned_deg, kMostTurned_deg}, &WayHome::second);
    visit(Field{"radius", 1, kWidestTurn}, &WayHome::radius);
    visit(Field{"before", 0, kLongestStraight}, &WayHome::before);
    visit(Field{"after", 0, kLongestStraight}, &WayHome::after);
    visit(Field{"level"}, &WayHome::level);
    visit(Field{"height", -kHighestWay, kHighestWay}, &WayHome::height);
    visit(Field{"tight"}, &WayHome::tight);
    visit(Field{"speed", 0, kFastestPlanned}, &WayHome::speed);
    visit(Field{"coasts"}, &WayHome::coasts);
  }
  friend bool operator==(const WayHome&, const WayHome&) = default;
};

}  // namespace coaster::world
