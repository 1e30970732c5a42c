// A force section of which both ends must stay: what must be added to the forces of its keys so that it ends in a given
// place, direction, bend, roll and spin, as little as possible. docs/forces.md has the method.
#pragma once

#include <optional>

#include "sim/plan/force_law.h"

namespace coaster::sim {

// What counts as much as 1 g in the sum of squares: degrees per metre of roll.
inline constexpr double kRollPerG = 10;

// Returns the task, of which `held` is set, with what is added so that its path ends there: within 0.01 mm and 1
// microradian, by keys at equal distances for which the sum over them of vertical^2 + lateral^2 + (roll/kRollPerG)^2 is
// least; curvature counts in units of kCurvaturePerG. The length is free. Nothing where no such path is found, neither
// from the one without additions nor from a bridge (force_bridge.h). The same bits everywhere. Takes some 0.025 ms
// per metre, a few times that where the end is far off.
std::optional<ForceTask> hold_end(const ForceTask& task);

}  // namespace coaster::sim
