#include "sim/ground/land_paint.h"

#include <array>

#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

// Each noise has a seed of its own, added to the park's.
enum PaintSeed : std::uint32_t { kMeadows = 30, kBare = 31, kLayers = 32, kBeach = 33, kFarWoods = 5 };

struct LandColours {
  glm::vec3 grass_dark, grass_bright, forest;
  glm::vec3 rock_dark, rock_bright;
  glm::vec3 sand, bed, earth;
  float rock_from, rock_to;  // grass begins and is whole, by the y of the normal
  float beach;               // m of sand above the water
};
constexpr LandColours kTemperate{.grass_dark = {0.125f, 0.235f, 0.052f},
                                 .grass_bright = {0.275f, 0.315f, 0.085f},
                                 .forest = {0.085f, 0.125f, 0.040f},
                                 .rock_dark = {0.26f, 0.235f, 0.205f},
                                 .rock_bright = {0.40f, 0.36f, 0.31f},
                                 .sand = {0.50f, 0.42f, 0.27f},
                                 .bed = {0.10f, 0.13f, 0.10f},
                                 .earth = {0.30f, 0.22f, 0.13f},
                                 .rock_from = 0.70f,
                                 .rock_to = 0.84f,
                                 .beach = 1.1f};
constexpr LandColours meadow() {
  LandColours c = kTemperate;
  c.grass_dark = {0.140f, 0.265f, 0.050f}, c.grass_bright = {0.325f, 0.375f, 0.085f};
  return c;
}
constexpr LandColours cliffs() {
  LandColours c = kTemperate;
  c.rock_dark = {0.235f, 0.205f, 0.185f}, c.rock_bright = {0.43f, 0.375f, 0.31f}, c.rock_from = 0.76f, c.rock_to = 0.9f;
  return c;
}
constexpr LandColours island() {
  LandColours c = kTemperate;
  c.grass_dark = {0.130f, 0.270f, 0.065f}, c.grass_bright = {0.300f, 0.370f, 0.110f};
  c.sand = {0.66f, 0.56f, 0.37f}, c.bed = {0.34f, 0.36f, 0.25f}, c.beach = 2.6f;
  return c;
}
constexpr LandColours desert() {
  LandColours c = kTemperate;
  c.grass_dark = {0.47f, 0.315f, 0.165f}, c.grass_bright = {0.60f, 0.435f, 0.245f};
  c.forest = {0.30f, 0.215f, 0.11f};
  c.rock_dark = {0.34f, 0.150f, 0.080f}, c.rock_bright = {0.54f, 0.290f, 0.160f};
  c.earth = {0.40f, 0.265f, 0.145f}, c.rock_from = 0.74f, c.rock_to = 0.88f;
  return c;
}
constexpr LandColours snow() {
  LandColours c = kTemperate;
  c.grass_dark = {0.70f, 0.745f, 0.81f}, c.grass_bright = {0.80f, 0.82f, 0.85f};
  c.forest = {0.40f, 0.44f, 0.48f};
  c.rock_dark = {0.20f, 0.20f, 0.21f}, c.rock_bright = {0.34f, 0.34f, 0.35f};
  c.sand = {0.44f, 0.45f, 0.46f}, c.earth = {0.36f, 0.32f, 0.28f}, c.rock_from = 0.66f, c.rock_to = 0.78f,
  c.beach = 0.7f;
  return c;
}
constexpr std::array<LandColours, 8> kColours{
    // in the order of world::Land
    kTemperate, meadow(), kTemperate, kTemperate, cliffs(), island(), desert(), snow()};
static_assert(kColours.size() == base::count_of<world::Land>());

float noise_at(const LandPlace& at, double width, std::uint32_t seed) {
  return static_cast<float>(noise(at.x / width, at.z / width, seed));
}

}  // namespace

glm::vec3 land_paint(const world::Park& park, const LandPlace& at) {
  const LandColours& c = kColours[static_cast<std::size_t>(park.land)];
  const auto meadows = static_cast<float>(octaves(3, at.x / 45, at.z / 45, park.seed + kMeadows));
  glm::vec3 paint = glm::mix(c.grass_dark, c.grass_bright, glm::clamp(0.5f + 0.9f * meadows, 0.0f, 1.0f));
  paint = glm::mix(paint, c.forest, 0.75f * at.wood);
  if (at.upright < c.rock_to + 0.06f) {
    const float grass =
        glm::smoothstep(c.rock_from, c.rock_to, at.upright + 0.05f * noise_at(at, 5, park.seed + kBare));
    const auto layers =
        static_cast<float>(noise((at.x + at.z) / 18, 0.55 * static_cast<double>(at.height), park.seed + kLayers));
    paint = glm::mix(glm::mix(c.rock_dark, c.rock_bright, 0.5f + 0.5f * layers), paint, grass);
  }
  const auto water = static_cast<float>(park.water);
  if (at.height < water + c.beach + 1) {
    const float uneven = 0.5f * noise_at(at, 7, park.seed + kBeach);
    paint = glm::mix(c.sand, paint, glm::smoothstep(water + 0.1f, water + c.beach, at.height + uneven));
    paint = glm::mix(c.bed, paint, glm::smoothstep(water - 3, water - 0.2f, at.height));
  }
  return glm::mix(paint, c.earth, at.earth);
}

float far_woods(const world::Park& park, double x, double z) {
  const double noisy = 1.5 * noise(x / 70, z / 70, park.seed + kFarWoods);
  return static_cast<float>(glm::clamp(0.62 * (2.2 * park.woods - 1.1 + noisy) + 0.28, 0.0, 0.9));
}

}  // namespace coaster::sim
