// Which patches of the land a view shows, and how finely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/land_mesh.h"

namespace coaster::gfx {

struct Box {
  glm::vec3 low{0}, high{0};  // m
};
// Returns false if nothing of the box can be in the picture.
bool may_show(const glm::mat4& view_projection, const Box& box);
// Returns the distance from a point to a box; 0 inside.
float distance_to(const Box& box, glm::vec3 from);

struct VisiblePatch {
  std::size_t index = 0;
  float metres = 0;  // from the eye to its box
  int step = 1;      // cells along a side of the drawn ones: 1, 2 or 4
  // Sides on whose border every fourth vertex is drawn, as by the patch beyond: bits 0 to 3 for -x, +x, -z, +z. All of
  // them with steps above 1.
  std::uint8_t snapped = 0;
};
inline constexpr std::uint8_t kAllSides = 15;
inline constexpr float kPlantHeight = 14;  // m over the land that a patch's box includes

// Returns the patches in the picture, the nearest first. `near` scales the distances up to which they are fine.
std::vector<VisiblePatch> visible_patches(std::span<const sim::LandPatch> patches, const glm::mat4& view_projection,
                                          glm::vec3 eye, float near);

// Returns the triangles of a patch with a step and its snapped sides, as indices of its vertices.
std::vector<std::uint16_t> patch_indices(int step, std::uint8_t snapped);

}  // namespace coaster::gfx
