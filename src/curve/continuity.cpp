#include "curve/continuity.h"

#include <algorithm>
#include <cmath>

#include "curve/frames.h"

namespace coaster::curve {
using glm::dvec3;

dvec3 curvature_vector(const Cubic& cubic, double t) {
  const dvec3 d = derivative(cubic, t), dd = second_derivative(cubic, t);
  const double squared = glm::dot(d, d);
  if (!(squared > 1e-18)) return dvec3(0);
  return (dd - d * (glm::dot(dd, d) / squared)) / squared;
}

Joint joint(const Cubic& before, const Cubic& after) {
  Joint j{};
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

  j.geometric = Geometric::broken;
  j.parametric = Parametric::broken;
  if (j.gap > 0.0) return j;
  j.geometric = Geometric::g0;
  j.parametric = Parametric::c0;
  if (j.angle < 1e-3) j.geometric = j.curvature_jump < 1e-3 ? Geometric::g2 : Geometric::g1;
  if (j.angle < 1e-3 && std::abs(j.speed_ratio - 1.0) < 1e-4) {
    const double size = std::max({glm::length(dd0), glm::length(dd1), v0});
    j.parametric = j.second_jump < 1e-3 * size ? Parametric::c2 : Parametric::c1;
  }
  return j;
}

}  // namespace coaster::curve
