#include "curve/evaluators_vector.h"

#include "base/check.h"
#include "curve/kernels.h"

namespace coaster::curve::detail {
namespace {

using Points = std::span<glm::vec3>;

// The derivative as a cubic whose last coefficient is 0, so that tangents go the same way as points. Its p3 is B'(1).
PreparedCubic derivative_of(const PreparedCubic& c) {
  PreparedCubic d;
  d.cubic.p3 = 3.0f * (c.cubic.p3 - c.cubic.p2);
  d.monomial = {c.monomial.c1, 2.0f * c.monomial.c2, 3.0f * c.monomial.c3, glm::vec3(0)};
  return d;
}

void by(VectorMethod method, const PreparedCubic& curve, Points points, Points tangents) {
  COASTER_CHECK(tangents.empty() || tangents.size() == points.size(), "as many tangents as points, or none");
  vector_polyline(method, curve, points);
  points.front() = curve.cubic.p0;
  if (!tangents.empty()) vector_polyline(method, derivative_of(curve), tangents);
}

}  // namespace

void horner8(const PreparedCubic& curve, Points points, Points tangents) {
  by(VectorMethod::horner, curve, points, tangents);
}
void forward_differences8(const PreparedCubic& curve, Points points, Points tangents) {
  by(VectorMethod::differences, curve, points, tangents);
}

}  // namespace coaster::curve::detail
