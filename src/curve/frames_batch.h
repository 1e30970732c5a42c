// Rotation-minimising frames of many segments at once.
#pragma once

#include <span>

#include "curve/frames.h"
#include "curve/kernels.h"

namespace coaster::curve {

// Carries `up` along each of ups.size() / count independent chains of `count` >= 1 points, one chain after the other.
// ups[c * count] is given (unit, perpendicular to the first tangent). The others are written with the same bits as
//   transport({tangents[i - 1], ups[i - 1]}, points[i - 1], points[i], tangents[i]).up
// on every processor. `points` in m, `tangents` unit; all three spans have the same size, a multiple of `count`.
// Eight chains run side by side. transport() itself handles a chain where points coincide, a tangent already fits or
// up becomes parallel.
void transport_chains(int count, std::span<const glm::dvec3> points, std::span<const glm::dvec3> tangents,
                      std::span<glm::dvec3> ups, Processor on = best_processor());

}  // namespace coaster::curve
