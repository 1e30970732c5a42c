// What a theme makes of sky, ground and light.
#pragma once

#include <glm/glm.hpp>

#include "world/settings.h"

namespace coaster::gfx {

// Colours as they look on the screen (sRGB, 0..1), but for grid_light.
struct Scenery {
  glm::vec3 horizon{0.847f, 0.902f, 0.949f}, zenith{0.424f, 0.612f, 0.796f}, ground{0.561f, 0.682f, 0.486f};
  glm::vec3 grid_light{0};  // linear light that the ground's lines add, times how much of a line there is
  float glow = 1;           // of the sky around the sun
  float lift = 1;           // of painted parts
  glm::vec4 shadow{0.14f, 0.23f, 0.24f, 0.58f};
  glm::vec3 around{27 / 255.0f, 31 / 255.0f, 39 / 255.0f};  // #1B1F27, beside the viewport
};

// By world::Theme: a summer's day for dark and light panels; nearly black, with bright lines and paint, for high contrast.
const Scenery& scenery_of(world::Theme theme);

}  // namespace coaster::gfx
