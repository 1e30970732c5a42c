#include "curve/cubic.h"

#include <algorithm>
#include <array>

#include "curve/polynomial_roots.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

dvec3 lerp(dvec3 a, dvec3 b, double t) { return a + t * (b - a); }

}  // namespace

Coefficients coefficients(const Cubic& c) {
  // Barrett 2012, section 3.3, rearranged to differences of neighbours: they are small, so little is lost to rounding.
  const glm::vec3 d0 = c.p1 - c.p0, d1 = c.p2 - c.p1, d2 = c.p3 - c.p2;
  return {c.p0, 3.0f * d0, 3.0f * (d1 - d0), (d2 - d1) - (d1 - d0)};
}

CoefficientsD coefficients_d(const Cubic& cubic) {
  const auto [p0, p1, p2, p3] = controls(cubic);
  const dvec3 d0 = p1 - p0, d1 = p2 - p1, d2 = p3 - p2;
  return {p0, 3.0 * d0, 3.0 * (d1 - d0), (d2 - d1) - (d1 - d0)};
}

PreparedCubic prepare(const Cubic& cubic) { return {cubic, coefficients(cubic)}; }

glm::dvec3 point(const Cubic& cubic, double t) { return t == 1.0 ? dvec3(cubic.p3) : coefficients_d(cubic).point(t); }

glm::dvec3 derivative(const Cubic& cubic, double t) { return coefficients_d(cubic).derivative(t); }
glm::dvec3 second_derivative(const Cubic& cubic, double t) { return coefficients_d(cubic).second_derivative(t); }
glm::dvec3 third_derivative(const Cubic& cubic) { return 6.0 * coefficients_d(cubic).c3; }

glm::dvec3 point_long_double(const Cubic& cubic, double t) {
  dvec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<long double, 4> p{cubic.p0[axis], cubic.p1[axis], cubic.p2[axis], cubic.p3[axis]};
    out[axis] = static_cast<double>(de_casteljau_in_place<long double, long double>(p, t));
  }
  return out;
}

glm::dvec3 unit_tangent(const Cubic& cubic, double t) {
  const glm::vec3 a = glm::abs(cubic.p1 - cubic.p0), b = glm::abs(cubic.p2 - cubic.p1),
                  c = glm::abs(cubic.p3 - cubic.p2);
  const glm::vec3 most = glm::max(glm::max(a, b), c);
  // An upper bound of `size` below, without its roots.
  const double bound = 2.0 * double{std::max({most.x, most.y, most.z})};
  dvec3 d = derivative(cubic, t);
  if (const double length = glm::length(d); length > 1e-9 * bound) return d / length;
  // Where B' vanishes the direction of travel is that of the first derivative that does not. At the end of the curve it
  // is approached from before t, where an even derivative has the opposite sign.
  const double size = std::max({glm::length(dvec3(cubic.p1 - cubic.p0)), glm::length(dvec3(cubic.p2 - cubic.p1)),
                                glm::length(dvec3(cubic.p3 - cubic.p2))});
  if (!(size > 0.0)) return {1, 0, 0};
  const auto usable = [&](dvec3 v) { return glm::length(v) > 1e-9 * size; };
  if (!usable(d)) d = (t >= 1.0 ? -1.0 : 1.0) * second_derivative(cubic, t);
  if (!usable(d)) d = third_derivative(cubic);
  return usable(d) ? d / glm::length(d) : dvec3(1, 0, 0);
}

double curvature(const Cubic& cubic, double t) {
  const dvec3 d = derivative(cubic, t);
  const double speed = glm::length(d);
  if (!(speed > 1e-12)) return 0.0;
  const double k = glm::length(glm::cross(d, second_derivative(cubic, t))) / (speed * speed * speed);
  return std::isfinite(k) ? k : 0.0;
}

std::optional<double> curvature_if_any(const Cubic& cubic, double t) {
  const double size = std::max({glm::length(dvec3(cubic.p1 - cubic.p0)), glm::length(dvec3(cubic.p2 - cubic.p1)),
                                glm::length(dvec3(cubic.p3 - cubic.p2))});
  if (glm::length(derivative(cubic, t)) > 1e-9 * size) return curvature(cubic, t);
  if (!(size > 0.0)) return std::nullopt;
  // B' at t + d is d B'' + d^2/2 times the third derivative: of a straight if these are parallel, turning back if B''
  // is not 0.
  const dvec3 second = second_derivative(cubic, t), third = third_derivative(cubic);
  if (!(glm::length(second) > 1e-9 * size)) return 0.0;
  const bool at_end = t < 1e-9 || t > 1.0 - 1e-9;
  const bool straight = glm::length(glm::cross(second, third)) <= 1e-12 * glm::length(second) * glm::length(third);
  return at_end && straight ? std::optional(0.0) : std::nullopt;
}

SplitCubic split(const Cubic& cubic, double t) {
  // Barrett 2012, section 3.2: the table of de Casteljau's method contains the control points of both halves.
  const auto [p0, p1, p2, p3] = controls(cubic);
  const dvec3 a = lerp(p0, p1, t), b = lerp(p1, p2, t), d = lerp(p2, p3, t);
  const dvec3 e = lerp(a, b, t), f = lerp(b, d, t);
  const glm::vec3 middle(lerp(e, f, t));
  return {{cubic.p0, glm::vec3(a), glm::vec3(e), middle}, {middle, glm::vec3(f), glm::vec3(d), cubic.p3}};
}

Box control_box(const Cubic& c) {
  return {glm::min(glm::min(c.p0, c.p1), glm::min(c.p2, c.p3)), glm::max(glm::max(c.p0, c.p1), glm::max(c.p2, c.p3))};
}

NearestPoint nearest_point(const Cubic& cubic, glm::dvec3 target) {
  const CoefficientsD c = coefficients_d(cubic);
  const auto squared = [&](double t) {
    const dvec3 d = (t == 1.0 ? dvec3(cubic.p3) : c.point(t)) - target;
    return glm::dot(d, d);
  };
  NearestPoint best{0, squared(0)};
  const auto look = [&](double t) {
    if (const double s = squared(t); s < best.distance) best = {t, s};
  };
  const auto points = controls(cubic);
  const std::array from{points[0] - target, points[1] - target, points[2] - target, points[3] - target};
  const std::array legs{points[1] - points[0], points[2] - points[1], points[3] - points[2]};
  const auto slope = product(from, legs);  // (B - target) . B' / 3, which rises through a minimum
  each_rise(slope, [&](const Bracket& at) { look(refined_root(slope, at, true)); });
  look(1);
  return {best.t, std::sqrt(best.distance)};
}

}  // namespace coaster::curve
