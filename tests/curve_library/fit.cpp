// Fits cubics to an ideal path: a helix of 10 m radius that rises by 12 m a turn, or does not rise. Joints are G2, and
// the error falls with a high power of the spans' length.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <coaster/curve/continuity.h>
#include <coaster/curve/span_fit.h>

namespace curve = coaster::curve;

constexpr double kPi = 3.14159265358979323846, kRadius = 10;

// The path over one turn, by the angle in radians. `rise` is in m a radian.
curve::PathPoint path(double angle, double rise) {
  const double c = std::cos(angle), s = std::sin(angle), rate = std::sqrt(kRadius * kRadius + rise * rise);
  return {rate * angle,
          {kRadius * c, rise * angle, -kRadius * s},
          glm::dvec3(-kRadius * s, rise, -kRadius * c) / rate,
          glm::dvec3(-c, 0, s) * (kRadius / (rate * rate))};
}

void fit(const char* name, double rise, int spans) {
  std::vector<curve::PathPoint> points;
  for (int k = 0; k <= spans; ++k) points.push_back(path(2 * kPi * k / spans, rise));
  curve::SpanKnots nodes = curve::span_nodes(points);
  for (int step = 0; step < 8 && curve::turn_tangents(nodes) > 1e-11;) ++step;

  // The largest distance of the path from the span beside it, and the largest jump of curvature at a joint.
  double error = 0, jump = 0;
  int joints = 0;
  for (int k = 0; k < spans; ++k) {
    const curve::Cubic cubic = curve::span_cubic(nodes, k);
    for (int i = 0; i <= 20; ++i)
      error =
          std::max(error, curve::nearest_point(cubic, path(2 * kPi * (k + i / 20.0) / spans, rise).position).distance);
    if (k == 0) continue;
    const curve::JointContinuity joint = curve::joint(curve::span_cubic(nodes, k - 1), cubic);
    jump = std::max(jump, joint.curvature_jump);
    joints += joint.geometric == curve::GeometricContinuity::g2;
  }
  std::printf("%s %d %.6e %.6e %d %.12f\n", name, spans, error, jump, joints, nodes.out[0]);
}

int main() {
  for (const int spans : {4, 8}) fit("circle", 0, spans);
  for (const int spans : {6, 12}) fit("helix", 12 / (2 * kPi), spans);
}
