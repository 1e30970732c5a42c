#include "curve/frames.h"

#include <cmath>

#include "base/portable_math.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

// Unit, and exactly perpendicular to rounding; `up` must not be parallel to `forward`.
Frame orthonormal(dvec3 forward, dvec3 up) { return {forward, perpendicular(forward, up)}; }

}  // namespace

std::optional<FrenetFrame> frenet(const Cubic& cubic, double t) {
  const dvec3 d = derivative(cubic, t), dd = second_derivative(cubic, t);
  const double speed = glm::length(d);
  if (!(speed > 1e-9)) return std::nullopt;
  const dvec3 binormal = glm::cross(d, dd);
  const double size = glm::length(binormal), k = size / (speed * speed * speed);
  // Paper erratum: where the curvature is 0 there is no normal; it flips across an inflection.
  if (!(k > 1e-9)) return std::nullopt;
  const dvec3 tangent = d / speed, b = binormal / size;
  const double torsion = glm::dot(binormal, third_derivative(cubic)) / (size * size);
  return FrenetFrame{tangent, glm::cross(b, tangent), b, k, torsion};
}

Frame transport(const Frame& from, dvec3 x0, dvec3 x1, dvec3 t1) {
  // Wang et al. 2008: reflect in the plane between the points, then in the plane between the tangents.
  const dvec3 v1 = x1 - x0;
  const double c1 = glm::dot(v1, v1);
  if (!(c1 > 1e-24)) return orthonormal(t1, least_rotation(from.forward, t1, from.up, from.up));
  const dvec3 up = from.up - (2.0 / c1) * glm::dot(v1, from.up) * v1;
  const dvec3 forward = from.forward - (2.0 / c1) * glm::dot(v1, from.forward) * v1;
  const dvec3 v2 = t1 - forward;
  const double c2 = glm::dot(v2, v2);
  if (!(c2 > 1e-24)) return orthonormal(t1, up);
  return orthonormal(t1, up - (2.0 / c2) * glm::dot(v2, up) * v2);
}

dvec3 least_rotation(dvec3 from, dvec3 to, dvec3 v, dvec3 axis) {
  const double c = glm::dot(from, to);
  if (c < -1.0 + 1e-12) return 2.0 * glm::dot(axis, v) * axis - v;  // the half turn about `axis`
  const dvec3 w = glm::cross(from, to);
  // Rodrigues' formula with sin = |w| and 1 - cos = |w|^2 / (1 + cos).
  return c * v + glm::cross(w, v) + (glm::dot(w, v) / (1.0 + c)) * w;
}

dvec3 rotate(dvec3 v, dvec3 axis, double radians) {
  const auto [s, c] = base::sin_cos(radians);
  return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

double signed_angle(dvec3 from, dvec3 to, dvec3 axis) {
  return base::arc_tangent(glm::dot(glm::cross(from, to), axis), glm::dot(from, to));
}

dvec3 perpendicular(dvec3 forward, dvec3 wish) {
  dvec3 up = wish - glm::dot(wish, forward) * forward;
  double length = glm::length(up);
  if (!(length > 1e-9)) {
    // Parallel: the axis least along `forward`, so that the result is well conditioned and depends on it alone.
    const dvec3 a = glm::abs(forward);
    const dvec3 axis = a.x <= a.y && a.x <= a.z ? dvec3(1, 0, 0) : a.y <= a.z ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    up = axis - glm::dot(axis, forward) * forward;
    length = glm::length(up);
  }
  up /= length;
  // Once more, for what the first subtraction left over when `wish` was nearly parallel.
  up -= glm::dot(up, forward) * forward;
  return up / glm::length(up);
}

}  // namespace coaster::curve
