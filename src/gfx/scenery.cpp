// The table of styles, in the order of world::Style.
#include "gfx/scenery.h"

#include <array>
#include <cmath>

#include "base/check.h"
#include "world/appearance_settings.h"

namespace coaster::gfx {
namespace {

constexpr glm::vec3 rgb(unsigned hex) {
  return {float(hex >> 16 & 255u) / 255.0f, float(hex >> 8 & 255u) / 255.0f, float(hex & 255u) / 255.0f};
}

constexpr SceneStyle kDay{.sun = {0.4216f, 0.7792f, 0.4638f},
                          .sun_light = {1.10f, 0.99f, 0.82f},
                          .sky_light = {0.36f, 0.44f, 0.56f},
                          .ground_light = {0.21f, 0.23f, 0.16f},
                          .penumbra = 0.008f,
                          .horizon = rgb(0xd3e2ee),
                          .haze = rgb(0xe6e9e4),
                          .haze_width = 3,
                          .middle = rgb(0x9cc3e6),
                          .zenith = rgb(0x4d84bd),
                          .clouds = 0.55f,
                          .glow = {0.55f, 0.46f, 0.30f},
                          .disc = 1,
                          .fog_metres = 820,
                          .hills = rgb(0x6b8f86),
                          .hills_height = 0.055f,
                          .ground = rgb(0x80a56b),
                          .uneven = 0.10f,
                          .grid = rgb(0xa6c28f),
                          .grid_strength = 0.75f,
                          .shade = 0.86f};

constexpr SceneStyle kDusk{.sun = {-0.800f, 0.215f, -0.560f},
                           .sun_light = {1.95f, 0.98f, 0.46f},
                           .sky_light = {0.36f, 0.35f, 0.52f},
                           .ground_light = {0.24f, 0.18f, 0.19f},
                           .penumbra = 0.006f,
                           .reflections = 1.1f,
                           .lamps = 0.55f,
                           .horizon = rgb(0x8a7396),
                           .haze = rgb(0xf6a76c),
                           .haze_width = 4,
                           .middle = rgb(0x7a6a9c),
                           .zenith = rgb(0x2a2f5e),
                           .clouds = 0.5f,
                           .glow = {1.0f, 0.50f, 0.20f},
                           .disc = 2,
                           .fog_metres = 700,
                           .hills = rgb(0x3b3556),
                           .hills_height = 0.060f,
                           .ground = rgb(0x6d7350),
                           .uneven = 0.10f,
                           .grid = rgb(0x918d66),
                           .grid_strength = 0.7f,
                           .shade = 0.92f};

constexpr SceneStyle kNight{.sun = {0.55f, 0.62f, -0.45f},
                            .sun_light = {0.10f, 0.135f, 0.21f},
                            .sky_light = {0.040f, 0.055f, 0.100f},
                            .ground_light = {0.020f, 0.022f, 0.030f},
                            .penumbra = 0.006f,
                            .lamps = 0.8f,
                            .horizon = rgb(0x1d2742),
                            .haze = rgb(0x27304f),
                            .haze_width = 3,
                            .middle = rgb(0x131b35),
                            .zenith = rgb(0x060a1c),
                            .night = true,
                            .clouds = 0.22f,
                            .glow = {0.05f, 0.06f, 0.09f},
                            .disc = 0.9f,
                            .fog_metres = 900,
                            .hills = rgb(0x0c1226),
                            .hills_height = 0.060f,
                            .ground = rgb(0x2a3340),
                            .uneven = 0.10f,
                            .grid = rgb(0x3a4350),
                            .grid_strength = 0.5f,
                            .shade = 0.9f};

constexpr SceneStyle kBlueprint{.drawing = true,
                                .sun = {0.4216f, 0.7792f, 0.4638f},
                                .penumbra = 0.004f,
                                .reflections = 0,
                                .horizon = rgb(0x0f2a47),
                                .haze = rgb(0x0f2a47),
                                .middle = rgb(0x0f2a47),
                                .zenith = rgb(0x0f2a47),
                                .fog_metres = 900,
                                .ground = rgb(0x0f2a47),
                                .grid = rgb(0x9fc6ea),
                                .grid_strength = 0.34f,
                                .shade = 0.55f,
                                .ink = rgb(0x9fc6ea)};

constexpr std::array<const SceneStyle*, base::count_of<world::Style>()> kStyles{&kDay, &kDusk, &kNight, &kBlueprint};

float linear(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }
glm::vec3 linear(glm::vec3 c) { return {linear(c.x), linear(c.y), linear(c.z)}; }

// Layout of the shaders' uniform block `Air` (shaders/common.glsl): linear light, 16 bytes per member. Blocks read
// binding 0 by default.
constexpr GLuint kAirBinding = 0;
struct Air {
  glm::vec4 sun, sun_light, sky_light, ground_light, horizon, haze, middle, zenith, glow, hills, ground, grid, ink;
};

Air air_of(const SceneStyle& s) {
  const glm::vec3 sun = glm::normalize(s.sun);
  // The paint that gives the ground the table's colour in sunlight.
  const glm::vec3 lit = s.drawing ? glm::vec3(1) : s.sun_light * sun.y + s.sky_light;
  Air air;
  air.sun = {sun, s.drawing ? 1 : 0};
  air.sun_light = {s.sun_light, s.reflections};
  air.sky_light = {s.sky_light, s.penumbra};
  air.ground_light = {s.ground_light, s.lamps};
  air.horizon = {linear(s.horizon), s.fog_metres};
  air.haze = {linear(s.haze), s.haze_width};
  air.middle = {linear(s.middle), s.clouds};
  air.zenith = {linear(s.zenith), s.night ? 1 : 0};
  air.glow = {s.glow, s.disc};
  air.hills = {linear(s.hills_height > 0 ? s.hills : s.horizon), s.hills_height};
  air.ground = {linear(s.ground) / lit, s.uneven};
  air.grid = {linear(s.grid) / lit, s.grid_strength};
  air.ink = {linear(s.ink), s.shade};
  return air;
}

}  // namespace

const SceneStyle& scenery_of(world::Style style) {
  COASTER_CHECK(static_cast<std::size_t>(style) < kStyles.size(), "styles are rows of the table");
  return *kStyles[static_cast<std::size_t>(style)];
}

glm::vec3 around_of(world::Theme theme) {
  switch (theme) {
    case world::Theme::dark: return rgb(0x1b1f27);
    case world::Theme::light: return rgb(0xf3f4f6);
    case world::Theme::high_contrast: return rgb(0x000000);
  }
  return rgb(0x1b1f27);
}

void SceneStyleBuffer::bind(const SceneStyle& scenery) {
  gl_->BindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
  if (written_ != &scenery) {
    const Air air = air_of(scenery);
    gl_->BufferData(GL_UNIFORM_BUFFER, sizeof air, &air, GL_STATIC_DRAW);
    written_ = &scenery;
  }
  gl_->BindBufferBase(GL_UNIFORM_BUFFER, kAirBinding, buffer_.id());
}

}  // namespace coaster::gfx
