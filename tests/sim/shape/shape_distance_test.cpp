#include "sim/shape/shape_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "world/sample_documents.h"

namespace coaster::sim {
namespace shape_distance_test {

constexpr double kPi = 3.14159265358979323846;

// A level ring of n knots about (31, 8, -17), handles of 4/3 tan(a/4) r.
world::Document ring(int n, double radius) {
  world::Document d;
  d.track.closed = true;
  const double handle = 4.0 / 3 * std::tan(kPi / 2 / n) * radius;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n;
    world::Knot knot;
    knot.position = glm::vec3(31 + radius * std::cos(a), 8, -17 + radius * std::sin(a));
    knot.tangent = glm::vec3(-std::sin(a), 0, std::cos(a));
    knot.up = {0, 1, 0};
    knot.in_length = knot.out_length = static_cast<float>(handle);
    const world::Entity e = d.entities.create();
    d.entities.put(e, knot);
    d.track.knots.push_back(e);
  }
  for (int i = 0; i < n; ++i) {
    const world::Entity e = d.entities.create();
    d.entities.put(e, world::Segment{d.track.knots[static_cast<std::size_t>(i)],
                                     d.track.knots[static_cast<std::size_t>((i + 1) % n)]});
    d.track.segments.push_back(e);
  }
  return d;
}

TEST(shape_distance, a_track_is_at_no_distance_from_itself) {
  const ShapeTrace trace = trace_of(test::sample_document());
  EXPECT_EQ(shape_distance(trace, trace), 0.0);
}

TEST(shape_distance, rings_of_cubics_miss_the_circle_by_the_known_error) {
  // The radial error of an arc of angle a is 2/27 sin(a/4)^6 / cos(a/4)^2 of the radius (Goldapp 1991,
  // doi:10.1016/0167-8396(91)90007-X).
  const double radius = 20;
  const ShapeTrace circle = trace_of(ring(64, radius));
  for (const int n : {3, 4, 6, 8}) {
    const double a = 2 * kPi / n,
                 error = 2.0 / 27 * std::pow(std::sin(a / 4), 6) / std::pow(std::cos(a / 4), 2) * radius;
    // Chords of the traces: c^2 / 8 r with c = 2 pi r / 1024.
    EXPECT_NEAR(shape_distance(trace_of(ring(n, radius)), circle), error, 2e-4) << n;
  }
}

TEST(shape_distance, concentric_rings_are_apart_by_their_radii_both_ways) {
  const ShapeTrace a = trace_of(ring(8, 20)), b = trace_of(ring(8, 23.5));
  EXPECT_NEAR(shape_distance(a, b), 3.5, 2e-3);
  EXPECT_EQ(shape_distance(a, b), shape_distance(b, a));
}

TEST(shape_distance, what_is_missing_counts) {
  world::Document half = ring(16, 20);
  half.track.closed = false;
  half.track.segments.resize(8);
  // From the far end of the ring to the nearest end of the half: a quarter, along the chord.
  EXPECT_NEAR(shape_distance(trace_of(half), trace_of(ring(16, 20))), 20 * std::sqrt(2.0), 0.02);
  EXPECT_TRUE(std::isinf(shape_distance({}, trace_of(half))));
  EXPECT_EQ(shape_distance({}, {}), 0.0);
}

}  // namespace shape_distance_test
}  // namespace coaster::sim
