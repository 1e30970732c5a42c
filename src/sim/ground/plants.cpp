#include "sim/ground/plants.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

enum PlantSeed : std::uint32_t { kDensity = 5, kDetail = 6, kSort = 8, kPlace = 101 };

struct Flora {
  double trees, conifers, rocks;  // factor of the density of woods; shift towards conifers; part of cells with rocks
};
constexpr Flora kFloras[] = {
    // in the order of world::Land
    {0, 0, 0},        {0.8, -0.5, 0.01}, {1, 0, 0.02},     {1, 0.15, 0.02},
    {0.9, 0.1, 0.05}, {0.9, -0.6, 0.02}, {0.25, -1, 0.06}, {1, 1, 0.02}};

constexpr double kPlantCell = 5;    // m, side of a cell that holds at most one plant
constexpr double kTrackReach = 44;  // m
constexpr double kPatchSide = GroundPatch::kLength;

struct Spot {
  double x, z, height, slope;  // slope: y of the ground's unit normal
};

Spot spot_at(const Ground& ground, double x, double z) {
  const double h = ground.height(x, z), e = 1;
  const double dx = (ground.height(x + e, z) - ground.height(x - e, z)) / (2 * e),
               dz = (ground.height(x, z + e) - ground.height(x, z - e)) / (2 * e);
  return {x, z, h, 1 / std::sqrt(1 + dx * dx + dz * dz)};
}

// How wooded a place is, 0..1 before the random number: by brush, else by noise and the slider.
double density(const Ground& ground, double x, double z) {
  constexpr double kStart = 40;  // m about the origin, where tracks begin
  const world::Park& park = ground.land().park();
  const glm::dvec2 cell = glm::floor(glm::dvec2(x, z) / world::kGroundCell);
  const TileVertex at = tile_vertex({static_cast<int>(cell.x), static_cast<int>(cell.y)});
  const world::GroundTile* const tile = park.tiles.find(at.tile);
  if (tile != nullptr && tile->woods[at.woods] > 0) return (tile->woods[at.woods] - 1) / 254.0;
  if (x * x + z * z < kStart * kStart) return 0;
  const double noisy =
      1.5 * noise(x / 70, z / 70, park.seed + kDensity) + 0.6 * noise(x / 22, z / 22, park.seed + kDetail);
  return kFloras[static_cast<std::size_t>(park.land)].trees *
         std::clamp(0.62 * (2.2 * park.woods - 1.1 + noisy) + 0.28, 0.0, 1.0);
}

bool clear_of_track(const Ground& ground, std::span<const std::size_t> near, const Spot& spot, double size,
                    double top) {
  for (const std::size_t i : near) {
    const TrackSample& sample = ground.samples()[i];
    const double dx = sample.at.x - spot.x, dz = sample.at.z - spot.z, d = std::sqrt(dx * dx + dz * dz);
    if (sample.tunnel) {
      if (d < 2.5) return false;  // roots
      continue;
    }
    if (d < (sample.station ? 12 : 3.5) + 3.4 * size) return false;
    if (spot.height + top > sample.at.y - 2 + 3 * d) return false;
  }
  for (const TunnelGate& gate : ground.gates()) {
    const glm::dvec2 at(spot.x, spot.z), from = gate.level_way_to(at);
    const double behind = gate.behind(at);
    if (behind > -14 && behind < 5 && glm::dot(from, from) < 15.0 * 15.0) return false;
  }
  return true;
}

// The cells of 5 m of one patch, each with at most one plant, all of whose random numbers come from the cell.
class Planter {
 public:
  Planter(const Ground& ground, const GroundPatch& patch)
      : ground_(ground),
        park_(ground.land().park()),
        flora_(kFloras[static_cast<std::size_t>(park_.land)]),
        corner_(patch.corner()) {
    for (std::size_t s = 0; s < ground.samples().size(); ++s) {
      const glm::dvec2 at(ground.samples()[s].at.x, ground.samples()[s].at.z), from = at - corner_;
      if (std::min(from.x, from.y) > -kTrackReach && std::max(from.x, from.y) < kPatchSide + kTrackReach)
        near_.push_back(s);
    }
  }

  std::vector<Plant> plants() const {
    std::vector<Plant> plants;
    for (int z = static_cast<int>(std::floor(corner_.y / kPlantCell)); z * kPlantCell < corner_.y + kPatchSide; ++z)
      for (int x = static_cast<int>(std::floor(corner_.x / kPlantCell)); x * kPlantCell < corner_.x + kPatchSide; ++x)
        if (const auto plant = plant_in(x, z)) plants.push_back(*plant);
    return plants;
  }

 private:
  std::optional<Plant> plant_in(int x, int z) const {
    const auto chance = [&](std::uint32_t which) { return random_at(x, z, park_.seed + kPlace + which); };
    const double px = (x + 0.15 + 0.7 * chance(0)) * kPlantCell, pz = (z + 0.15 + 0.7 * chance(1)) * kPlantCell;
    // A plant belongs to the patch it stands on.
    if (px < corner_.x || px >= corner_.x + kPatchSide || pz < corner_.y || pz >= corner_.y + kPatchSide)
      return std::nullopt;
    const double wooded = density(ground_, px, pz), keep = chance(2);
    const bool tree = keep < wooded, bush = !tree && wooded > 0 && keep < wooded + 0.06;
    const bool rock = !tree && !bush && chance(3) < flora_.rocks;
    if (!tree && !bush && !rock) return std::nullopt;
    const Spot spot = spot_at(ground_, px, pz);
    if (spot.height < ground_.water() + 0.6 || (!rock && spot.slope < 0.82)) return std::nullopt;
    const double size = rock ? 0.4 + 1.1 * chance(4) : bush ? 0.6 + 0.6 * chance(4) : 0.65 + 0.75 * chance(4);
    if (!clear_of_track(ground_, near_, spot, tree ? size : 0.4, (tree ? 9 : 1.6) * size)) return std::nullopt;
    Plant plant{.foot = {px, spot.height, pz}, .size = static_cast<float>(size)};
    const double u = 2 * chance(5) - 1, v = 2 * chance(6) - 1, length = std::sqrt(u * u + v * v);
    if (length > 0.05) plant.turn = {u / length, v / length};
    plant.tint = static_cast<float>(chance(7));
    plant.kind = rock ? PlantKind::rock : bush ? PlantKind::bush : tree_at(spot, chance(8));
    return plant;
  }

  // Conifers on heights, groves of broadleaf trees below.
  PlantKind tree_at(const Spot& spot, double random) const {
    const double sort = noise(spot.x / 90 + 7, spot.z / 90, park_.seed + kSort) + 0.5 * (random - 0.5) +
                        spot.height / 60 + flora_.conifers;
    return sort > 0.05 ? PlantKind::conifer : PlantKind::broadleaf;
  }

  const Ground& ground_;
  const world::Park& park_;
  const Flora& flora_;
  glm::dvec2 corner_;
  std::vector<std::size_t> near_;  // samples of the track
};

bool is_tree(const Plant& plant) { return plant.kind == PlantKind::conifer || plant.kind == PlantKind::broadleaf; }

}  // namespace

void Plants::update(const Ground& ground) {
  if (ground_build_ == ground.build() && across_ == ground.tiles_across()) return;
  ground_build_ = ground.build();
  const std::span<const GroundPatch> patches = ground.patches();
  if (across_ != ground.tiles_across())
    patches_.clear(), patches_.resize(patches.size()), across_ = ground.tiles_across();
  std::vector<std::size_t> stale;
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (patches_[i].ground != patches[i].build) stale.push_back(i);
  ++build_;
  base::in_parts(stale.size(), 1, base::cores(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const GroundPatch& from = patches[stale[k]];
      patches_[stale[k]] = {from.build, build_, from.place, Planter(ground, from).plants()};
    }
  });
  trees_ = 0;
  for (const PatchPlants& patch : patches_) trees_ += static_cast<int>(std::ranges::count_if(patch.plants, is_tree));
}

double Plants::distance(glm::dvec3 at, double most) const {
  double nearest = most;
  constexpr double kCrown = 4;  // m
  for (const PatchPlants& patch : patches_) {
    const double x0 = patch.place.x * kPatchSide, z0 = patch.place.z * kPatchSide, reach = most + kCrown;
    if (at.x < x0 - reach || at.x > x0 + kPatchSide + reach || at.z < z0 - reach || at.z > z0 + kPatchSide + reach)
      continue;
    for (const Plant& plant : patch.plants) {
      if (!is_tree(plant)) continue;
      const double dx = at.x - double{plant.foot.x}, dz = at.z - double{plant.foot.z}, size = double{plant.size};
      const double up = at.y - double{plant.foot.y}, top = kTreeHeight * size;
      // A crown is a cone or a ball over its trunk; both are about this wide at a height.
      const double wide = up < 1.5 * size ? 0.3 : 2.4 * size * (1 - 0.75 * std::clamp(up / top, 0.0, 1.0));
      const double aside = std::fmax(std::sqrt(dx * dx + dz * dz) - wide, 0.0), over = std::fmax(up - top, 0.0);
      nearest = std::fmin(nearest, std::sqrt(aside * aside + over * over));
    }
  }
  return nearest;
}

}  // namespace coaster::sim
