#include "curve/arc_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/enum_names.h"
#include "curve/length_oracle.h"
#include "curve/random_cubics.h"

namespace coaster::curve {
namespace arc_length_test {

// The oracle: composite Simpson in long double on Bernstein's derivative; 4,000 intervals leave 1e-14 on track-like
// cubics.
double oracle(const Cubic& c, double t0, double t1, int n = 4000) {
  const auto speed = [&](long double t) {
    long double sum = 0;
    for (int a = 0; a < 3; ++a) {
      const long double s = 1 - t, d0 = static_cast<long double>(c.p1[a]) - c.p0[a],
                        d1 = static_cast<long double>(c.p2[a]) - c.p1[a],
                        d2 = static_cast<long double>(c.p3[a]) - c.p2[a];
      const long double d = 3 * (s * s * d0 + 2 * t * s * d1 + t * t * d2);
      sum += d * d;
    }
    return sqrtl(sum);
  };
  const long double h = (static_cast<long double>(t1) - t0) / n;
  long double sum = speed(t0) + speed(t1);
  for (int i = 1; i < n; ++i) sum += (i % 2 ? 4 : 2) * speed(t0 + i * h);
  return static_cast<double>(sum * h / 3);
}

TEST(arc_length, adaptive_gauss_legendre_agrees_with_simpson_in_long_double) {
  // Many: a stopping rule that trusts its estimate too far fails on one curve in two hundred.
  for (const Cubic& c : random_cubics(600, 31)) {
    const double exact = oracle(c, 0, 1);
    EXPECT_NEAR(arc_length(c), exact, 1e-12 * exact);
    EXPECT_NEAR(arc_length(c, 0.21, 0.63), oracle(c, 0.21, 0.63), 1e-12 * exact);
  }
}

TEST(arc_length, closed_forms_are_met) {
  const Cubic line{{1, 2, 3}, {1.4f, 2, 3}, {6, 2, 3}, {8, 2, 3}};  // straight, uneven speed
  EXPECT_NEAR(arc_length(line), 7, 1e-12);
  // The parabola y = x^2 on [0,1] as a cubic: sqrt(5)/2 + asinh(2)/4, to float's rounding of 1/3.
  const Cubic parabola{{0, 0, 0}, {1 / 3.0f, 0, 0}, {2 / 3.0f, 1 / 3.0f, 0}, {1, 1, 0}};
  EXPECT_NEAR(arc_length(parabola), std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, 1e-7);
  // The cusp (0,0) (1,1) (0,1) (1,0): x' = 3 (1-2t)^2, y' = 3 (1-2t), so L = 3 int |u| sqrt(1 + u^2) du/2 over [-1,1] =
  // 2 sqrt 2 - 1.
  const Cubic cusp{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_NEAR(arc_length(cusp), 2 * std::sqrt(2.0) - 1, 1e-9);
  const Cubic back{
      {0, 0, 0}, {3, 0, 0}, {-3, 0, 0}, {0, 0, 0}};  // out, through and back on one line: turns at |t| where x' = 0
  const double turn = 0.5 - std::sqrt(3.0) / 6, reach = point(back, turn).x;
  EXPECT_NEAR(arc_length(back), 4 * reach, 1e-9);
}

TEST(arc_length, every_row_approaches_the_length_within_its_means) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < arc_length_methods().size(); ++i) {
    const ArcLengthMethod& row = arc_length_methods()[i];
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_EQ(base::value_named<curve::ArcLengthId>(row.name), static_cast<ArcLengthId>(i));
    for (const Cubic& c : random_cubics(100, 32)) {
      const double exact = arc_length(c);
      // Gravesen's mean: half of polygon - chord; the left sum errs by half a step of |B'(0)| - |B'(1)|; the others by
      // O(h^2).
      const double chord = glm::length(c.p3 - c.p0),
                   polygon = glm::length(c.p1 - c.p0) + glm::length(c.p2 - c.p1) + glm::length(c.p3 - c.p2);
      const double allowed = row.name == "gravesen"  ? (polygon - chord) / 2 + 1e-4
                             : row.name == "riemann" ? 0.5
                                                     : 1e-3 * exact;
      EXPECT_NEAR(row.length(c, 64), exact, allowed) << row.name;
    }
  }
  EXPECT_EQ(base::value_named<curve::ArcLengthId>("product"), std::nullopt);
}

TEST(arc_length, adaptive_gauss_legendre_agrees_with_the_map_on_wild_handles) {
  // Handles up to 2.4 times the chord and in any direction: loops and near-cusps, where the promise is 1e-9.
  std::mt19937 random(37);
  std::uniform_real_distribution<float> far(-40, 40);
  for (const Cubic& c : random_cubics(200, 37)) {
    const glm::vec3 a{far(random), far(random), far(random)}, b{far(random), far(random), far(random)};
    const Cubic wild{c.p0, c.p0 + a, c.p3 + b, c.p3};
    const double length = arc_length(wild);
    EXPECT_NEAR(length, oracle(wild, 0, 1, 20'000), 1e-9 * length);
    EXPECT_NEAR(length, ArcLengthMap(wild).length(), 1e-9 * length);
  }
}

const std::vector<CubicSet>& hard_sets() {
  static const std::vector<CubicSet> sets = cubic_sets(2000, 71);
  return sets;
}

TEST(arc_length, every_requested_tolerance_is_kept_on_every_kind_of_cubic) {
  for (const CubicSet& set : hard_sets()) {
    std::vector<double> exact, batch(set.cubics.size());
    for (const Cubic& c : set.cubics) exact.push_back(static_cast<double>(LengthOracle(c).length()));
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      arc_lengths(set.cubics, tolerance, batch);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        ASSERT_NEAR(arc_length(set.cubics[i], 0, 1, tolerance), exact[i], tolerance * exact[i])
            << set.name << " " << i << " to " << tolerance;
        ASSERT_NEAR(batch[i], exact[i], tolerance * exact[i]) << set.name << " " << i << " at once to " << tolerance;
      }
    }
  }
}

TEST(arc_length, rules_that_agree_by_chance_are_not_believed) {
  // On one of these loops 8 and 16 nodes agree to 1e-10 of the whole, and both err by as much.
  for (const CubicSet& set : cubic_sets(1000, 19)) {
    if (set.name != std::string_view("looping")) continue;
    for (const Cubic& c : set.cubics) {
      const auto exact = static_cast<double>(LengthOracle(c).length());
      ASSERT_NEAR(arc_length(c), exact, 1e-12 * exact);
    }
  }
}

TEST(arc_length, parts_of_a_curve_keep_the_tolerance_of_their_own_length) {
  for (const CubicSet& set : cubic_sets(100, 72))
    for (const Cubic& c : set.cubics) {
      const LengthOracle oracle_of(c);
      for (const double t1 : {0.013, 0.31, 0.5, 0.77, 1.0}) {
        const auto exact = static_cast<double>(oracle_of.length(t1 / 2, t1));
        for (const double tolerance : {0.1, 1e-5, 1e-7, 1e-8, 1e-10, 1e-11})
          ASSERT_NEAR(arc_length(c, t1 / 2, t1, tolerance), exact, tolerance * exact) << set.name;
        // A part is bounded by its own share of the rounding of B', which the whole curve sets.
        ASSERT_NEAR(arc_length(c, t1 / 2, t1), exact, 1e-12 * exact + 1e-15 * arc_length(c)) << set.name;
      }
    }
}

TEST(arc_length, rows_that_heed_a_tolerance_report_what_they_reach) {
  for (const ArcLengthMethod& row : arc_length_methods()) {
    if (row.control == LengthControl::count) continue;
    for (const CubicSet& set : cubic_sets(40, 73))
      for (const Cubic& c : set.cubics)
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
          const auto exact = static_cast<double>(LengthOracle(c).length());
          const LengthEstimate estimate = row.measure(c, {64, tolerance});
          ASSERT_GE(estimate.error_bound, 0);
          ASSERT_GT(estimate.evaluations, 0);
          if (row.bound == LengthBound::guaranteed) {
            ASSERT_LE(std::abs(estimate.length - exact), estimate.error_bound) << row.name << set.name;
          }
          if (row.name == "gauss_legendre") {
            ASSERT_LE(estimate.error_bound, tolerance * estimate.length) << set.name;
          } else if (row.name == "simpson_adaptive") {  // relative to its first estimate of the length
            ASSERT_LE(estimate.error_bound, 2 * tolerance * estimate.length) << set.name;
          }
        }
  }
}

TEST(arc_length, gravesens_subdivision_keeps_its_tolerance_until_its_depth_ends) {
  const ArcLengthMethod& row = base::row_of(*base::value_named<curve::ArcLengthId>("gravesen_adaptive"));
  for (const CubicSet& set : cubic_sets(15, 74))
    for (const Cubic& c : set.cubics) {
      const auto exact = static_cast<double>(LengthOracle(c).length());
      EXPECT_NEAR(row.measure(c, {64, 1e-4}).length, exact, 1e-4 * exact) << set.name;
      const LengthEstimate finest = row.measure(c, {64, 1e-12});
      EXPECT_LE(finest.evaluations, 8 << 14);
      EXPECT_NEAR(finest.length, exact, finest.error_bound) << set.name;
    }
}

TEST(arc_length, counted_rows_converge_at_their_order) {
  // Errors at 16 and 32 intervals on even curves: chords, trapezium fall 4 times, Simpson 16, Riemann 2; the nodes of
  // Gauss-Legendre and Clenshaw-Curtis faster than any power. Summed over curves, since one curve's error may cancel.
  const auto error = [](std::string_view name, int count) {
    double sum = 0;
    for (const Cubic& c : random_cubics(60, 75))
      sum += std::abs(base::row_of(*base::value_named<curve::ArcLengthId>(name)).length(c, count) - arc_length(c));
    return sum;
  };
  EXPECT_NEAR(error("riemann", 64) / error("riemann", 128), 2, 0.1);
  EXPECT_NEAR(error("trapezium", 64) / error("trapezium", 128), 4, 0.1);
  EXPECT_NEAR(error("chord_sum", 64) / error("chord_sum", 128), 4, 0.1);
  EXPECT_NEAR(error("simpson", 64) / error("simpson", 128), 16, 2);
  EXPECT_GT(error("gauss_legendre_fixed", 6) / error("gauss_legendre_fixed", 12), 200);
  EXPECT_GT(error("clenshaw_curtis", 8) / error("clenshaw_curtis", 16), 50);
  EXPECT_LT(error("gauss_legendre_fixed", 200), 1e-10);  // beyond the largest rule: panels
  EXPECT_LT(error("clenshaw_curtis", 200), 1e-10);
}

TEST(arc_length, evaluations_are_those_of_the_formula) {
  const Cubic c = random_cubics(1, 76)[0];
  const auto evaluations = [&](std::string_view name, int count) {
    return base::row_of(*base::value_named<curve::ArcLengthId>(name)).measure(c, {count, 1e-9}).evaluations;
  };
  EXPECT_EQ(evaluations("riemann", 9), 9);
  EXPECT_EQ(evaluations("trapezium", 9), 10);
  EXPECT_EQ(evaluations("simpson", 9), 11);
  EXPECT_EQ(evaluations("chord_sum", 9), 9);
  EXPECT_EQ(evaluations("gauss_legendre_fixed", 9), 9);
  EXPECT_EQ(evaluations("clenshaw_curtis", 9), 10);
  EXPECT_EQ(evaluations("gravesen", 9), 4);
}

TEST(arc_length, many_at_once_agree_with_one_by_one_for_every_count) {
  const std::vector<Cubic> all = random_cubics(23, 77);
  for (std::size_t count = 0; count <= all.size(); ++count) {
    std::vector<double> lengths(count, -1);
    arc_lengths(std::span(all).first(count), 1e-9, lengths);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_NEAR(lengths[i], arc_length(all[i]), 1e-9 * lengths[i]) << i << " of " << count;
  }
}

TEST(arc_length, gravesen_is_a_mean_of_lengths_and_not_a_product) {
  const Cubic c = random_cubics(1, 33)[0];
  Cubic twice = c;
  for (glm::vec3* p : {&twice.p0, &twice.p1, &twice.p2, &twice.p3}) *p *= 2.0f;
  const ArcLengthMethod& gravesen = base::row_of(*base::value_named<curve::ArcLengthId>("gravesen"));
  EXPECT_NEAR(gravesen.length(twice, 1), 2 * gravesen.length(c, 1), 1e-3);  // a product would grow fourfold
}

TEST(arc_length, chords_only_fall_short_and_improve_with_steps) {
  const ArcLengthMethod& chords = base::row_of(*base::value_named<curve::ArcLengthId>("chord_sum"));
  for (const Cubic& c : random_cubics(50, 34)) {
    double last = 0;
    for (int steps : {1, 2, 4, 8, 64, 1024}) {
      const double length = chords.length(c, steps);
      EXPECT_GE(length, last - 1e-12);
      EXPECT_LE(length, arc_length(c) + 1e-9);
      last = length;
    }
  }
}

TEST(arc_length, inversion_is_exact_to_a_tenth_of_a_nanometre) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (const Cubic& c : random_cubics(60, 35)) {
    const ArcLengthMap map(c);
    EXPECT_NEAR(map.length(), arc_length(c), 1e-11);
    for (int i = 0; i < 5; ++i) {
      const double s = share(random) * map.length();
      EXPECT_NEAR(oracle(c, 0, map.parameter(s)), s, 1e-10);
    }
  }
}

TEST(arc_length, inversion_is_exact_to_a_nanometre_on_every_kind_of_cubic) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> share(0, 1);
  for (CubicSet set : cubic_sets(250, 78)) {
    // The same shapes moved 100 km away, where a float has steps of 8 mm: the control points round, what is measured
    // does not.
    const std::size_t near = set.cubics.size();
    for (std::size_t i = 0; i < near; i += 5) {
      Cubic far = set.cubics[i];
      for (glm::vec3* p : {&far.p0, &far.p1, &far.p2, &far.p3}) *p += glm::vec3{-99'900, 812, 99'871};
      set.cubics.push_back(far);
    }
    for (const Cubic& c : set.cubics) {
      const ArcLengthMap map(c);
      const LengthOracle exact(c);
      ASSERT_NEAR(map.length(), static_cast<double>(exact.length()), 1e-9) << set.name;
      double last = -1;
      for (const double s : {0.0, 1e-6 * map.length(), share(random) * map.length(), map.length()}) {
        const double t = map.parameter(s);
        ASSERT_NEAR(static_cast<double>(exact.length(0, t)), s, 1e-9) << set.name;
        ASSERT_NEAR(map.distance(t), s, 1e-9) << set.name;
        ASSERT_GE(t, last);
        last = t;
      }
    }
  }
}

TEST(arc_length, inversion_is_monotone_bounded_and_finite_on_degenerate_curves) {
  for (const Cubic& c : degenerate_cubics()) {
    const ArcLengthMap map(c);
    ASSERT_TRUE(std::isfinite(map.length()));
    EXPECT_NEAR(map.length(), arc_length(c), 1e-9 * std::max(1.0, map.length()));
    double last = 0;
    for (int i = 0; i <= 200; ++i) {
      const double s = map.length() * i / 200, t = map.parameter(s);
      ASSERT_TRUE(t >= last && t <= 1) << t;
      EXPECT_NEAR(map.distance(t), s, 1e-9 * std::max(1.0, map.length()));
      last = t;
    }
  }
  EXPECT_EQ(ArcLengthMap(Cubic{}).parameter(1), 0);
}

TEST(arc_length, distances_beyond_the_ends_are_clamped) {
  const ArcLengthMap map(random_cubics(1, 36)[0]);
  EXPECT_EQ(map.parameter(-1), 0);
  EXPECT_EQ(map.parameter(map.length() + 1), 1);
  for (const double before : {-1e-9, -1e-3, -0.05, -0.5, -1e300}) EXPECT_EQ(map.distance(before), 0) << before;
  EXPECT_EQ(map.distance(1.5), map.length());
}

}  // namespace arc_length_test
}  // namespace coaster::curve
