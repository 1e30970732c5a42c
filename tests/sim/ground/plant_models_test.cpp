#include "sim/ground/plant_models.h"

#include <map>

#include <gtest/gtest.h>

namespace coaster::sim {
namespace plant_models_test {

TEST(PlantModels, are_simpler_the_farther_they_are) {
  for (std::size_t kind = 0; kind < kPlantKinds; ++kind) {
    std::size_t before = 1'000;
    for (std::size_t level = 0; level < kPlantLevels; ++level) {
      const std::size_t triangles =
          plant_model(static_cast<PlantKind>(kind), static_cast<PlantLevel>(level)).indices.size() / 3;
      EXPECT_LE(triangles, before) << kind << " " << level;
      before = triangles;
    }
    EXPECT_LE(before, 20u);
  }
  for (const PlantKind tree : {PlantKind::conifer, PlantKind::broadleaf}) {
    const std::size_t near = plant_model(tree, PlantLevel::near).indices.size() / 3;
    EXPECT_GT(near, 250u);
    EXPECT_LT(near, 400u);
  }
}

// Crowns are closed, so that they cast shadows from any side; trunks end in the ground and in the crown.
TEST(PlantModels, face_outwards_and_are_closed) {
  for (std::size_t kind = 0; kind < kPlantKinds; ++kind) {
    for (std::size_t level = 0; level < kPlantLevels; ++level) {
      const PlantModel model = plant_model(static_cast<PlantKind>(kind), static_cast<PlantLevel>(level));
      double volume = 0;
      float top = 0, wide = 0;
      std::map<std::array<float, 6>, int> edges;
      for (std::size_t i = 0; i < model.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return model.vertices[model.indices[i + k]].position; };
        volume += glm::dot(glm::dvec3(at(0)), glm::cross(glm::dvec3(at(1)), glm::dvec3(at(2)))) / 6;
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::vec3 a = at(k), b = at((k + 1) % 3);
          ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
          --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
          top = std::max(top, a.y), wide = std::max(wide, std::hypot(a.x, a.z));
        }
      }
      EXPECT_GT(volume, 0.2) << kind << " " << level;
      int open = 0;
      for (const auto& [edge, count] : edges) open += count != 0;
      EXPECT_LE(open, 2 * 2 * 8) << kind << " " << level << ": only the ends of a trunk";
      if (kind < 2) {
        EXPECT_GT(top, 6.5f);
        EXPECT_LT(top, 1.05f * static_cast<float>(kTreeHeight));
        EXPECT_LT(wide, 4.0f);
      } else {
        EXPECT_LT(top, 1.7f);
      }
    }
  }
}

TEST(PlantModels, change_levels_at_their_reach) {
  EXPECT_EQ(plant_level(0), PlantLevel::near);
  EXPECT_EQ(plant_level(kPlantReach[0]), PlantLevel::fine);
  EXPECT_EQ(plant_level(kPlantReach[1]), PlantLevel::coarse);
  EXPECT_EQ(plant_level(kPlantReach[2]), PlantLevel::far);
  EXPECT_EQ(plant_level(5'000), PlantLevel::far);
}

}  // namespace plant_models_test
}  // namespace coaster::sim
