// The formulas of the lands. A change of one needs a new version of its name in files (world::LandRow::in_file).
#include "sim/ground/land.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

// Each noise has a seed of its own, added to the park's.
enum NoiseSeed : std::uint32_t {
  kRolling = 0,
  kPonds = 7,
  kShore = 9,
  kPlaces = 13,
  kBends = 23,
  kHills = 50,
  kTerraces = 77
};

struct Relief {
  double rolling, width;               // m, height and width of rolling ground
  double hills, hills_from, hills_to;  // m, their height; distances at which they begin and are full
  double terrace, bare_from, bare_to;  // m, height of a step; the noise from which on there are steps
};

constexpr std::array<Relief, base::count_of<world::Land>()> kReliefs{{
    {0, 1, 0, 0, 1, 0, 0, 1},               // plain
    {3, 120, 0, 0, 1, 0, 0, 1},             // meadow
    {11, 120, 60, 90, 330, 7, 0.3, 0.6},    // hills
    {6, 120, 90, 60, 260, 0, 0, 1},         // valley
    {11, 120, 60, 80, 300, 12, -0.2, 0.2},  // cliffs
    {8, 120, 26, 30, 120, 0, 0, 1},         // island
    {9, 160, 40, 90, 300, 9, -0.1, 0.3},    // desert
    {11, 120, 80, 90, 330, 0, 0, 1},        // snow
}};

// A level unit vector by a number of the seed, without functions of libm.
glm::dvec2 seed_direction(std::uint32_t seed, std::int32_t which) {
  const double x = 2 * random_at(which, 0, seed + kPlaces) - 1, z = 2 * random_at(which, 1, seed + kPlaces) - 1;
  const double length = std::sqrt(x * x + z * z);
  return length > 0.1 ? glm::dvec2(x / length, z / length) : glm::dvec2(0.6, 0.8);
}

class SeededLand {
 public:
  SeededLand(const world::Park& park, double x, double z)
      : park_(park),
        relief_(kReliefs[static_cast<std::size_t>(park.land)]),
        x_(x),
        z_(z),
        from_origin_(std::sqrt(x * x + z * z)),
        bent_x_(x + 45 * octaves(2, x / 140 + 0.3, z / 140 + 0.7, park.seed + kBends)),
        bent_z_(z + 45 * octaves(2, x / 140 + 8.1, z / 140 + 5.9, park.seed + kBends)) {}

  double height() const {
    const std::uint32_t seed = park_.seed;
    // The whole rises a little, so that more of it is land than water.
    double h = relief_.rolling * (0.17 + octaves(5, x_ / relief_.width, z_ / relief_.width, seed + kRolling)) + hills();
    h = stepped(h * park_.relief);
    h = with_water(h);
    return h * level_start() * far_out();
  }

 private:
  double hills() const {
    if (relief_.hills == 0) return 0;
    const double fold = noise(bent_x_ / 260 + 3.1, bent_z_ / 260 + 1.7, park_.seed + kHills) +
                        0.22 * noise(bent_x_ / 95, bent_z_ / 95, park_.seed + kHills + 1);
    const double ridge = 1 - std::fmin(std::fabs(fold), 1.0);
    double from = from_origin_;
    if (park_.land == world::Land::valley) from = std::fabs(beside_river());
    return 0.9 * relief_.hills * (ridge * ridge * ridge - 0.1) *
           smooth_step(relief_.hills_from, relief_.hills_to, from);
  }

  double stepped(double h) const {
    if (relief_.terrace == 0 || h <= 2) return h;
    const double much = smooth_step(relief_.bare_from, relief_.bare_to,
                                    noise(bent_x_ / 150 + 9, bent_z_ / 150 - 4, park_.seed + kTerraces));
    const double step = h / relief_.terrace, whole = std::floor(step);
    const double terraced = relief_.terrace * (whole + smooth_step(0.35, 0.65, step - whole));
    return mixed(h, terraced, much * smooth_step(2, 4, h));
  }

  // Distance (m) from the river's middle, across the valley; the station is on one bank.
  double beside_river() const {
    const glm::dvec2 along = seed_direction(park_.seed, 0);
    const double across = z_ * along.x - x_ * along.y - 60, down = x_ * along.x + z_ * along.y;
    return across + 34 * noise(down / 120, 0.5, park_.seed + kShore);
  }

  double with_water(double h) const {
    const std::uint32_t seed = park_.seed;
    switch (park_.land) {
      case world::Land::plain:
      case world::Land::desert: return h;
      case world::Land::meadow:
        return mixed(h, -3.5, smooth_step(0.3, 0.55, noise(bent_x_ / 85, bent_z_ / 85, seed + kPonds)));
      case world::Land::valley: return mixed(h, -4, 1 - smooth_step(9, 26, std::fabs(beside_river())));
      case world::Land::island:
        return mixed(h, -14, smooth_step(150, 300, from_origin_ + 60 * octaves(3, x_ / 90, z_ / 90, seed + kShore)));
      case world::Land::hills:
      case world::Land::cliffs:
      case world::Land::snow: break;
    }
    constexpr double kLake = 115, kAway = 122;  // m, its radius and how far it is from the origin
    const glm::dvec2 middle = kAway * seed_direction(seed, 1);
    const double dx = x_ - middle.x, dz = z_ - middle.y;
    const double l = std::sqrt(dx * dx + 1.6 * dz * dz) + 16 * octaves(3, x_ / 40, z_ / 40, seed + kShore);
    return mixed(h, -6, 1 - smooth_step(kLake / 4, kLake, l));
  }

  // 0 on level ground of 48 x 24 m about the origin, where tracks begin; 1 from 26 m beside it on.
  double level_start() const {
    const double dx = std::fmax(std::fabs(x_) - 24, 0.0), dz = std::fmax(std::fabs(z_) - 12, 0.0);
    return smooth_step(0, 26, std::sqrt(dx * dx + dz * dz));
  }
  double far_out() const {
    const double out = std::fmax(std::fabs(x_), std::fabs(z_)) / (0.5 * world::kGroundSquare);
    return 1 - smooth_step(1.5, 7, out);
  }

  const world::Park& park_;
  const Relief& relief_;
  double x_, z_, from_origin_, bent_x_, bent_z_;  // m; bent: the place in wavy coordinates, against straight ridges
};

}  // namespace

TileVertex tile_vertex(GroundVertex at) {
  constexpr int kCells = world::kGroundTileCells;
  const auto tile = [](int vertex) { return vertex >= 0 ? vertex / kCells : -((kCells - 1 - vertex) / kCells); };
  const int x = tile(at.x), z = tile(at.z), column = at.x - x * kCells, row = at.z - z * kCells;
  return {{static_cast<std::int16_t>(x), static_cast<std::int16_t>(z)},
          static_cast<std::size_t>(row * kCells + column),
          static_cast<std::size_t>(row / 2 * (kCells / 2) + column / 2)};
}

double Land::seeded(double x, double z) const {
  if (plain()) return 0;
  const double h = SeededLand(park_, x, z).height();
  return std::clamp(h, -world::kHighestGround, world::kHighestGround);
}

double Land::vertex(GroundVertex at) const {
  if (plain()) return 0;
  if (!park_.tiles.empty()) {
    const TileVertex held = tile_vertex(at);
    if (const world::GroundTile* const tile = park_.tiles.find(held.tile)) {
      const std::int16_t height = tile->heights[held.height];
      if (height != world::GroundTile::kSeeded) return height * world::kHeightStep;
    }
  }
  return seeded(at.x * world::kGroundCell, at.z * world::kGroundCell);
}

double Land::height(double x, double z) const {
  if (plain()) return 0;
  if (!(std::fabs(x) < 1e7) || !(std::fabs(z) < 1e7)) return 0;
  return height_between(x, z, [&](GroundVertex at) { return vertex(at); });
}

double Land::standing(double x, double z, double over) const {
  return std::round(surface(x, z) / world::kHeightStep) * world::kHeightStep + over;
}

double Land::depth(glm::dvec3 rails) const {
  if (plain()) return -rails.y;
  constexpr double kDry = -std::numeric_limits<double>::infinity();
  if (!(rails.y < park_.water)) return park_.water > world::kNoWater ? park_.water - rails.y : kDry;
  return height(rails.x, rails.z) < rails.y + kLeastOverhead ? park_.water - rails.y : kDry;
}

std::optional<double> Land::meet(glm::dvec3 origin, glm::dvec3 direction, double most) const {
  return meet_heights(origin, direction, most, [&](double x, double z) { return surface(x, z); });
}

}  // namespace coaster::sim
