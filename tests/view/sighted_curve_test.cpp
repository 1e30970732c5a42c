#include "view/sighted_curve.h"

#include <gtest/gtest.h>

#include "base/tries.h"
#include "curve/random_cubics.h"
#include "view/polynomial_roots.h"

namespace coaster::view {
namespace sighted_curve_test {

double uniform(std::mt19937& bits, double low, double high) { return low + (high - low) * (bits() / 4294967296.0); }

// Polynomials that are products of (t - root): the roots of odd order come back in order, and which way the sign goes.
TEST(sighted_curve, roots_of_a_polynomial_are_found_between_zero_and_one) {
  std::mt19937 bits(4);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> roots;
    for (int i = 0; i < 8; ++i) roots.push_back(uniform(bits, -0.5, 1.5));
    if (trial % 4 == 0) roots[3] = 0.5, roots[4] = 0.25;  // on the middle of halves
    // In Bernstein form by blossoms: coefficient k is the mean over all ways to give k of the eight factors t = 1, the
    // others t = 0.
    Bernstein8 c{};
    std::array<double, 9> ways{};
    for (unsigned set = 0; set < 256; ++set) {
      double product = 1;
      for (std::size_t i = 0; i < 8; ++i) product *= (set >> i & 1 ? 1 : 0) - roots[i];
      c[static_cast<std::size_t>(std::popcount(set))] += product, ++ways[static_cast<std::size_t>(std::popcount(set))];
    }
    for (std::size_t k = 0; k < 9; ++k) c[k] /= ways[k];
    std::vector<double> wanted;
    for (const double r : roots)
      if (r > 0 && r < 1) wanted.push_back(r);
    std::sort(wanted.begin(), wanted.end());
    bool too_close = false;
    for (std::size_t i = 1; i < wanted.size(); ++i) too_close = too_close || wanted[i] - wanted[i - 1] < 1e-3;
    for (const double r : wanted) too_close = too_close || r < 1e-6 || r > 1 - 1e-6;
    if (too_close) continue;
    std::vector<double> found;
    each_root(c, [&](double t) { found.push_back(t); });
    ASSERT_EQ(found.size(), wanted.size()) << trial;
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-7) << trial;
    // At first the sign is that of (-1)^roots below: every second crossing rises.
    std::vector<Bracket> rises;
    each_rise(c, [&](const Bracket& b) { rises.push_back(b); });
    const bool falls_first = c.front() >= 0;
    ASSERT_EQ(rises.size(), (wanted.size() + (falls_first ? 0 : 1)) / 2) << trial;
    for (std::size_t i = 0; i < rises.size(); ++i) {
      const double root = wanted[2 * i + (falls_first ? 1 : 0)];
      EXPECT_TRUE(rises[i].low <= root + 1e-12 && root <= rises[i].high + 1e-12) << trial;
    }
  }
}

// Compares with 10,000 samples: each minimum of the distance on screen is among the positions, near the eye and far
// away, also with curves that pass it.
TEST(sighted_curve, no_place_nearest_among_its_neighbours_is_missed) {
  std::mt19937 bits(9);
  std::vector<curve::Cubic> cubics = curve::random_cubics(test::tries(500), 17, 15, 20);
  for (const curve::Cubic& degenerate : curve::degenerate_cubics()) cubics.push_back(degenerate);
  int partly = 0, several = 0;
  for (const curve::Cubic& cubic : cubics) {
    const glm::vec3 near = cubic.p1 + glm::vec3(uniform(bits, -3, 3), uniform(bits, -3, 3), uniform(bits, -3, 3));
    world::Camera camera{near, static_cast<float>(uniform(bits, -180, 180)), static_cast<float>(uniform(bits, 0, 80)),
                         static_cast<float>(uniform(bits, 0.5, 30))};
    const View view = orbit_view(camera, {0, 0, 800, 600});
    const glm::vec2 pixel(uniform(bits, 0, 800), uniform(bits, 0, 600));
    const Beam beam(view, pixel);
    ASSERT_TRUE(beam.has_eye());
    const SightedPlaces places = nearest_places(sighted(cubic, beam));
    constexpr int kSamples = 10000;
    std::vector<double> distance(kSamples + 1, INFINITY);
    const glm::dmat4 clip = glm::dmat4(view.projection) * glm::dmat4(view.view);
    int seen = 0;
    for (int i = 0; i <= kSamples; ++i) {
      const glm::dvec4 at = clip * glm::dvec4(curve::point(cubic, i / double(kSamples)), 1);
      if (!(at.w > 1e-4) || std::abs(at.z) > at.w) continue;
      ++seen;
      distance[i] = glm::distance(glm::dvec2((at.x / at.w + 1) * 400, (1 - at.y / at.w) * 300), glm::dvec2(pixel));
    }
    partly += seen > 0 && seen <= kSamples;
    several += places.count > 1;
    EXPECT_EQ(places.count > 0, seen > 0);
    for (const SightedPlace& place : places) {
      EXPECT_TRUE(place.t >= 0 && place.t <= 1 && std::isfinite(place.square) && place.depth > 0);
    }
    for (int i = 0; i <= kSamples; ++i) {
      // Least, and not by rounding alone.
      const double before = i > 0 ? distance[i - 1] : INFINITY, after = i < kSamples ? distance[i + 1] : INFINITY;
      if (!(distance[i] + 1e-9 < before && distance[i] + 1e-9 < after)) continue;
      const bool found = std::any_of(places.begin(), places.end(), [&](const SightedPlace& place) {
        return std::abs(place.t - i / double(kSamples)) < 2.0 / kSamples &&
               std::sqrt(place.square) <= distance[i] + 1e-6;
      });
      EXPECT_TRUE(found) << "t = " << i / double(kSamples) << ", " << distance[i] << " px";
    }
  }
  EXPECT_GT(partly, test::tries(20));
  EXPECT_GT(several, test::tries(20));
}

TEST(sighted_curve, what_is_said_to_be_far_is_far) {
  std::mt19937 bits(12);
  int far = 0;
  for (const curve::Cubic& cubic : curve::random_cubics(2000, 31, 15, 20)) {
    const View view = orbit_view(
        {cubic.p1, static_cast<float>(uniform(bits, -180, 180)), 20, static_cast<float>(uniform(bits, 1, 60))},
        {0, 0, 800, 600});
    const Beam beam(view, {uniform(bits, 0, 800), uniform(bits, 0, 600)});
    const SightedControls controls = sighted(cubic, beam);
    const double limit = uniform(bits, 1, 100);
    if (may_come_near(controls, limit)) continue;
    ++far;
    for (const SightedPlace& place : nearest_places(controls)) EXPECT_GT(std::sqrt(place.square), limit);
  }
  EXPECT_GT(far, 500);
}

}  // namespace sighted_curve_test
}  // namespace coaster::view
