// The evaluators that use the vector kernels (kernels.h), with the best instructions of the processor.
#pragma once

#include <span>

#include "curve/cubic.h"

namespace coaster::curve::detail {

void horner8(const PreparedCubic& curve, std::span<glm::vec3> points, std::span<glm::vec3> tangents);
void forward_differences8(const PreparedCubic& curve, std::span<glm::vec3> points, std::span<glm::vec3> tangents);

}  // namespace coaster::curve::detail
