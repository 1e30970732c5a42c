// The elements of the palette that are made of forces: each a program of few keys at the open end, to be edited then.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/plan/force_law.h"
#include "world/components.h"
#include "world/element.h"

namespace coaster::sim {

struct ForceElement {
  std::string refusal;             // why there is none; empty if there is one
  std::vector<std::string> lines;  // what is less than asked for
  world::ForceProgram program;
  std::optional<world::Equipment> equipment;  // of all of it
};

// Returns the program of an element of forces (world::is_of_forces) whose values are within their limits. `start` has
// the open end, the train, and in its program the speed; `behind`: m from the train's first car to its last. Keys are
// symmetric in time where they can be. Where the track has to end level, or at an angle, the one or two durations that
// decide it are found by trial of the whole program. Takes some 10 ms; the same bits everywhere.
ForceElement force_element(const world::Element& element, const ForceTask& start, double behind);

}  // namespace coaster::sim
