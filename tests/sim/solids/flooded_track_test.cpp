// Track under water: src/sim/solids/conflicts.

#include <gtest/gtest.h>

#include "sim/lands.h"
#include "sim/solids/conflicts.h"

namespace coaster::sim {
namespace flooded_track_test {

using test::TrackOnLand;

// A level straight from x = -100 to 100.
world::Document straight(float height) { return test::straight_document({-100, height, 0}, {100, height, 0}, 10); }

TEST(FloodedTrack, is_track_in_a_lake_and_not_over_it) {
  world::Document document = straight(1);
  EXPECT_TRUE(flooded_track(TrackOnLand(document).ground).empty()) << "without a land";
  test::shape_land(document, [](double x, double) { return std::abs(x - 10) <= 30 ? -9.0 : 0.0; });
  document.park.water = 0.5;
  EXPECT_TRUE(flooded_track(TrackOnLand(document).ground).empty()) << "over it";
  for (const world::Entity e : document.track.knots) document.entities.get<world::Knot>(e).position.y = -3;
  document.park.water = -1.2;
  const std::vector<FloodedTrack> lake = flooded_track(TrackOnLand(document).ground);
  // In its lake, and in the cuts through the level land on both sides, which are lower than the water.
  ASSERT_EQ(lake.size(), 1u);
  EXPECT_NEAR(lake[0].depth, 1.8, 1e-6);
  EXPECT_LE(lake[0].from, 80);
  EXPECT_GE(lake[0].to, 138);
  EXPECT_NEAR(lake[0].place.y, -3, 1e-6);
}

TEST(FloodedTrack, tunnels_are_dry_and_a_track_through_a_hill_is_no_conflict) {
  world::Document document = straight(-4);
  test::shape_land(document, [](double, double) { return 12.0; });
  document.park.water = 3;
  const TrackOnLand hill(document);
  ASSERT_EQ(hill.ground.tunnels().size(), 1u);
  EXPECT_TRUE(flooded_track(hill.ground).empty());
  Conflicts conflicts;
  EXPECT_TRUE(conflicts.update(hill.derived).empty());
}

}  // namespace flooded_track_test
}  // namespace coaster::sim
