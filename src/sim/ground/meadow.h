// Grass and flowers near an eye, on green ground: a pure function of land and eye. A tuft stays where it is as the eye
// moves, and grows from nothing as it comes near.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/ground/land_mesh.h"

namespace coaster::sim {

inline constexpr float kMeadowReach = 42;       // m
inline constexpr std::size_t kMeadowKinds = 4;  // of meadow_model(): grass, then flowers
struct MeadowPlant {
  glm::vec3 foot{0};     // m, on the ground
  float size = 1;        // factor
  glm::vec2 turn{1, 0};  // cosine and sine of its turn about the vertical
  float tint = 0;        // 0..1, as bright as the grass of the land there
  std::size_t kind = 0;
};
// Returns some ten thousand plants at most, none on tracks' earth, sand, rock, snow, under water or around stations.
std::vector<MeadowPlant> meadow_around(const LandMesh& land, const Ground& ground, glm::vec3 eye);

}  // namespace coaster::sim
