#include "sim/ground/meadow.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

constexpr double kSpacing = 0.45;                          // m between tufts in the densest meadow
constexpr double kBeside = 5.5, kPlaza = 8.5, kPath = 17;  // m: radii about rails and plazas; from the rails to a path
enum MeadowSeed : std::uint32_t { kHere = 201, kAside, kAlong, kSize, kTurn, kFlower, kKind, kPatches };

bool at_station(std::span<const glm::dvec3> stations, glm::dvec2 at) {
  return std::ranges::any_of(stations, [&](const glm::dvec3& station) {
    return glm::distance(glm::dvec2(station.x, station.y), at) < station.z;
  });
}

// Returns circles (x, z, radius) within reach of the eye: stations with their plazas and paths on the right.
std::vector<glm::dvec3> stations_near(const Ground& ground, glm::vec3 eye) {
  std::vector<glm::dvec3> circles;
  glm::dvec3 middle(0), aside(0);
  const auto add = [&](glm::dvec3 at, double radius) { circles.emplace_back(at.x, at.z, radius); };
  double stations = 0;
  for (const TrackSample& sample : ground.samples()) {
    if (!sample.station) continue;
    aside = glm::cross(sample.forward, sample.up);
    add(sample.at, kBeside), add(sample.at + kPlaza * aside, kPlaza);
    middle += sample.at, ++stations;
  }
  if (stations > 0) add(middle / stations + kPath * aside, kPlaza);
  std::erase_if(circles, [&](const glm::dvec3& circle) {
    return glm::distance(glm::dvec2(circle.x, circle.y), glm::dvec2(eye.x, eye.z)) > kMeadowReach + circle.z;
  });
  return circles;
}

// Returns how bright green ground is, 0..1; negative for all other.
float green(const LandFinish& finish) {
  const glm::vec3 paint(finish.paint[0], finish.paint[1], finish.paint[2]);
  if (paint.y < 1.03f * paint.x || paint.y < 1.25f * paint.z) return -1;
  const float red = paint.x / 255;
  return glm::clamp((red * red - 0.12f) / 0.17f, 0.0f, 1.0f);
}

}  // namespace

std::vector<MeadowPlant> meadow_around(const LandMesh& land, const Ground& ground, glm::vec3 eye) {
  std::vector<MeadowPlant> plants;
  const double over = double{eye.y} - ground.height(double{eye.x}, double{eye.z}), reach = kMeadowReach;
  if (over > reach) return plants;
  const std::vector<glm::dvec3> stations = stations_near(ground, eye);
  const std::uint32_t seed = ground.land().park().seed;
  const auto cell = [&](double v) { return static_cast<int>(std::floor(v / kSpacing)); };
  for (int z = cell(double{eye.z} - reach); z <= cell(double{eye.z} + reach); ++z) {
    for (int x = cell(double{eye.x} - reach); x <= cell(double{eye.x} + reach); ++x) {
      const auto chance = [&](MeadowSeed which) { return random_at(x, z, seed + which); };
      const glm::dvec2 at = kSpacing * (glm::dvec2(x, z) + glm::dvec2(chance(kAside), chance(kAlong)));
      const double level = glm::distance(at, glm::dvec2(eye.x, eye.z));
      // How far a tuft of this rank shows; few show far away.
      const double rank = chance(kHere), shows = reach * (1 - 0.82 * std::sqrt(rank));
      const double part = 1 - std::sqrt(level * level + over * over) / shows;
      if (part <= 0 || !ground.in_square(at.x, at.y)) continue;
      const float tint = green(land.finish_at(at.x, at.y));
      if (tint < 0 || at_station(stations, at)) continue;
      const double height = ground.height(at.x, at.y);
      if (height < ground.water() + 0.3) continue;
      const bool flower = chance(kFlower) < 0.16 * smooth_step(0.0, 0.7, noise(at.x / 17, at.y / 17, seed + kPatches));
      MeadowPlant& plant = plants.emplace_back();
      plant.foot = glm::vec3(at.x, height, at.y);
      plant.size = static_cast<float>((0.5 + 0.6 * chance(kSize)) * std::fmin(3 * part, 1));
      const base::SinCos turned = base::sin_cos(6.2831853 * chance(kTurn));
      plant.turn = glm::vec2(turned.cos, turned.sin);
      plant.tint = glm::clamp(tint + 0.25f * static_cast<float>(chance(kKind) - 0.5), 0.0f, 1.0f);
      plant.kind = flower ? 1 + static_cast<std::size_t>(2.999 * chance(kKind)) : 0;
    }
  }
  return plants;
}

}  // namespace coaster::sim
