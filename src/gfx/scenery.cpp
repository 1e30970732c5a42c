#include "gfx/scenery.h"

namespace coaster::gfx {

const Scenery& scenery_of(world::Theme theme) {
  // A line of the ground is so much lighter than what lies under it: the ground's own linear light, gamma 2.2, once more.
  constexpr glm::vec3 kGrassLight{0.28036f, 0.43085f, 0.20446f};
  static constexpr Scenery kDay{.grid_light = kGrassLight};
  static constexpr Scenery kPale{.grid_light = kGrassLight, .around = {243 / 255.0f, 244 / 255.0f, 246 / 255.0f}};
  static constexpr Scenery kNight{.horizon = {0.11f, 0.11f, 0.12f}, .zenith = {0, 0, 0}, .ground = {0.09f, 0.09f, 0.09f}, .grid_light = {0.9f, 0.9f, 0.9f}, .glow = 0,
                                  .lift = 1.8f, .shadow = {0.42f, 0.42f, 0.42f, 0.7f}, .around = {0, 0, 0}};
  switch (theme) {
    case world::Theme::dark: return kDay;
    case world::Theme::light: return kPale;
    case world::Theme::high_contrast: return kNight;
  }
  return kDay;
}

}  // namespace coaster::gfx
