// The ground: the land as it is cut to the track, in tiles of 64 m that are built again where track or land changed.
// Supports, cameras, picking and near misses ask it; plans ask the land (sim/ground/land.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/ground/earthworks.h"

namespace coaster::sim {

// Heights of 32x32 cells, with the vertices on all four sides.
struct GroundPatch {
  static constexpr int kSide = world::kGroundTileCells + 1;
  static constexpr double kLength = world::kGroundTileCells * world::kGroundCell;  // m
  world::TilePlace place;
  std::array<float, kSide * kSide> land{}, heights{};  // m, rows along x: before the cut, and after it
  float low = 0, high = 0;                             // m, of `heights`
  std::uint64_t build = 0;                             // a new number when heights change
  float height(int x, int z) const { return heights[static_cast<std::size_t>(z * kSide + x)]; }
  glm::vec2 corner() const { return float(kLength) * glm::vec2(place.x, place.z); }
};

// An end of a tunnel: the middle of the rails there, and the level direction into the tunnel.
struct TunnelGate {
  glm::dvec3 at{0};
  glm::dvec2 inwards{1, 0};  // unit, (x, z)
  // Returns the way from the gate to a place (x, z), and its parts along `inwards` and across them, m.
  glm::dvec2 level_way_to(glm::dvec2 place) const { return place - glm::dvec2(at.x, at.z); }
  double behind(glm::dvec2 place) const { return glm::dot(level_way_to(place), inwards); }
  double aside(glm::dvec2 place) const {
    const glm::dvec2 from = level_way_to(place);
    return std::fabs(from.x * inwards.y - from.y * inwards.x);
  }
};

class Ground {
 public:
  static constexpr int kUsualTiles = 12;  // across: 768 m; kGroundTilesAcross where track leaves that square

  // Brings the ground up to date: costs some nanoseconds a segment if nothing changed, below a millisecond for each
  // tile near changed track or touched by a brush.
  void update(const world::Document& document, const DerivedTrack& derived, const TrackRoom& room);

  // Without a land the ground is the plane y = 0, and has no patches.
  bool plain() const { return land_.plain(); }
  const Land& land() const { return land_; }
  double water() const { return land_.plain() ? world::kNoWater : land_.park().water; }  // m
  // Returns the height (m) of the ground at (x, z): on the drawn triangles within the square; beyond it the land's.
  double height(double x, double z) const;
  // Returns the height of what one sees from above: ground or water.
  double surface(double x, double z) const { return std::fmax(height(x, z), water()); }
  // Returns the distance (m) at which a ray from `origin` along the unit `direction` first meets the ground, at most
  // `most`; nothing if it does not, or begins below it.
  std::optional<double> meet(glm::dvec3 origin, glm::dvec3 direction, double most = 5000) const;
  bool in_square(double x, double z) const;
  // Calls visit(patch), by index, row by row: for the patches that have ground within `reach` m of a place to each
  // side, and for those that touch a patch, and itself.
  void each_patch_near(glm::dvec3 at, double reach, const auto& visit) const;
  void each_patch_around(std::size_t patch, const auto& visit) const;

  int tiles_across() const { return across_; }                       // 0: plain
  std::span<const GroundPatch> patches() const { return patches_; }  // row by row
  const TrackRoom& room() const { return room_; }
  std::span<const TrackSample> samples() const { return samples_; }  // of the track, in its order
  std::span<const Tunnel> tunnels() const { return tunnels_; }
  std::span<const TunnelGate> gates() const { return gates_; }  // two of each tunnel, in the tunnels' order
  std::uint64_t build() const { return build_; }                // a new number when anything of this changes
  int rebuilds() const { return rebuilds_; }                    // patches built in the last update
  // Returns a number that differs if the ground below or above a box has changed; 0: plain.
  std::uint64_t build_under(const curve::Box& box) const;
  // Returns the tunnel at a place of the track, in m from its start; null if there is none.
  const Tunnel* tunnel_at(double distance) const;

 private:
  struct SegmentSamples {
    std::uint64_t shape_build = 0;
    world::Earthwork wish{};
    bool station = false;
    std::vector<TrackSample> samples;
  };
  void take_square(const DerivedTrack& derived);
  bool take_samples(const world::Document& document, const DerivedTrack& derived, bool all);
  void find_gates();
  void each_patch(glm::ivec2 first, glm::ivec2 last, const auto& visit) const;
  void mark_near(const TrackSample& sample);
  void build_patches();
  struct Digging;
  std::vector<Digging> digging_near(const GroundPatch& patch, std::span<const std::size_t> near) const;
  void build_patch(GroundPatch& patch, bool new_land, std::span<const std::size_t> near) const;
  float cut(GroundVertex vertex, float land, std::span<const Digging> near) const;
  double behind_gates(glm::dvec2 at) const;
  const GroundPatch* patch_at(world::TilePlace place) const;

  Land land_;
  TrackRoom room_;
  int across_ = 0;
  std::vector<GroundPatch> patches_;
  std::vector<std::uint8_t> stale_;       // by patch: 1 its cut, 2 its land, too
  world::Pool<SegmentSamples> segments_;  // by segment entity
  std::vector<world::Entity> order_;
  std::vector<TrackSample> samples_;
  std::vector<Tunnel> tunnels_;
  std::vector<TunnelGate> gates_;
  std::uint64_t last_build_ = 0, build_ = 0, land_build_ = 0;  // land_build_: of the land, or of the square
  double track_length_ = 0;                                    // m
  int rebuilds_ = 0;
};

// From one column and row to another one, as far as there are patches.
void Ground::each_patch(glm::ivec2 first, glm::ivec2 last, const auto& visit) const {
  for (int z = std::max(first.y, 0); z <= std::min(last.y, across_ - 1); ++z)
    for (int x = std::max(first.x, 0); x <= std::min(last.x, across_ - 1); ++x)
      visit(static_cast<std::size_t>(z * across_ + x));
}
void Ground::each_patch_near(glm::dvec3 at, double reach, const auto& visit) const {
  const glm::dvec2 place(at.x, at.z);
  const auto patch = [&](glm::dvec2 p) { return glm::ivec2(glm::floor(p / GroundPatch::kLength)) + across_ / 2; };
  each_patch(patch(place - reach), patch(place + reach), visit);
}
void Ground::each_patch_around(std::size_t patch, const auto& visit) const {
  const glm::ivec2 at(static_cast<int>(patch) % across_, static_cast<int>(patch) / across_);
  each_patch(at - 1, at + 1, visit);
}

}  // namespace coaster::sim
