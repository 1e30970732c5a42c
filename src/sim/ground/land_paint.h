// Colours of the land: grass, rock, sand, snow, the beds of lakes, earth under low track.
#pragma once

#include <glm/glm.hpp>

#include "world/park.h"

namespace coaster::sim {

struct LandPlace {
  double x = 0, z = 0;
  float height = 0;   // m
  float upright = 1;  // y of the unit normal
  float wood = 0;     // 0..1, shade of crowns
  float earth = 0;    // 0..1, earth under low track
};
// Returns the paint of a place as linear light, before sun and sky.
glm::vec3 land_paint(const world::Park& park, const LandPlace& place);

// Returns how wooded the far land is at a place, 0..1: it has no trees.
float far_woods(const world::Park& park, double x, double z);

}  // namespace coaster::sim
