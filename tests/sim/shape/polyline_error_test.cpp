// The errors of a polyline: rounding, and the distance of its chords from the curve: src/sim/shape/shape_distance.
#include "sim/shape/shape_distance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/tries.h"
#include "curve/random_cubics.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace polyline_error_test {

using G2Unknowns = std::array<long double, 3>;

G2Unknowns operator-(const G2Unknowns& a, const G2Unknowns& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
long double dot(const G2Unknowns& a, const G2Unknowns& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Bernstein's sum in long double.
G2Unknowns point_of(const curve::Cubic& c, long double t) {
  const long double s = 1 - t;
  G2Unknowns p;
  for (int k = 0; k < 3; ++k)
    p[std::size_t(k)] = s * s * s * c.p0[k] + 3 * s * s * t * c.p1[k] + 3 * s * t * t * c.p2[k] + t * t * t * c.p3[k];
  return p;
}

// Brute force, which knows nothing of polynomials: samples each piece, and refines every maximum among its neighbours
// by a golden-section search.
double brute_force(const curve::Cubic& cubic, int steps) {
  constexpr int kSamples = 40;
  constexpr long double kGolden = 0.381966011250105151795L;
  long double worst = 0;
  for (int i = 0; i < steps; ++i) {
    const G2Unknowns from = point_of(cubic, (long double)i / steps);
    const G2Unknowns chord = point_of(cubic, (long double)(i + 1) / steps) - from;
    const long double square = dot(chord, chord);
    const auto off = [&](long double u) {
      const G2Unknowns way = point_of(cubic, (i + u) / steps) - from;
      const long double foot = square > 0 ? std::clamp(dot(way, chord) / square, 0.0L, 1.0L) : 0;
      const G2Unknowns d = way - G2Unknowns{foot * chord[0], foot * chord[1], foot * chord[2]};
      return dot(d, d);
    };
    std::array<long double, kSamples + 3> sampled{};  // of -1 and kSamples + 1, too
    for (int j = 0; j <= kSamples; ++j) sampled[std::size_t(j) + 1] = off((long double)j / kSamples);
    for (int j = 0; j <= kSamples; ++j) {
      if (sampled[std::size_t(j) + 1] < std::max(sampled[std::size_t(j)], sampled[std::size_t(j) + 2])) continue;
      long double low = std::max(0.0L, (j - 1.0L) / kSamples), high = std::min(1.0L, (j + 1.0L) / kSamples);
      while (high - low > 1e-7L) {
        const long double a = low + kGolden * (high - low), b = high - kGolden * (high - low);
        (off(a) < off(b) ? low : high) = off(a) < off(b) ? a : b;
      }
      worst = std::max(worst, off((low + high) / 2));
    }
  }
  return double(std::sqrt(worst));
}

double polygon(const curve::Cubic& c) {
  return glm::length(glm::dvec3(c.p1 - c.p0)) + glm::length(glm::dvec3(c.p2 - c.p1)) +
         glm::length(glm::dvec3(c.p3 - c.p2));
}

void expect_exact(const curve::Cubic& cubic, int steps, const char* name) {
  // Rounding of the oracle at the size of the coordinates, and of the program at the size of the second differences.
  const double reach = std::max({glm::length(cubic.p0), glm::length(cubic.p1), glm::length(cubic.p2)});
  const double rounding = 1e-17 * reach + 1e-14 * polygon(cubic) / (steps * steps), wanted = brute_force(cubic, steps);
  EXPECT_NEAR(chord_error(cubic, steps), wanted, 4e-9 * wanted + rounding) << name << ", " << steps << " steps";
}

// A quarter circle of radius 10 as a cubic: within 3 mm of the circle, whose chords are off by r (1 - cos(angle/2n)).
TEST(deviation, the_chord_error_of_an_arc_is_its_sagitta) {
  const float k = 10 * 0.5522847f;
  const curve::Cubic arc{{10, 0, 0}, {10, k, 0}, {k, 10, 0}, {0, 10, 0}};
  for (const int steps : {4, 8, 64}) {
    const double sagitta = 10 * (1 - std::cos(M_PI / 4 / steps));
    EXPECT_NEAR(chord_error(arc, steps), sagitta, 0.12 * sagitta) << steps;  // steps are up to 6 % longer than others
  }
}

// Closed forms. k u (1-u) (1-2u) is largest at u = 1/2 - 1/(2 sqrt 3), where it is k / (6 sqrt 3).
TEST(deviation, the_chord_error_of_an_s_and_of_reversals_is_that_of_the_formula) {
  const curve::Cubic s{{0, 0, 0}, {10, 10, 0}, {20, -10, 0}, {30, 0, 0}};
  EXPECT_NEAR(chord_error(s, 1), 10 / (2 * std::sqrt(3.0)), 1e-12);
  const curve::Cubic closed{{5, 1, 2}, {5, 1, 11}, {5, 1, -7}, {5, 1, 2}};  // on a line, its chord is a point
  EXPECT_NEAR(chord_error(closed, 1), 27 / (6 * std::sqrt(3.0)), 1e-12);
  // x = 6 t (1-t) + t^3 leaves its chord from 0 to 1 where it is above 1: most at x' = 0, t = 2 - sqrt 2.
  const double t = 2 - std::sqrt(2.0), most = 6 * t * (1 - t) + t * t * t - 1;
  EXPECT_NEAR(chord_error({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {1, 0, 0}}, 1), most, 1e-12);
  EXPECT_NEAR(chord_error({{1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {0, 0, 0}}, 1), most, 1e-12);  // beyond the other end
}

TEST(deviation, the_chord_error_is_that_of_brute_force_on_cubics_of_every_kind) {
  const int count = test::tries(100);
  auto sets = curve::cubic_sets(count, 5);
  for (curve::CubicSet& set : curve::degenerate_sets(count, 6)) sets.push_back(std::move(set));
  sets.push_back({"degenerate", curve::degenerate_cubics()});
  std::mt19937 bits(7);
  for (const curve::CubicSet& set : sets)
    for (const curve::Cubic& cubic : set.cubics) {
      expect_exact(cubic, 1 + int(bits() % 64), set.name);
      expect_exact(cubic, 1 + int(bits() % 4), set.name);
      curve::Cubic flat = cubic;
      flat.p0.y = flat.p1.y = flat.p2.y = flat.p3.y;
      expect_exact(flat, 1 + int(bits() % 8), set.name);
    }
}

// More steps than are ever looked at one by one; among them cubics whose chords are all about equally wrong.
TEST(deviation, no_piece_of_very_many_is_overlooked) {
  std::vector<curve::Cubic> cubics{{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 3, 0}},  // curvature times speed^2 is even
                                   {{0, 0, 0}, {10, 0, 0}, {20, 0, 0}, {30, 0, 0.5f}},  // bends towards its end
                                   {{100, 2, 50}, {108, 2, 50}, {90, 30, 41}, {120, 31, 60}}};
  for (const curve::CubicSet& set : curve::cubic_sets(test::tries(3), 8))
    cubics.insert(cubics.end(), set.cubics.begin(), set.cubics.end());
  for (const curve::Cubic& cubic : cubics)
    for (const int steps : {500, 1023}) expect_exact(cubic, steps, "many steps");
}

TEST(deviation, the_chord_error_of_a_track_is_the_largest_of_its_segments) {
  world::Settings settings;
  for (const int steps : {1, 3, 64}) {
    settings.evaluation->steps = steps;
    const DerivedTrack derived = test::derived_of(test::ring_document(7, 23.7), settings);
    double worst = 0;
    for (const world::Entity segment : derived.order)
      worst = std::max(worst, chord_error(derived.shape(segment).key.cubic, steps));
    EXPECT_NEAR(chord_error(derived), worst, 1e-8 * worst);
    EXPECT_GT(worst, 0);
  }
  EXPECT_EQ(chord_error(DerivedTrack{}), 0);
  EXPECT_EQ(chord_error({{0, 0, 0}, {1, 5, 0}, {2, 5, 0}, {3, 0, 0}}, 4, 100), 100);  // a larger one is known
}

}  // namespace polyline_error_test
}  // namespace coaster::sim
