#include "curve/arc_length_study.h"

#include <gtest/gtest.h>

#include "base/enum_names.h"
#include "curve/length_oracle.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace arc_length_study_test {

TEST(arc_length_study, reference_agrees_with_tanh_sinh_on_every_kind_of_cubic) {
  for (const CubicSet& set : cubic_sets(200, 81))
    for (const Cubic& c : set.cubics) {
      const LengthOracle oracle(c);
      ASSERT_LT(fabsl(reference_length(c) - oracle.length()), 1e-15L * oracle.length()) << set.name;
      ASSERT_LT(fabsl(reference_length(c, 0.125, 0.625) - oracle.length(0.125L, 0.625L)), 1e-15L * oracle.length())
          << set.name;
    }
}

TEST(arc_length_study, every_row_converges_within_the_evaluations_allowed) {
  for (const CubicSet& set : cubic_sets(20, 82))
    for (const Cubic& c : set.cubics) {
      const std::vector<Convergence> all = convergence(c, 512);
      ASSERT_EQ(all.size(), arc_length_methods().size());
      for (const Convergence& one : all) {
        const ArcLengthMethod& row = base::row_of(one.method);
        ASSERT_FALSE(one.points.empty() && row.control != LengthControl::tolerance) << row.name;
        for (std::size_t i = 0; i < one.points.size(); ++i) {
          ASSERT_LE(one.points[i].evaluations, 512) << row.name;
          ASSERT_GE(one.points[i].relative_error, kSmallestError) << row.name;
          if (i > 0) {
            ASSERT_GE(one.points[i].evaluations, one.points[i - 1].evaluations) << row.name;
          }
        }
        if (row.control == LengthControl::count) {
          EXPECT_LT(one.points.back().relative_error, 0.1 * one.points.front().relative_error + 1e-6)
              << row.name << set.name;
        }
      }
    }
}

TEST(arc_length_study, gauss_legendre_needs_fewer_evaluations_than_any_other_row_for_nine_digits) {
  // Over track-like curves; the paper's Riemann and trapezium sums do not get there at all.
  std::vector<std::int64_t> needed(arc_length_methods().size(), 0);
  for (const Cubic& c : random_cubics(40, 83)) {
    const std::vector<Convergence> all = convergence(c, 4096);
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::int64_t first = 100'000;
      for (const ConvergencePoint& p : all[i].points)
        if (p.relative_error < 1e-9) first = std::min(first, p.evaluations);
      needed[i] += first;
    }
  }
  const auto of = [&](std::string_view name) {
    return needed[static_cast<std::size_t>(*base::value_named<curve::ArcLengthId>(name))] / 40;
  };
  EXPECT_LE(of("gauss_legendre_fixed"), 20);
  EXPECT_LE(of("gauss_legendre"), 30);
  EXPECT_GT(of("simpson"), 3 * of("gauss_legendre"));
  EXPECT_GT(of("riemann"), 10'000);
  EXPECT_GT(of("trapezium"), 2'000);
}

TEST(arc_length_study, comparisons_of_a_track_are_the_sums_of_its_segments) {
  const std::vector<Cubic> track = random_cubics(12, 84);
  const LengthAccuracy demand{32, 1e-6};
  std::vector<LengthComparison> sum(arc_length_methods().size());
  for (const Cubic& c : track) {
    const auto one = compare_lengths(c, demand);
    for (std::size_t i = 0; i < one.size(); ++i) {
      sum[i].length += one[i].length;
      sum[i].error += one[i].error;
      sum[i].evaluations += one[i].evaluations;
      EXPECT_NEAR(one[i].error, one[i].length - static_cast<double>(LengthOracle(c).length()), 1e-13);
    }
  }
  const auto all = compare_lengths(track, demand);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].length, sum[i].length, 1e-11);
    EXPECT_NEAR(all[i].error, sum[i].error, 1e-12);
    EXPECT_EQ(all[i].evaluations, sum[i].evaluations);
    EXPECT_EQ(all[i].error_bound < 0, arc_length_methods()[i].bound == LengthBound::none);
    if (arc_length_methods()[i].bound == LengthBound::guaranteed) {
      EXPECT_LE(std::abs(all[i].error), all[i].error_bound);
    }
  }
}

TEST(arc_length_study, curves_of_no_length_and_empty_tracks_have_no_error) {
  const Cubic point{{1.3f, 2, 3}, {1.3f, 2, 3}, {1.3f, 2, 3}, {1.3f, 2, 3}};
  EXPECT_EQ(reference_length(point), 0);
  for (const Convergence& one : convergence(point))
    for (const ConvergencePoint& p : one.points) EXPECT_EQ(p.relative_error, kSmallestError);
  for (const LengthComparison& one : compare_lengths(point, {})) EXPECT_EQ(one.length, 0);
  for (const LengthComparison& one : compare_lengths(std::span<const Cubic>{}, {})) EXPECT_EQ(one.relative_error, 0);
}

}  // namespace arc_length_study_test
}  // namespace coaster::curve
