// Rotation-minimising frames of many segments at once.
#pragma once

#include <span>

#include "curve/frames.h"
#include "curve/kernels.h"

namespace coaster::curve {

// Carries `up` along each of ups.size() / count independent chains of `count` >= 1 places, one chain after the other:
// ups[c * count] is given (unit, perpendicular to the first tangent), the others are written, as
//   transport({tangents[i - 1], ups[i - 1]}, points[i - 1], points[i], tangents[i]).up
// gives them, bit by bit, on every processor. `points` in m, `tangents` unit; all three spans have the same size, a
// multiple of `count`. Eight chains go side by side; a chain that meets a place where points coincide, a tangent
// already fits or up turns parallel is done by transport() itself.
void transport_chains(int count, std::span<const glm::dvec3> points, std::span<const glm::dvec3> tangents,
                      std::span<glm::dvec3> ups, Processor on = best_processor());

}  // namespace coaster::curve
