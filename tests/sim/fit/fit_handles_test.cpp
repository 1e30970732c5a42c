// Tests the handles of a span (sim/fit/sample_span_fit.h).
#include "sim/fit/sample_span_fit.h"

#include <random>

#include <gtest/gtest.h>

namespace coaster::sim {
namespace fit_handles_test {

using glm::dvec3;

const SpanEnds kEnds{{1, 5, 2}, glm::normalize(dvec3(1, 0.2, 0.1)), {9, 6, 5}, glm::normalize(dvec3(0.5, 0.1, 1))};

TEST(fit_handles, a_curve_starts_and_ends_along_its_handles) {
  const curve::CoefficientsD c = curve_of(kEnds, {2.5, 4});
  EXPECT_LT(glm::distance(c.point(0), kEnds.p0), 1e-14);
  EXPECT_LT(glm::distance(c.point(1), kEnds.p3), 1e-14);
  EXPECT_LT(glm::distance(c.derivative(0), 7.5 * kEnds.t0), 1e-14);
  EXPECT_LT(glm::distance(c.derivative(1), 12.0 * kEnds.t3), 1e-13);
  // The curvature at an end is 2/3 of the far handle's end off the tangent, over the square of the near handle.
  const dvec3 far = kEnds.p3 - 4.0 * kEnds.t3 - kEnds.p0, off = far - glm::dot(far, kEnds.t0) * kEnds.t0;
  EXPECT_LT(glm::distance(bend_of(c, 0), 2.0 / 3 * off / (2.5 * 2.5)), 1e-13);
}

TEST(fit_handles, nearer_finds_the_nearest_place_of_a_curve) {
  const curve::CoefficientsD c = curve_of(kEnds, {2.5, 4});
  std::mt19937 bits(3);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  for (int run = 0; run < 50; ++run) {
    const double t = uniform(-0.1, 1.1);
    const dvec3 target = c.point(t) + dvec3(uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(-0.3, 0.3));
    double best = 1e9;
    for (int k = 0; k <= 20000; ++k) best = std::min(best, glm::distance(c.point(k / 20000.0), target));
    const double found = nearer(c, target, std::clamp(t, 0.0, 1.0), 12);
    EXPECT_NEAR(glm::distance(c.point(found), target), best, 1e-6) << run;
  }
}

}  // namespace fit_handles_test
}  // namespace coaster::sim
