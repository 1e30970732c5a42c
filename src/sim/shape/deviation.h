// The rounding error of an evaluator.
#pragma once

#include <span>

#include "curve/cubic.h"

namespace coaster::sim {

// Returns the largest distance (m) of a vertex of a polyline from the exact point at the same parameter, which are
// uniform.
double deviation_of(const curve::Cubic& cubic, std::span<const glm::vec3> points);

}  // namespace coaster::sim
