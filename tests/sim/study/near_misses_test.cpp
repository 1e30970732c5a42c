// Near misses of tracks with known distances: a straight that passes over another one, and columns next to it.
#include "sim/solids/supports.h"
#include "sim/study/ratings.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace near_misses_test {

// Along x through (30, 5, 0), round, and across it `over` metres above.
world::Document crossing(float over) {
  world::Document d;
  const auto add = [&](glm::vec3 at, glm::vec3 along) { world::append_knot(d, test::skew_knot(at, along, 15, 15)); };
  add({0, 5, 0}, {1, 0, 0}), add({60, 5, 0}, {1, 0, 0});
  add({90, 5 + over / 2, 45}, {0, 0, 1}), add({60, 5 + over, 75}, {-1, 0, 0});
  add({30, 5 + over, 50}, {0, 0, -1}), add({30, 5 + over, -40}, {0, 0, -1});
  return d;
}

NearMisses misses(const world::Document& document, double speed, bool with_supports) {
  world::Document d = document;
  const world::Entity cart = world::add_cart(d, d.track.segments.front(), 0.05);
  d.start_speed = static_cast<float>(speed);
  const DerivedTrack derived = test::derived_of(d);
  RideCache cache;
  Supports supports;
  supports.update(derived);
  return near_misses(*cache.ride(d, derived, cart), derived, with_supports ? &supports : nullptr);
}

// A straight up that other track passes beside, at any height: track may be as high as it is long.
TEST(near_misses, are_found_at_any_height) {
  for (const float height : {-3000.0f, 0.0f, 7.9f, 8.1f, 25'000.0f})
    for (const float over : {3.5f, 4.5f, 5.1f, 8.0f}) {
      world::Document d = crossing(over);
      for (const world::Entity e : d.track.knots) d.entities.get<world::Knot>(e).position.y += height;
      EXPECT_EQ(misses(d, 19, false).track, over < 5 ? 1 : 0) << height << " " << over;
    }
}

// Below the other track a head passes its middle at over - kHead - 0.3 m; above it the other rails are farther.
TEST(near_misses, passing_under_track_is_one_within_reach_of_the_head) {
  for (const float over : {3.5f, 4.5f}) EXPECT_EQ(misses(crossing(over), 19, false).track, 1) << over;
  for (const float over : {5.1f, 8.0f}) EXPECT_EQ(misses(crossing(over), 19, false).track, 0) << over;
}

// Track within 12 m along the rails does not count, also where it is across the seam of a circuit.
TEST(near_misses, the_track_beside_the_seam_of_a_circuit_is_no_other_track) {
  for (const double from : {0.0, 0.02, 0.5, 0.97}) {
    world::Document d = test::ring_document(12, 40.3, 0);
    const world::Entity cart = world::add_cart(d, d.track.segments.front(), from);
    d.start_speed = 19;
    const DerivedTrack derived = test::derived_of(d);
    RideCache cache;
    const SimulatedRide& simulated = *cache.ride(d, derived, cart);
    ASSERT_TRUE(simulated.lap);
    EXPECT_EQ(near_misses(simulated, derived, nullptr).track, 0) << from;
  }
}

TEST(near_misses, a_train_that_creeps_past_misses_nothing) {
  world::Document d = crossing(4.0f);
  d.entities.get<world::Knot>(d.track.knots.back()).position.y = 9;
  EXPECT_EQ(misses(d, 4.5, false).track, 0);
}

// The columns of high track are next to the track below it; those that hold the track under the riders do not count.
TEST(near_misses, columns_beside_the_track_count_and_its_own_do_not) {
  world::Document straight = test::straight_document({1.1f, 9.3f, 2.7f}, {91.1f, 9.3f, 12.7f}, 3);
  EXPECT_EQ(misses(straight, 15, true).supports, 0);
  // A strand 12 m above the first one, `aside` metres to the side.
  const auto beside = [](float aside) {
    world::Document d;
    const auto add = [&](glm::vec3 at, glm::vec3 along) { world::append_knot(d, test::skew_knot(at, along, 15, 15)); };
    add({0, 5, 0}, {1, 0, 0}), add({70, 5, 0}, {1, 0, 0});
    add({105, 9, 25 + aside}, {0, 0, 1}), add({75, 13, 45 + aside}, {-1, 0, 0});
    add({60, 17, 25 + aside}, {0, 0, -1}), add({45, 17, aside}, {-1, 0, 0}), add({0, 17, aside}, {-1, 0, 0});
    return misses(d, 19, true);
  };
  EXPECT_GT(beside(2.2f).supports, 0);
  EXPECT_EQ(beside(2.2f).track, 0);
  EXPECT_EQ(beside(9.0f).supports, 0);
}

}  // namespace near_misses_test
}  // namespace coaster::sim
