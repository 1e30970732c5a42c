// What a ride passes on lands of known shape, and what it adds to the ratings.

#include <random>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/lands.h"
#include "sim/study/ratings.h"
#include "world/sections.h"

namespace coaster::sim {
namespace surroundings_test {

using test::TrackOnLand;

// A level straight of 200 m along x that a train passes at a constant speed.
Surroundings passed(world::Document document, float speed) {
  const world::Entity cart = world::add_cart(document, document.track.segments.front(), 0.01);
  document.start_speed = speed, document.resistance = {};
  const TrackOnLand track(document);
  Plants plants;
  plants.update(track.ground);
  RideCache cache;
  return surroundings_of(*cache.ride(track.document, track.derived, cart), track.derived, track.ground, plants);
}
world::Document straight(float height) { return test::straight_document({-100, height, 0}, {100, height, 0}, 10); }

TEST(Surroundings, are_none_on_the_plane_and_on_level_land) {
  world::Document document = straight(4);
  const Surroundings plane = passed(document, 19);
  EXPECT_EQ(plane.tunnels + plane.near_misses, 0);
  EXPECT_EQ(plane.close + plane.in_tunnels, 0);
  test::shape_land(document, [](double, double) { return 0.0; });
  document.park.woods = 0;
  const Surroundings level = passed(document, 19);
  EXPECT_EQ(level.tunnels + level.near_misses, 0);
  EXPECT_EQ(level.close, 0) << "the ground that the track stands on does not count";
}

TEST(Surroundings, tunnels_count_with_their_length_and_both_portals) {
  world::Document document = straight(5);
  test::shape_land(document, test::ridge(24, 30));
  document.park.woods = 0;
  const Surroundings hill = passed(document, 19);
  EXPECT_EQ(hill.tunnels, 1);
  EXPECT_NEAR(hill.in_tunnels, 60, 8);
  EXPECT_EQ(hill.near_misses, 2);
  EXPECT_GT(hill.close, 0.25);
  EXPECT_LT(hill.close, 0.5);
  EXPECT_EQ(passed(document, 4).near_misses, 0) << "too slow";
  test::shape_land(document,
                   [](double x, double z) { return test::ridge(24, 12)(x - 60, z) + test::ridge(24, 14)(x + 50, z); });
  EXPECT_EQ(passed(document, 19).tunnels, 2);
}

// Leaves the land as it is, whatever the track does.
void dig_nothing(world::Document& document) {
  for (const world::SectionRun& run : world::sections_of(document))
    document.entities.get<world::Section>(run.section).earthwork = world::Earthwork::none;
}

// A lake whose surface is `under` metres below the rails, and so under + 1.5 below the heads, under the middle 100 m.
TEST(Surroundings, water_counts_by_its_depth_below_the_head) {
  for (const auto& [under, misses, close] : {std::tuple(0.2, 1, 0.5), {0.9, 0, 0.5}, {4.4, 0, 0.5}, {4.8, 0, 0.0}}) {
    world::Document document = straight(8);
    test::shape_land(document, [](double x, double) { return std::abs(x) < 50 ? 0.0 : 8.3; });
    document.park.woods = 0, document.park.water = 8 - under;
    dig_nothing(document);
    const Surroundings lake = passed(document, 19);
    EXPECT_EQ(lake.near_misses, misses) << under;
    EXPECT_NEAR(lake.close, close, 0.03) << under;
  }
}

// A wall of rock beside the track: within reach of the head it is a near miss, farther off it is close, then nothing.
TEST(Surroundings, earth_beside_the_head_counts_by_its_distance) {
  for (const auto& [away, misses, close] : {std::tuple(0.5, 1, true), {4.0, 0, true}, {9.0, 0, false}}) {
    world::Document document = straight(8);
    test::shape_land(document, [away = away](double x, double z) { return std::abs(x) < 40 && z > away ? 20.0 : 0.0; });
    document.park.woods = 0;
    dig_nothing(document);
    const Surroundings wall = passed(document, 19);
    EXPECT_EQ(wall.tunnels, 0);
    EXPECT_EQ(wall.near_misses, misses) << away;
    EXPECT_EQ(wall.close > 0.2, close) << away;
  }
}

// Low track through a wood passes many crowns; without woods, or high above them, hardly any.
TEST(Surroundings, woods_count_where_a_crown_is_within_reach) {
  const auto through = [](float height, double woods) {
    world::Document document = straight(height);
    test::shape_land(document, [](double, double) { return 0.0; });
    document.park.woods = woods;
    return passed(document, 19);
  };
  EXPECT_GT(through(2.5f, 1).close, 0.1);
  EXPECT_LT(through(2.5f, 0).close, 0.05) << "single trees are left";
  EXPECT_EQ(through(24, 1).close, 0);
}

// More of what a land offers never lowers the excitement of a ride, whatever else it is like.
TEST(Surroundings, never_lower_the_excitement) {
  std::mt19937 bits(11);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  for (int i = 0; i < test::tries(400); ++i) {
    Ratings ratings;
    ratings.highest_drop = uniform(0, 80), ratings.top_speed.value = uniform(0, 50), ratings.airtime = uniform(0, 20);
    ratings.near_misses = static_cast<int>(uniform(0, 12)), ratings.inversions = static_cast<int>(uniform(0, 9));
    ratings.drops = static_cast<int>(uniform(0, 12)), ratings.up_most.value = uniform(1, 9);
    ratings.jolt_most.value = uniform(0, 20), ratings.overload = uniform(0, 3);
    ratings.tunnels = static_cast<int>(uniform(0, 5)), ratings.close = uniform(0, 1);
    Ratings more = ratings;
    ++more.tunnels;
    EXPECT_GE(excitement_of(more), excitement_of(ratings));
    more.close = std::min(1.0, more.close + uniform(0, 0.4));
    EXPECT_GE(excitement_of(more), excitement_of(ratings));
    more.tunnels = 1000, more.close = 1;
    EXPECT_LE(excitement_of(more) - excitement_of(ratings), 1.2 + 0.8 * 0.8 + 1e-12) << "they tend to a limit";
    Ratings none = ratings, plain = ratings;
    none.tunnels = 0, none.close = 0, plain = none;
    plain.in_tunnels = 40;
    EXPECT_EQ(excitement_of(none), excitement_of(plain)) << "metres are reported, not rated";
  }
}

}  // namespace surroundings_test
}  // namespace coaster::sim
