// One cubic as seen from a pixel: all positions with a local minimum of the distance: src/view/pick_cone.
#include "view/pick_cone.h"

#include <gtest/gtest.h>

#include "base/tries.h"
#include "curve/random_cubics.h"

namespace coaster::view {
namespace closest_curve_points_test {

double uniform(std::mt19937& bits, double low, double high) { return low + (high - low) * (bits() / 4294967296.0); }

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
    const PixelBeam beam(view, pixel);
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
    const PixelBeam beam(view, {uniform(bits, 0, 800), uniform(bits, 0, 600)});
    const SightedControls controls = sighted(cubic, beam);
    const double limit = uniform(bits, 1, 100);
    if (may_come_near(controls, limit)) continue;
    ++far;
    for (const SightedPlace& place : nearest_places(controls)) EXPECT_GT(std::sqrt(place.square), limit);
  }
  EXPECT_GT(far, 500);
}

}  // namespace closest_curve_points_test
}  // namespace coaster::view
