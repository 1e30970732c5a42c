#include "curve/arc_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "curve/random_cubics.h"

namespace coaster::curve {
namespace {

// The oracle: composite Simpson in long double on Bernstein's derivative; 4,000 intervals leave 1e-14 on track-like cubics.
double oracle(const Cubic& c, double t0, double t1, int n = 4000) {
  const auto speed = [&](long double t) {
    long double sum = 0;
    for (int a = 0; a < 3; ++a) {
      const long double s = 1 - t, d0 = static_cast<long double>(c.p1[a]) - c.p0[a], d1 = static_cast<long double>(c.p2[a]) - c.p1[a],
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
  for (const Cubic& c : random_cubics(1200, 31)) {
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
  // The cusp (0,0) (1,1) (0,1) (1,0): x' = 3 (1-2t)^2, y' = 3 (1-2t), so L = 3 int |u| sqrt(1 + u^2) du/2 over [-1,1] = 2 sqrt 2 - 1.
  const Cubic cusp{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_NEAR(arc_length(cusp), 2 * std::sqrt(2.0) - 1, 1e-9);
  const Cubic back{{0, 0, 0}, {3, 0, 0}, {-3, 0, 0}, {0, 0, 0}};  // out, through and back on one line: turns at |t| where x' = 0
  const double turn = 0.5 - std::sqrt(3.0) / 6, reach = point(back, turn).x;
  EXPECT_NEAR(arc_length(back), 4 * reach, 1e-9);
}

TEST(arc_length, every_row_approaches_the_length_within_its_means) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < arc_length_methods().size(); ++i) {
    const ArcLengthMethod& row = arc_length_methods()[i];
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_EQ(find_arc_length_method(row.name), static_cast<ArcLengthId>(i));
    for (const Cubic& c : random_cubics(100, 32)) {
      const double exact = arc_length(c);
      // Gravesen's mean: half of polygon - chord; the left sum errs by half a step of |B'(0)| - |B'(1)|; the others by O(h^2).
      const double chord = glm::length(c.p3 - c.p0), polygon = glm::length(c.p1 - c.p0) + glm::length(c.p2 - c.p1) + glm::length(c.p3 - c.p2);
      const double allowed = row.name == "gravesen" ? (polygon - chord) / 2 + 1e-4 : row.name == "riemann" ? 0.5 : 1e-3 * exact;
      EXPECT_NEAR(row.length(c, 64), exact, allowed) << row.name;
    }
  }
  EXPECT_EQ(find_arc_length_method("product"), std::nullopt);
}

TEST(arc_length, adaptive_gauss_legendre_agrees_with_the_map_on_wild_handles) {
  // Handles up to 2.4 times the chord and in any direction: loops and near-cusps, where the promise is 1e-9.
  std::mt19937 random(37);
  std::uniform_real_distribution<float> far(-40, 40);
  for (const Cubic& c : random_cubics(500, 37)) {
    const glm::vec3 a{far(random), far(random), far(random)}, b{far(random), far(random), far(random)};
    const Cubic wild{c.p0, c.p0 + a, c.p3 + b, c.p3};
    const double length = arc_length(wild);
    EXPECT_NEAR(length, oracle(wild, 0, 1, 20'000), 1e-9 * length);
    EXPECT_NEAR(length, ArcLengthMap(wild).length(), 1e-9 * length);
  }
}

TEST(arc_length, gravesen_is_a_mean_of_lengths_and_not_a_product) {
  const Cubic c = random_cubics(1, 33)[0];
  Cubic twice = c;
  for (glm::vec3* p : {&twice.p0, &twice.p1, &twice.p2, &twice.p3}) *p *= 2.0f;
  const ArcLengthMethod& gravesen = arc_length_method(*find_arc_length_method("gravesen"));
  EXPECT_NEAR(gravesen.length(twice, 1), 2 * gravesen.length(c, 1), 1e-3);  // a product would grow fourfold
}

TEST(arc_length, chords_only_fall_short_and_improve_with_steps) {
  const ArcLengthMethod& chords = arc_length_method(*find_arc_length_method("chord_sum"));
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
  EXPECT_EQ(map.distance(-0.5), 0);
  EXPECT_EQ(map.distance(1.5), map.length());
}

}  // namespace
}  // namespace coaster::curve
