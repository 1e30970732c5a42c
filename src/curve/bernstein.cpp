#include "curve/bernstein.h"

#include <algorithm>

#include "base/check.h"

namespace coaster::curve {

using glm::dvec3;

double bernstein(int i, int n, double t) {
  COASTER_CHECK(0 <= i && i <= n, "Bernstein's polynomials of degree n are numbered 0 to n");
  std::vector<double> weights(static_cast<std::size_t>(n) + 1);
  bernstein_basis<double>(t, weights);
  return weights[static_cast<std::size_t>(i)];
}

std::array<dvec3, 4> controls(const Cubic& c) { return {dvec3(c.p0), dvec3(c.p1), dvec3(c.p2), dvec3(c.p3)}; }

Construction construction(const Cubic& cubic, double t) {
  const auto points = controls(cubic);
  const std::vector<dvec3> all = de_casteljau_levels<double, dvec3>(points, t);
  return {{all[4], all[5], all[6]}, {all[7], all[8]}, all[9]};
}

std::array<dvec3, 3> hodograph(const Cubic& cubic) {
  const auto points = controls(cubic);
  const std::vector<dvec3> legs = hodograph_controls<double, dvec3>(points);
  return {legs[0], legs[1], legs[2]};
}

std::array<dvec3, 4> as_cubic_controls(std::span<const dvec3> controls) {
  COASTER_CHECK(!controls.empty() && controls.size() <= 4, "a curve of degree 0 to 3");
  std::vector<dvec3> all(controls.begin(), controls.end());
  while (all.size() < 4) all = elevated<double, dvec3>(all);
  return {all[0], all[1], all[2], all[3]};
}

}  // namespace coaster::curve
