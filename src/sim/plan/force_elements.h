// The palette's elements made of forces: each is a program of few keys at the open end, for further editing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/plan/force_path.h"
#include "world/components.h"
#include "world/element.h"

namespace coaster::sim {

struct ForceElement {
  std::string refusal;             // why there is none; empty if there is one
  std::vector<std::string> lines;  // values that were reduced
  world::ForceProgram program;
  std::optional<world::Equipment> equipment;  // of the whole element
};

// Returns the program of a force element (world::is_of_forces) whose values are within their limits. `start` has the
// open end, the train, and in its program the speed; `behind`: m from the train's first car to its last. Keys are
// symmetric in time where possible. If the track must end level, or at an angle, trials of the whole program find the
// one or two durations that decide it. Takes some 10 ms; the same bits everywhere.
ForceElement force_element(const world::Element& element, const ForceTask& start, double behind);

}  // namespace coaster::sim
