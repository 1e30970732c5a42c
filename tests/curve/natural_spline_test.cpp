#include "curve/natural_spline.h"

#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace coaster::curve {
namespace natural_spline_test {

using glm::dvec3;

std::vector<dvec3> random_points(std::size_t n) {
  std::vector<dvec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto coordinate = [] { return *rc::gen::inRange(-1000, 1001) * 0.1; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}
std::vector<double> random_steps(std::size_t n) {
  std::vector<double> steps;
  for (std::size_t i = 0; i < n; ++i) steps.push_back(*rc::gen::inRange(5, 200) * 0.1);
  return steps;
}

// Second derivative of the cubic Hermite piece of length h between p0, m0 and p1, m1 at its start and at its end, by
// the polynomial.
dvec3 second_at_start(dvec3 p0, dvec3 m0, dvec3 p1, dvec3 m1, double h) {
  return (6.0 * (p1 - p0) / h - 4.0 * m0 - 2.0 * m1) / h;
}
dvec3 second_at_end(dvec3 p0, dvec3 m0, dvec3 p1, dvec3 m1, double h) {
  return (-6.0 * (p1 - p0) / h + 2.0 * m0 + 4.0 * m1) / h;
}

void expect_zero(dvec3 v, double scale) { RC_ASSERT(glm::length(v) <= 1e-11 * scale); }

RC_GTEST_PROP(NaturalSpline, second_derivatives_agree_inside_and_vanish_at_free_ends, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(2, 30);
  const std::vector<dvec3> p = random_points(n);
  const std::vector<double> h = random_steps(n - 1);
  const std::vector<dvec3> m = spline_derivatives({p, h, {}, {}, false});
  RC_ASSERT(m.size() == n);
  expect_zero(second_at_start(p[0], m[0], p[1], m[1], h[0]), 1e4);
  expect_zero(second_at_end(p[n - 2], m[n - 2], p[n - 1], m[n - 1], h[n - 2]), 1e4);
  for (std::size_t i = 1; i + 1 < n; ++i)
    expect_zero(
        second_at_end(p[i - 1], m[i - 1], p[i], m[i], h[i - 1]) - second_at_start(p[i], m[i], p[i + 1], m[i + 1], h[i]),
        1e4);
}

RC_GTEST_PROP(NaturalSpline, clamped_ends_keep_their_derivatives, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(2, 20);
  const std::vector<dvec3> p = random_points(n);
  const std::vector<double> h = random_steps(n - 1);
  const dvec3 first(1, 2, 3), last(-4, 5, 6);
  const std::vector<dvec3> m = spline_derivatives({p, h, first, last, false});
  RC_ASSERT(m.front() == first);
  RC_ASSERT(m.back() == last);
  for (std::size_t i = 1; i + 1 < n; ++i)
    expect_zero(
        second_at_end(p[i - 1], m[i - 1], p[i], m[i], h[i - 1]) - second_at_start(p[i], m[i], p[i + 1], m[i + 1], h[i]),
        1e4);
}

RC_GTEST_PROP(NaturalSpline, a_closed_one_is_smooth_all_the_way_round, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(3, 30);
  const std::vector<dvec3> p = random_points(n);
  const std::vector<double> h = random_steps(n);
  const std::vector<dvec3> m = spline_derivatives({p, h, {}, {}, true});
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    expect_zero(second_at_end(p[before], m[before], p[i], m[i], h[before]) -
                    second_at_start(p[i], m[i], p[after], m[after], h[i]),
                1e4);
  }
}

TEST(NaturalSpline, a_straight_line_at_even_steps_stays_one) {
  const std::vector<dvec3> p{{0, 0, 0}, {1, 2, 0}, {2, 4, 0}, {3, 6, 0}};
  for (const dvec3 m : spline_derivatives({p, std::vector<double>(3, 0.5), {}, {}, false}))
    EXPECT_LT(glm::length(m - dvec3(2, 4, 0)), 1e-14);
}

// The system's rows times the solution are its right-hand sides, round the corner too.
TEST(NaturalSpline, tridiagonal_systems_are_solved_open_and_closed) {
  std::mt19937 bits(6);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  for (const std::size_t n : {2u, 3u, 7u, 40u})
    for (const bool closed : {false, true}) {
      std::vector<TridiagonalRow> rows;
      for (std::size_t i = 0; i < n; ++i)
        rows.push_back({uniform(-1, 1), uniform(2.5, 4), uniform(-1, 1), {uniform(-9, 9), uniform(-9, 9), 1}});
      const std::vector<glm::dvec3> x = solve_tridiagonal(rows, closed);
      ASSERT_EQ(x.size(), n);
      for (std::size_t i = 0; i < n; ++i) {
        glm::dvec3 sum = rows[i].middle * x[i];
        if (closed || i > 0) sum += rows[i].below * x[(i + n - 1) % n];
        if (closed || i + 1 < n) sum += rows[i].above * x[(i + 1) % n];
        EXPECT_LT(glm::distance(sum, rows[i].right), 1e-13) << n;
      }
    }
}

}  // namespace natural_spline_test
}  // namespace coaster::curve
