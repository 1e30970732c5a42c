// The solids of tunnels: tubes along the track's frame, portals in front of them, and the cells of the ground that are
// left open there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/ground.h"

namespace coaster::sim {

struct EarthVertex {
  glm::vec3 position{0}, normal{0, 1, 0};
  glm::vec3 paint{0};  // linear light, as sunlight shows it
  float ambient = 1;   // 0..1, how much of the sky's light reaches it; below 0.5: no sunlight does
};
struct EarthMesh {
  std::vector<EarthVertex> vertices;
  std::vector<std::uint32_t> indices;  // triangles, counter-clockwise from outside
  // Adds a quad of two triangles: the corners in their order around, and `ambient` of each.
  void add_quad(const std::array<glm::vec3, 4>& corners, glm::vec3 normal, glm::vec3 paint,
                const std::array<float, 4>& ambient);
};
// Returns the tubes and portals of all tunnels. Stone in most lands, of the land's colour.
EarthMesh tunnel_mesh(const Ground& ground);

// True if the cell whose lower corner is this vertex is left out of the drawn ground, because a tunnel's mouth is
// there.
bool is_open(const Ground& ground, GroundVertex cell);

}  // namespace coaster::sim
