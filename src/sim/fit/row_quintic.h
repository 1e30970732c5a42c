// The curve of degree 5 between two rows.
#pragma once

#include "curve/frames.h"
#include "sim/fit/fit_rows.h"

namespace coaster::sim {

// The curve over `length` m with places, directions and curvatures (1/m) of the rows at both ends; x in [0, 1].
struct RowQuintic {
  glm::dvec3 c[6];  // coefficients of the powers of x
  RowQuintic(const FitRow& a, glm::dvec3 bend_a, const FitRow& b, glm::dvec3 bend_b, double length) {
    c[0] = a.position, c[1] = length * a.forward, c[2] = 0.5 * length * length * bend_a;
    const glm::dvec3 d = b.position - c[0] - c[1] - c[2], v = length * b.forward - c[1] - 2.0 * c[2],
                     w = length * length * bend_b - 2.0 * c[2];
    c[3] = 10.0 * d - 4.0 * v + 0.5 * w, c[4] = -15.0 * d + 7.0 * v - w, c[5] = 6.0 * d - 3.0 * v + 0.5 * w;
  }
  glm::dvec3 point(double x) const { return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))); }
  glm::dvec3 derivative(double x) const {
    return c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * (4.0 * c[4] + x * 5.0 * c[5])));
  }
  glm::dvec3 direction(double x) const { return glm::normalize(derivative(x)); }
  // 1/m, perpendicular to the direction.
  glm::dvec3 curvature(double x) const {
    const glm::dvec3 d = derivative(x);
    return curve::across(2.0 * c[2] + x * (6.0 * c[3] + x * (12.0 * c[4] + x * 20.0 * c[5])), glm::normalize(d)) /
           glm::dot(d, d);
  }
};

}  // namespace coaster::sim
