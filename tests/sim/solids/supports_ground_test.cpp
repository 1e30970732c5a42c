// Supports on a land: where their feet are, by the ground's own heights, and what the plane has without one.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "sim/kinds.h"
#include "sim/lands.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace supports_ground_test {

using test::TrackOnLand;

world::Document level_track(world::CoasterKind kind, float height) {
  world::Document document = test::straight_document({-100, height, 3}, {100, height, 3}, 10);
  document.kind = kind;
  return document;
}

// All bars of the track, in its order.
std::vector<Bar> bars_of(const DerivedTrack& derived, const Supports& supports) {
  std::vector<Bar> bars;
  for (const world::Entity e : derived.order)
    bars.insert(bars.end(), supports.of(e)->bars.begin(), supports.of(e)->bars.end());
  return bars;
}
std::vector<Bar> bars_on(const TrackOnLand& track) {
  Supports supports;
  supports.update(track.derived, {}, &track.ground);
  return bars_of(track.derived, supports);
}

class SupportsOnLand : public testing::TestWithParam<world::CoasterKind> {};
INSTANTIATE_TEST_SUITE_P(all, SupportsOnLand, testing::ValuesIn(test::kinds()), test::kind_name);

TEST_P(SupportsOnLand, have_their_feet_on_the_ground_as_it_is_cut) {
  world::Document document = level_track(GetParam(), 14);
  test::shape_land(document, [](double x, double z) { return 4 * std::sin(x / 17) + 0.09 * z; });
  const TrackOnLand track(document);
  const std::vector<Bar> bars = bars_on(track);
  int feet = 0;
  double low = 1e9, high = -1e9;
  for (const Bar& bar : bars) {
    if (!bar.grounded) continue;
    ++feet;
    const double ground = track.ground.height(double{bar.to.x}, double{bar.to.z});
    EXPECT_NEAR(double{bar.to.y}, ground, 1e-4);
    EXPECT_GT(double{bar.from.y} - ground, kLowestSupport - 1e-4);
    low = std::min(low, ground), high = std::max(high, ground);
  }
  EXPECT_GT(feet, 15);
  EXPECT_GT(high - low, 5) << "at different heights";
}

// A land whose heights are all 0 is the plane, to the bit; raised with the track, it raises the bars.
TEST_P(SupportsOnLand, are_those_of_the_plane_on_level_land) {
  world::Document document = level_track(GetParam(), 12);
  const DerivedTrack derived = test::derived_of(document);
  Supports plane;
  plane.update(derived);
  test::shape_land(document, [](double, double) { return 0.0; });
  const TrackOnLand level(document);
  EXPECT_EQ(bars_on(level), bars_of(derived, plane));
  for (const world::Entity e : document.track.knots) document.entities.get<world::Knot>(e).position.y += 16;
  test::shape_land(document, [](double, double) { return 16.0; });
  const std::vector<Bar> raised = bars_on(TrackOnLand(document)), low = bars_of(derived, plane);
  ASSERT_EQ(raised.size(), low.size());
  for (std::size_t i = 0; i < low.size(); ++i) {
    EXPECT_LT(glm::distance(raised[i].from, low[i].from + glm::vec3(0, 16, 0)), 1e-4f) << i;
    EXPECT_LT(glm::distance(raised[i].to, low[i].to + glm::vec3(0, 16, 0)), 1e-4f) << i;
  }
}

TEST_P(SupportsOnLand, are_not_in_tunnels_and_reach_the_bed_of_a_lake) {
  world::Document document = level_track(GetParam(), 5);
  test::shape_land(document, test::ridge(24, 30));
  const TrackOnLand hill(document);
  ASSERT_EQ(hill.ground.tunnels().size(), 1u);
  const Tunnel& tunnel = hill.ground.tunnels().front();
  int outside = 0;
  for (const Bar& bar : bars_on(hill)) {
    const double along = double{bar.from.x} + 100;
    EXPECT_TRUE(along < tunnel.from + 0.5 || along > tunnel.from + tunnel.length - 0.5) << along;
    ++outside;
  }
  EXPECT_GT(outside, 4);
  test::shape_land(document, [](double x, double) { return std::abs(x) < 30 ? -6.0 : 0.0; });
  document.park.water = -1;
  for (const Bar& bar : bars_on(TrackOnLand(document)))
    if (bar.grounded && std::abs(bar.to.x) < 26) EXPECT_NEAR(double{bar.to.y}, -6, 1e-4);
}

// After any change of land or track, what is kept is what would be found afresh.
TEST(SupportsOnLand, kept_ones_are_those_found_afresh_after_strokes_and_drags) {
  std::mt19937 bits(5);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  world::Document document = test::ring_document(14, 58);
  test::shape_land(document, [](double x, double z) { return 0.05 * x + 0.03 * z; });
  TrackOnLand track(document);
  Supports kept;
  int rebuilt = 0;
  for (int round = 0; round < 14; ++round) {
    if (round % 7 == 6) {
      track.document.park.land = round == 6 ? world::Land::plain : world::Land::hills;
    } else if (round % 2 == 0) {
      const glm::dvec2 middle(uniform(-70, 70), uniform(-70, 70));
      const double by = uniform(-6, 6);
      const auto before = track.document.park;
      const Land land(before);
      test::shape_land(track.document, [&](double x, double z) {
        return land.height(x, z) + (glm::distance(glm::dvec2(x, z), middle) < 20 ? by : 0.0);
      });
    } else {
      const auto k = static_cast<std::size_t>(bits() % track.document.track.knots.size());
      track.document.entities.get<world::Knot>(track.document.track.knots[k]).position.y +=
          static_cast<float>(uniform(-9, 9));
    }
    track.update();
    kept.update(track.derived, {}, &track.ground);
    rebuilt += kept.rebuilds();
    const Ground afresh = TrackOnLand(track.document).ground;
    Supports fresh;
    fresh.update(track.derived, {}, &afresh);
    EXPECT_EQ(bars_of(track.derived, kept), bars_of(track.derived, fresh)) << round;
    kept.update(track.derived, {}, &track.ground);
    EXPECT_EQ(kept.rebuilds(), 0) << "nothing changed";
  }
  EXPECT_GT(rebuilt, 14);
}

// A stroke leaves the supports of other track alone. It touches its tile, and the vertices that others share with it.
TEST(SupportsOnLand, are_found_again_only_over_changed_ground) {
  world::Document document = level_track(world::CoasterKind::steel, 14);
  test::shape_land(document, [](double, double) { return 0.0; });
  TrackOnLand track(document);
  Supports supports;
  supports.update(track.derived, {}, &track.ground);
  EXPECT_EQ(supports.rebuilds(), 10);
  world::GroundTile tile;
  tile.heights.fill(64);
  const std::pair<world::TilePlace, world::GroundTile> stroke[] = {{{1, 0}, tile}};
  track.document.park.tiles.put(stroke);
  track.update();
  supports.update(track.derived, {}, &track.ground);
  EXPECT_GE(supports.rebuilds(), 3) << "over the tile from 64 m on";
  EXPECT_LE(supports.rebuilds(), 6) << "of ten segments";
}

// The legs of a station's platforms end on the ground below each of them.
TEST_P(SupportsOnLand, platforms_stand_on_the_ground) {
  world::Document document = level_track(GetParam(), 9);
  document.entities.put(document.track.segments[4], world::Equipment{.kind = world::EquipmentKind::station});
  test::shape_land(document, [](double x, double z) { return 1.2 + 0.04 * x - 0.05 * z; });
  const TrackOnLand track(document);
  Mesh legs, plane;
  const SegmentShape& shape = track.derived.shape_at(4);
  add_fittings(shape, world::EquipmentKind::station, legs, {}, &track.ground);
  add_fittings(shape, world::EquipmentKind::station, plane);
  ASSERT_EQ(legs.vertices.size(), plane.vertices.size());
  int feet = 0;
  for (std::size_t i = 0; i < legs.vertices.size(); ++i) {
    const glm::vec3 at = legs.vertices[i].position, on_plane = plane.vertices[i].position;
    if (on_plane.y > 0.01f) {
      EXPECT_EQ(at, on_plane) << "what is above stays";
      continue;
    }
    ++feet;
    // The ring of a leg's foot is 0.14 m about its middle.
    EXPECT_NEAR(double{at.y}, track.ground.height(double{at.x}, double{at.z}), 0.02);
  }
  EXPECT_GT(feet, 30);
}

}  // namespace supports_ground_test
}  // namespace coaster::sim
