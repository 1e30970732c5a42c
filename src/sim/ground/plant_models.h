// The shapes of plants: trees, bushes and rocks of size 1, in levels of detail.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/ground/meadow.h"
#include "sim/ground/plants.h"

namespace coaster::sim {

inline constexpr std::size_t kPlantKinds = 4;  // of PlantKind
// Levels of detail from near to far, and how far (m) each reaches.
enum class PlantLevel : std::uint8_t { near, fine, coarse, far };
inline constexpr std::size_t kPlantLevels = 4;
inline constexpr std::array<float, kPlantLevels> kPlantReach{30, 120, 300, 1'200};
inline constexpr float kUndergrowthReach = 260;  // m, of bushes and rocks

struct PlantModel {
  std::vector<LandVertex> vertices;    // about the foot; m at size 1; closed, so that they cast shadows
  std::vector<std::uint16_t> indices;  // counter-clockwise from outside
};
PlantModel plant_model(PlantKind kind, PlantLevel level);
// Returns a tuft of grass (0) or of flowers of a colour, less than kMeadowKinds: blades to be seen from both sides.
PlantModel meadow_model(std::size_t kind);

// Returns the level at a distance (m).
PlantLevel plant_level(float metres);

}  // namespace coaster::sim
