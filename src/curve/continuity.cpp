#include "curve/continuity.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/portable_math.h"
#include "curve/frames.h"

namespace coaster::curve {
using glm::dvec3;
namespace {

// Returns the largest angle by which adding a vector of length `by` can turn one of that length, radians; 0 for no
// length, which has no direction to turn.
double turn_by(double by, double length) {
  if (!(length > 0.0)) return 0.0;
  return by < length ? base::arc_tangent(by, std::sqrt(length * length - by * by)) : base::kPi;
}

// Returns the error along each axis of a handle and its knot.
dvec3 rounding_error(glm::vec3 a, glm::vec3 b) {
  const glm::vec3 size = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::vec3(glm::length(b - a)));
  const auto ulp = [](float x) {
    return double{std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + 1)} - double{x};
  };
  const double level = ulp(std::max(size.x, size.z));
  return {level, ulp(size.y), level};
}

}  // namespace

double rounding_error(const Cubic& c) {
  return std::max(glm::length(rounding_error(c.p0, c.p1)), glm::length(rounding_error(c.p2, c.p3)));
}

double rounding_curvature(const Cubic& c, double t) {
  const dvec3 d = derivative(c, t), dd = second_derivative(c, t);
  const double e = rounding_error(c), speed = glm::length(d), least = speed - 6.0 * e, u = 1.0 - t;
  if (!(least > 0.0)) return std::numeric_limits<double>::infinity();
  const dvec3 tangent = d / speed;
  const double along = glm::dot(tangent, dd), bend = glm::length(dd - along * tangent);
  const auto across = [&](dvec3 error) {
    double most = 0;
    for (const dvec3 corner : {error, error * dvec3(-1, 1, 1), error * dvec3(1, -1, 1), error * dvec3(1, 1, -1)})
      most = std::max(most, glm::length(corner - glm::dot(corner, tangent) * tangent));
    return most;
  };
  const double first[] = {-3 * u * u, 3 * u * (u - 2 * t), 3 * t * (2 * u - t), 3 * t * t},
               second[] = {6 * u, 6 * (t - 2 * u), 6 * (u - 2 * t), 6 * t};  // weights in B' and B''
  double weight[4];
  for (int i = 0; i < 4; ++i) weight[i] = second[i] - first[i] * along / least;
  const auto effect = [&](glm::vec3 knot, glm::vec3 handle, double w, double w_handle) {
    return across(rounding_error(knot, handle)) *
           (std::max(std::abs(w), std::abs(w + w_handle)) + 0.5 * std::abs(w_handle));
  };
  const double sum = effect(c.p0, c.p1, weight[0], weight[1]) + effect(c.p3, c.p2, weight[3], weight[2]);
  return (sum + 12.0 * e * bend / least) / (least * least);
}

dvec3 curvature_vector(const Cubic& cubic, double t) {
  const dvec3 d = derivative(cubic, t), dd = second_derivative(cubic, t);
  const double squared = glm::dot(d, d);
  if (!(squared > 1e-18)) return dvec3(0);
  return (dd - d * (glm::dot(dd, d) / squared)) / squared;
}

double largest_jump(dvec3 before, dvec3 after, double rounding) {
  return std::max(1e-3 * std::max(glm::length(before), glm::length(after)), rounding);
}

JointContinuity joint(const Cubic& before, const Cubic& after) {
  JointContinuity j{};
  j.gap = glm::length(dvec3(before.p3) - dvec3(after.p0));
  j.angle = angle_between(unit_tangent(before, 1.0), unit_tangent(after, 0.0));
  const dvec3 d0 = derivative(before, 1.0), d1 = derivative(after, 0.0);
  const double v0 = glm::length(d0), v1 = glm::length(d1);
  j.speed_ratio = v0 > 0 ? v1 / v0 : 0.0;
  j.curvature_before = curvature_vector(before, 1.0);
  j.curvature_after = curvature_vector(after, 0.0);
  j.curvature_jump = glm::length(j.curvature_after - j.curvature_before);
  const dvec3 dd0 = second_derivative(before, 1.0), dd1 = second_derivative(after, 0.0);
  j.second_jump = glm::length(dd1 - dd0);

  j.geometric = GeometricContinuity::broken;
  j.parametric = ParametricContinuity::broken;
  if (j.gap > 0.0) return j;
  j.geometric = GeometricContinuity::g0;
  j.parametric = ParametricContinuity::c0;
  const double e0 = rounding_error(before), e1 = rounding_error(after);
  if (!(j.angle < 1e-3) && !(j.angle <= turn_by(6.0 * e0, v0) + turn_by(6.0 * e1, v1))) return j;
  const double rounding = rounding_curvature(before, 1.0) + rounding_curvature(after, 0.0);
  const bool g2 = j.curvature_jump <= largest_jump(j.curvature_before, j.curvature_after, rounding);
  j.geometric = g2 ? GeometricContinuity::g2 : GeometricContinuity::g1;
  if (std::abs(j.speed_ratio - 1.0) < 1e-4 || std::abs(v1 - v0) <= 6.0 * (e0 + e1)) {
    const double size = std::max({glm::length(dd0), glm::length(dd1), v0});
    j.parametric =
        j.second_jump < std::max(1e-3 * size, 24.0 * (e0 + e1)) ? ParametricContinuity::c2 : ParametricContinuity::c1;
  }
  return j;
}

}  // namespace coaster::curve
