// Rounding errors of a polyline: each vertex against the exact point at the same t. A picture magnifies them, a plot
// shows their size: src/sim/study/evaluator_benchmark.
#include "sim/study/evaluator_benchmark.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/enum_names.h"

namespace coaster::sim {
namespace vertex_rounding_test {

const curve::Evaluator& row(const char* name) { return base::row_of(*base::value_named<curve::EvaluatorId>(name)); }

const curve::PreparedCubic kCurve = curve::prepare(
    {{103.37f, 17.91f, -251.3f}, {109.13f, 23.7f, -247.9f}, {118.71f, 19.3f, -239.1f}, {121.9f, 11.7f, -233.3f}});

// Horner in long double: not the arithmetic of the oracle.
glm::dvec3 exact(const curve::Cubic& c, long double t) {
  glm::dvec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    const long double p0 = c.p0[axis], p1 = c.p1[axis], p2 = c.p2[axis], p3 = c.p3[axis];
    out[axis] =
        static_cast<double>(p0 + t * (3 * (p1 - p0) + t * (3 * (p0 - 2 * p1 + p2) + t * (p3 - p0 + 3 * (p1 - p2)))));
  }
  return out;
}

TEST(rounding, vertex_is_exact_plus_error) {
  for (const curve::Evaluator& evaluator : curve::evaluators()) {
    const Rounding r = rounding(kCurve, evaluator, 97);
    std::vector<glm::vec3> points(98);
    evaluator.polyline(kCurve, points, {});
    ASSERT_EQ(r.error.size(), 98u);
    ASSERT_EQ(r.exact.size(), 98u);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT(glm::length(r.exact[i] - exact(kCurve.cubic, static_cast<long double>(i) / 97)), 2e-13)
          << evaluator.name << ' ' << i;
      EXPECT_LT(glm::length(r.exact[i] + r.error[i] - glm::dvec3(points[i])), 1e-13) << evaluator.name << ' ' << i;
    }
  }
}

TEST(rounding, ends_are_exact_and_what_has_gathered_opens_as_a_seam) {
  for (const int steps : {1, 2, 64, 4096}) {
    const Rounding r = rounding(kCurve, row("forward_differences"), steps);
    EXPECT_EQ(r.error.front(), glm::dvec3(0));
    EXPECT_EQ(r.error.back(), glm::dvec3(0));
    EXPECT_EQ(seam(r), steps == 1 ? 0.0 : glm::length(r.error[static_cast<std::size_t>(steps) - 1]));
    EXPECT_LE(seam(r), largest(r));
  }
  EXPECT_GT(seam(rounding(kCurve, row("forward_differences"), 4096)), 20 * seam(rounding(kCurve, row("horner"), 4096)));
}

TEST(rounding, stays_within_the_rows_bound) {
  const curve::Cubic& c = kCurve.cubic;
  const double extent = std::max({glm::length(c.p0), glm::length(c.p1), glm::length(c.p2), glm::length(c.p3)});
  const double size = glm::length(c.p1 - c.p0) + glm::length(c.p2 - c.p1) + glm::length(c.p3 - c.p2);
  for (const curve::Evaluator& evaluator : curve::evaluators())
    for (const int steps : {1, 7, 256, 4096})
      EXPECT_LE(largest(rounding(kCurve, evaluator, steps)), evaluator.error_bound(extent, size, steps))
          << evaluator.name;
}

TEST(error_profile, is_the_size_of_the_error_in_millimetres) {
  const Rounding r = rounding(kCurve, row("bernstein"), 300);
  const std::vector<ErrorSample> profile = error_profile(kCurve, row("bernstein"), 300);
  ASSERT_EQ(profile.size(), 301u);
  double most = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    EXPECT_EQ(profile[i].t, static_cast<double>(i) / 300);
    most = std::max(most, profile[i].mm);
  }
  EXPECT_DOUBLE_EQ(most, 1000 * largest(r));
  EXPECT_EQ(profile.front().mm, 0);
  EXPECT_EQ(profile.back().mm, 0);
}

TEST(rounding, of_a_point_is_nothing) {
  const Rounding r =
      rounding(curve::prepare({glm::vec3(7.3f), glm::vec3(7.3f), glm::vec3(7.3f), glm::vec3(7.3f)}), row("horner"), 8);
  EXPECT_LT(largest(r), 1e-5);
}

}  // namespace vertex_rounding_test
}  // namespace coaster::sim
