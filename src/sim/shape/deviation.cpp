#include "sim/shape/deviation.h"

#include <algorithm>
#include <cmath>

namespace coaster::sim {

using glm::dvec3;

// Vertices for which the point in double proves a smaller deviation than the largest so far need no exact point.
double deviation_of(const curve::Cubic& cubic, std::span<const glm::vec3> points) {
  const curve::CoefficientsD rounded = curve::coefficients_d(cubic);
  float largest = 1;
  for (const glm::vec3 p : {cubic.p0, cubic.p1, cubic.p2, cubic.p3})
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double rounding = 1e-12 * double{largest};  // m, of a point in double: at least ten times its possible error
  const double last = static_cast<double>(points.size()) - 1;
  double worst = 0, enough = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 vertex(points[i]);
    const double t = static_cast<double>(i) / last;
    const dvec3 near = vertex - rounded.point(t);
    if (glm::dot(near, near) < enough) continue;
    const dvec3 d = vertex - curve::point_long_double(cubic, t);
    worst = std::max(worst, glm::dot(d, d));
    const double nearest = std::max(0.0, std::sqrt(worst) - rounding);
    enough = nearest * nearest;
  }
  return std::sqrt(worst);
}

double chord_error(const curve::Cubic& cubic, int steps) {
  constexpr int kMost = 16;
  const curve::CoefficientsD exact = curve::coefficients_d(cubic);
  const int measured = std::min(steps, kMost);
  double worst = 0;
  for (int i = 0; i < measured; ++i) {
    const int step = measured == 1 ? 0 : i * (steps - 1) / (measured - 1);
    const auto at = [&](double offset) { return exact.point((step + offset) / steps); };
    const dvec3 from = at(0), chord = at(1) - from, off = at(0.5) - from;
    const double square = glm::dot(chord, chord), part = square > 0 ? glm::dot(off, chord) / square : 0;
    worst = std::max(worst, glm::length(off - std::clamp(part, 0.0, 1.0) * chord));
  }
  return worst;
}

double chord_error(const Derived& derived) {
  double worst = 0;
  for (const world::Entity segment : derived.order)
    worst = std::max(worst, chord_error(derived.shape(segment).key.cubic, derived.steps));
  return worst;
}

}  // namespace coaster::sim
