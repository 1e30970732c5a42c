// A simple curve from where a force section begins to where it must end, and what program leads along it: from there
// force_hold.h finds additions where the path of the keys alone is too far from the end.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/plan/force_law.h"

namespace coaster::sim {

struct ForceBridge {
  double length = 0;  // m or s
  // By channel, at equal distances from the start to the end: what the curve has there less what the keys ask for.
  std::vector<std::array<double, 3>> more;
};

// Returns the quintic Hermite curve between the task's ends, of which `held` is set: with their places, directions and
// bends, and a cubic roll with their up and spin. Nothing where the train is too slow on it, or
// the ends are in one place or opposite.
std::optional<ForceBridge> force_bridge(const ForceTask& task, std::size_t parts);

}  // namespace coaster::sim
