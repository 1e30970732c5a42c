#include "sim/ground/meadow.h"

#include <map>

#include <gtest/gtest.h>

#include "sim/ground/plant_models.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace meadow_test {

// A straight with a station on a land, and the land as it is drawn.
struct Site {
  Ground ground;
  LandMesh land;
  explicit Site(world::Land kind) {
    world::Document document = test::straight_document({-24, 3, 18}, {24, 3, -18}, 6);
    document.park = world::usual_park(kind, 7);
    for (const std::size_t i : {2, 3})
      document.entities.put(document.track.segments[i], world::Equipment{.kind = world::EquipmentKind::station});
    ground.update(document, test::derived_of(document), track_room(form_of(document.kind)));
    land.update(ground, nullptr, {0, 1, 0}, true, {});
  }
  glm::vec3 eye(double x, double z, double over) const { return {x, ground.height(x, z) + over, z}; }
};

std::map<std::pair<float, float>, MeadowPlant> by_place(const std::vector<MeadowPlant>& plants) {
  std::map<std::pair<float, float>, MeadowPlant> found;
  for (const MeadowPlant& plant : plants) found[{plant.foot.x, plant.foot.z}] = plant;
  return found;
}

TEST(Meadow, stands_on_dry_ground_clear_of_stations_and_thins_with_distance) {
  const Site site(world::Land::meadow);
  int plants = 0, near = 0, far = 0, flowers = 0;
  for (double x = -160; x <= 160; x += 20) {
    const glm::vec3 eye = site.eye(x, 0.7 * x + 15, 1.7);
    for (const MeadowPlant& plant : meadow_around(site.land, site.ground, eye)) {
      const glm::dvec3 foot(plant.foot);
      EXPECT_NEAR(foot.y, site.ground.height(foot.x, foot.z), 1e-3);
      EXPECT_GT(foot.y, site.ground.water());
      for (const TrackSample& sample : site.ground.samples())
        EXPECT_TRUE(!sample.station || glm::distance(foot, sample.at) > 5);
      const float metres = glm::distance(eye, plant.foot);
      ASSERT_LT(metres, kMeadowReach);
      ++plants, near += metres<14, far += metres> 28, flowers += plant.kind > 0;
      EXPECT_LT(plant.kind, kMeadowKinds);
    }
  }
  EXPECT_GT(plants, 17 * 500);
  EXPECT_LT(plants, 17 * 6000);
  EXPECT_GT(near, 2 * far) << "of an area three times as large";
  EXPECT_GT(flowers, plants / 200);
  EXPECT_LT(flowers, plants / 6);
}

TEST(Meadow, stays_where_it_is_as_the_eye_moves) {
  const Site site(world::Land::hills);
  const auto before = by_place(meadow_around(site.land, site.ground, site.eye(60, 70, 2))),
             after = by_place(meadow_around(site.land, site.ground, site.eye(60.5, 70.2, 2)));
  std::size_t both = 0;
  for (const auto& [place, plant] : before) {
    const auto there = after.find(place);
    // What came or went was as good as nothing.
    EXPECT_NEAR(there == after.end() ? 0 : there->second.size, plant.size, 0.25f);
    if (there == after.end()) continue;
    ++both;
    EXPECT_EQ(there->second.turn, plant.turn);
  }
  EXPECT_GT(both, before.size() / 2);
  EXPECT_GT(both, 300u);
}

TEST(Meadow, grows_on_green_land_alone_and_not_below_a_high_eye) {
  for (const world::Land land : {world::Land::desert, world::Land::snow}) {
    const Site bare(land);
    EXPECT_TRUE(meadow_around(bare.land, bare.ground, bare.eye(60, 70, 2)).empty());
  }
  const Site site(world::Land::hills);
  EXPECT_TRUE(meadow_around(site.land, site.ground, site.eye(60, 70, double{kMeadowReach} + 1)).empty());
}

TEST(Meadow, has_small_models_that_stand_on_the_ground) {
  for (std::size_t kind = 0; kind < kMeadowKinds; ++kind) {
    const PlantModel model = meadow_model(kind);
    EXPECT_LE(model.indices.size() / 3, 8u);
    for (const LandVertex& vertex : model.vertices) {
      EXPECT_GE(vertex.position.y, 0);
      EXPECT_LT(vertex.position.y, 0.5f);
    }
  }
}

}  // namespace meadow_test
}  // namespace coaster::sim
