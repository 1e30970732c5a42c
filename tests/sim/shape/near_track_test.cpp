// Which track is near the eye.
#include "sim/shape/detail_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/tracks.h"

namespace coaster::sim {
namespace near_track_test {

using glm::vec3;

vec3 at(const world::Document& d, std::size_t knot) {
  return world::knot(d, d.track.knots[knot]).position + vec3(1.3f, 4.1f, -0.7f);
}

double length_of(const DerivedTrack& derived, const NearSegments& near) {
  double length = 0;
  for (const std::size_t i : near.indices()) length += derived.shape_at(i).arc.length();
  return length;
}

// Each segment that comes within reach of the eye is near, whatever the steps of the eye; of those far off none is.
void expect_complete(const DerivedTrack& derived, const NearSegments& near, vec3 eye, double reach, double most) {
  const std::set<std::size_t> found(near.indices().begin(), near.indices().end());
  ASSERT_EQ(found.size(), near.indices().size());
  EXPECT_TRUE(std::is_sorted(near.indices().begin(), near.indices().end()));
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    double nearest = 1e9;
    for (int k = 0; k <= 8; ++k)
      nearest = std::min(nearest, glm::distance(curve::point(derived.shape_at(i).key.cubic, k / 8.0), glm::dvec3(eye)));
    EXPECT_TRUE(nearest >= reach || found.contains(i)) << i;
    EXPECT_TRUE(nearest <= most || !found.contains(i)) << i;
  }
}

TEST(near_track, is_everything_unless_the_track_is_very_long) {
  for (const double radius : {300.0, 2'300.0}) {
    const DerivedTrack derived = test::derived_of(test::ring_document(200, radius));
    NearSegments near;
    near.look_from({{0, 0, 0}, 50});
    near.update(derived);
    EXPECT_TRUE(near.everywhere()) << radius;
  }
  NearSegments near;
  near.update(test::derived_of(test::ring_document(200, 2'500)));  // 15.7 km
  EXPECT_FALSE(near.everywhere());
  EXPECT_TRUE(near.indices().empty()) << "nobody looks";
}

TEST(near_track, is_all_that_comes_within_reach_of_the_eye) {
  world::Document d = test::ring_document(24'000, 40'000);
  DerivedTrack derived = test::derived_of(d);
  NearSegments near;
  for (const std::size_t knot : {std::size_t{0}, std::size_t{7777}, std::size_t{23'999}}) {
    const vec3 eye = at(d, knot);
    near.look_from({eye, 400});
    near.update(derived);
    EXPECT_FALSE(near.everywhere());
    EXPECT_GT(near.indices().size(), 60u);
    EXPECT_LT(near.indices().size(), 400u);
    expect_complete(derived, near, eye, 400, 450);
  }
  // A knot that is moved away takes its segments along.
  const std::size_t moved = 23'990;
  near.look_from({at(d, moved), 60});
  near.update(derived);
  EXPECT_TRUE(std::binary_search(near.indices().begin(), near.indices().end(), moved));
  d.entities.get<world::Knot>(d.track.knots[moved]).position.y += 800;
  const std::vector<std::size_t> before = near.indices();
  derive(d, {}, {}, derived);
  near.look_from({at(d, moved) - vec3(0, 800, 0), 60});
  near.update(derived);
  expect_complete(derived, near, at(d, moved) - vec3(0, 800, 0), 60, 110);
}

TEST(near_track, is_at_most_so_long_however_much_is_within_reach) {
  const world::Document d = test::ring_document(24'000, 11'000);  // 69 km
  const DerivedTrack derived = test::derived_of(d);
  NearSegments near;
  near.look_from({{13, 40, -7}, 20'000});  // the middle of the ring: all or nothing
  near.update(derived);
  EXPECT_TRUE(near.indices().empty());
  near.look_from({at(d, 500), 20'000});
  near.update(derived);
  EXPECT_LE(length_of(derived, near), kMaxNearLength);
  EXPECT_GT(length_of(derived, near), kMaxNearLength / 3);
  expect_complete(derived, near, at(d, 500), 1'000, 20'000);
}

TEST(near_track, does_not_change_while_the_eye_stays_within_its_step) {
  const world::Document d = test::ring_document(24'000, 40'000);
  const DerivedTrack derived = test::derived_of(d);
  const vec3 eye = 16.0f * glm::round(at(d, 3) / 16.0f);
  NearSegments near;
  near.look_from({eye, 300});
  near.update(derived);
  const std::vector<std::size_t> first = near.indices();
  near.look_from({eye + vec3(7, -7, 7), 300});
  near.update(derived);
  EXPECT_EQ(near.indices(), first);
  near.look_from({eye + vec3(0, 0, 90), 300});
  near.update(derived);
  EXPECT_NE(near.indices(), first);
}

TEST(near_track, has_finer_rails_than_the_whole_track_may) {
  const world::Document d = test::ring_document(100'000, 60'000);
  DerivedTrack derived = test::derived_of(d);
  NearSegments near;
  const SolidsDetail whole = detail_of(derived);
  EXPECT_EQ(near.detail(whole), whole);
  near.look_from({at(d, 9), 100});
  near.update(derived);
  EXPECT_TRUE(near.detail(whole).parts);
  EXPECT_GT(near.detail(whole).most_rings, whole.most_rings);
}

}  // namespace near_track_test
}  // namespace coaster::sim
