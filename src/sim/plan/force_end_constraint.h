// Keeps the end of a force section in place: adds to its keys as little as leads there. Sequential linear least squares
// start from the keys alone, or from a bridge, a simple curve to the end, where the keys lead too far from it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/plan/force_path.h"

namespace coaster::sim {

// A simple curve from where a force section begins to where it must end, and what program leads along it.
struct ForceBridge {
  double length = 0;  // m or s
  // By channel, at equal distances from the start to the end: what the curve has there less what the keys ask for.
  std::vector<std::array<double, 3>> more;
};

// Returns the quintic Hermite curve between the task's ends, of which `held` is set: with their places, directions and
// bends, and a cubic roll with their up and spin. Nothing where the train is too slow on it, or
// the ends are in one place or opposite.
std::optional<ForceBridge> force_bridge(const ForceTask& task, std::size_t parts);

// What counts as much as 1 g in the sum of squares: degrees per metre of roll.
inline constexpr double kRollPerG = 10;

// Returns the task, of which `held` is set, with what is added so that its path ends there: within 0.01 mm and 1
// microradian, by keys at equal distances for which the sum over them of vertical^2 + lateral^2 + (roll/kRollPerG)^2 is
// least; curvature counts in units of kCurvaturePerG. The length is free. Nothing where no such path is found, neither
// from the one without additions nor from a bridge. The same bits everywhere. Takes some 0.025 ms
// per metre, a few times that where the end is far off.
std::optional<ForceTask> hold_end(const ForceTask& task);

}  // namespace coaster::sim
