#include "curve/cubic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/tries.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace cubic_test {

bool finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

TEST(cubic, points_agree_with_the_bernstein_form_in_long_double) {
  for (const Cubic& c : random_cubics(200, 1))
    for (double t : {0.0, 0.1, 0.377, 0.5, 0.9, 1.0})
      EXPECT_LT(glm::length(point(c, t) - point_long_double(c, t)), 1e-12);
}

TEST(cubic, derivatives_agree_with_central_differences) {
  for (const Cubic& c : random_cubics(50, 2)) {
    const double t = 0.41, h = 1e-4;
    EXPECT_LT(glm::length(derivative(c, t) - (point(c, t + h) - point(c, t - h)) / (2 * h)), 1e-5);
    EXPECT_LT(glm::length(second_derivative(c, t) - (derivative(c, t + h) - derivative(c, t - h)) / (2 * h)), 1e-5);
    EXPECT_LT(glm::length(third_derivative(c) - (second_derivative(c, t + h) - second_derivative(c, t - h)) / (2 * h)),
              1e-5);
  }
}

TEST(cubic, split_preserves_shape) {
  for (const Cubic& c : random_cubics(200, 3))
    for (double t : {0.03, 0.37, 0.5, 0.91}) {
      const SplitCubic s = split(c, t);
      EXPECT_EQ(s.left.p0, c.p0);
      EXPECT_EQ(s.right.p3, c.p3);
      EXPECT_EQ(s.left.p3, s.right.p0);
      for (double u : {0.0, 0.25, 0.6, 1.0}) {
        // Coordinates reach 250 m, where half an ulp of float is 8e-6 m.
        EXPECT_LT(glm::length(point(s.left, u) - point(c, t * u)), 3e-5);
        EXPECT_LT(glm::length(point(s.right, u) - point(c, t + (1 - t) * u)), 3e-5);
      }
    }
}

TEST(cubic, curvature_of_a_near_circle_is_one_over_its_radius) {
  const float r = 7.5f, k = 0.5522847f * r;  // the usual approximation, 2.7e-4 of the radius off
  const Cubic quarter{{r, 3, 0}, {r, 3, k}, {k, 3, r}, {0, 3, r}};
  for (double t : {0.1, 0.3, 0.5, 0.8}) EXPECT_NEAR(curvature(quarter, t) * r, 1.0, 0.03);
}

TEST(cubic, the_unit_tangent_is_unit_and_finite_on_degenerate_curves) {
  for (const Cubic& c : degenerate_cubics())
    for (double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      EXPECT_TRUE(finite(unit_tangent(c, t)));
      EXPECT_NEAR(glm::length(unit_tangent(c, t)), 1.0, 1e-12);
      EXPECT_TRUE(std::isfinite(curvature(c, t)));
    }
}

TEST(cubic, the_tangent_at_a_handle_on_its_anchor_is_the_direction_of_departure) {
  const Cubic start{{1, 2, 3}, {1, 2, 3}, {1, 9, 3}, {5, 9, 3}};
  EXPECT_LT(glm::length(unit_tangent(start, 0) - glm::dvec3(0, 1, 0)), 1e-12);
  const Cubic end{{1, 2, 3}, {1, 9, 3}, {5, 9, 3}, {5, 9, 3}};
  EXPECT_LT(glm::length(unit_tangent(end, 1) - glm::dvec3(1, 0, 0)), 1e-12);
}

TEST(cubic, the_control_box_contains_the_curve) {
  for (const Cubic& c : random_cubics(100, 5)) {
    const Box box = control_box(c);
    for (int i = 0; i <= 20; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(point(c, i / 20.0)[axis], box.low[axis] - 1e-9);
        EXPECT_LE(point(c, i / 20.0)[axis], box.high[axis] + 1e-9);
      }
  }
}

TEST(cubic, the_nearest_point_beats_a_dense_search) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> off(-15, 15);
  auto cubics = random_cubics(60, 6);
  for (const Cubic& c : degenerate_cubics()) cubics.push_back(c);
  for (const Cubic& c : cubics) {
    const glm::dvec3 target = point(c, 0.37) + glm::dvec3{off(random), off(random), off(random)};
    const NearestPoint found = nearest_point(c, target);
    double best = 1e300;
    for (int i = 0; i <= 4000; ++i) best = std::min(best, glm::length(point(c, i / 4000.0) - target));
    EXPECT_LE(found.distance, best + 1e-9);
    EXPECT_NEAR(glm::length(point(c, found.t) - target), found.distance, 1e-9);
  }
}

// Brute force: samples, and a golden-section search about each that is nearer than its neighbours.
double searched_distance(const Cubic& c, glm::dvec3 target) {
  constexpr int kSamples = 128;
  const CoefficientsD k = coefficients_d(c);
  const auto squared = [&](double t) {
    const glm::dvec3 d = k.point(t) - target;
    return glm::dot(d, d);
  };
  double sampled[kSamples + 1], best = 1e300;
  for (int i = 0; i <= kSamples; ++i) best = std::min(best, sampled[i] = squared(double(i) / kSamples));
  const double near = std::sqrt(best) + 1.7;  // m: 3 max|p_i+1 - p_i| / 128 at most
  for (int i = 0; i <= kSamples; ++i) {
    if (sampled[i] > near * near) continue;
    if ((i > 0 && sampled[i - 1] < sampled[i]) || (i < kSamples && sampled[i + 1] < sampled[i])) continue;
    double low = std::max(0, i - 1) / double(kSamples), high = std::min(kSamples, i + 1) / double(kSamples);
    while (high - low > 1e-8) {
      const double a = low + 0.381966 * (high - low), b = high - 0.381966 * (high - low);
      if (squared(a) < squared(b)) high = b;
      else low = a;
    }
    best = std::min(best, squared(0.5 * (low + high)));
  }
  return std::sqrt(best);
}

// A scan of 32 intervals misses the nearest of several minima for one cubic in a thousand.
TEST(cubic, the_nearest_point_is_the_least_of_all_minima) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> place(-20, 20);
  const auto anywhere = [&] { return glm::vec3{place(random), place(random), place(random)}; };
  for (int i = 0, count = test::tries(100'000); i < count; ++i) {
    const glm::vec3 a = anywhere(), b = anywhere(), d = anywhere(), e = anywhere();
    const glm::dvec3 target(anywhere());
    const Cubic c{a, b, d, e};
    const NearestPoint found = nearest_point(c, target);
    ASSERT_LE(found.distance, searched_distance(c, target) + 1e-9) << i;
    ASSERT_NEAR(glm::length(point(c, found.t) - target), found.distance, 1e-12) << i;
  }
}

}  // namespace cubic_test
}  // namespace coaster::curve
