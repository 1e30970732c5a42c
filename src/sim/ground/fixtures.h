// What people built into the land: tunnels with their portals, and the posts of lamps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/ground/ground.h"
#include "sim/ground/lamps.h"
#include "sim/ground/land_mesh.h"

namespace coaster::sim {

struct FixtureMesh {
  std::vector<LandVertex> vertices;
  std::vector<LandLight> light;  // of those vertices
  std::vector<std::uint32_t> indices;
};
// Builds the tunnels, and the posts of `posts`; `lit` are the lamps that shine on them.
FixtureMesh fixture_mesh(const Ground& ground, std::span<const Lamp> posts, std::span<const Lamp> lit);

// The light of lamps on track and trains, seen from above: two bytes for each square of kLampCell, the light, and its
// height between `heights.x` and `heights.x + heights.y` m.
inline constexpr double kLampCell = 4;  // m
std::vector<std::uint8_t> lamp_map(const Ground& ground, std::span<const Lamp> lamps, glm::vec2 heights);

}  // namespace coaster::sim
