// Trees, bushes and rocks, by rule: clear of track, stations, steep slopes and water. A plant depends only on the
// ground and the track near it, so changing a knot moves no other plant.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/ground.h"

namespace coaster::sim {

enum class PlantKind : std::uint8_t { conifer, broadleaf, bush, rock };

struct Plant {
  glm::vec3 foot{0};     // m, on the ground
  float size = 1;        // factor; a tree of size 1 is 9.8 m high
  glm::vec2 turn{1, 0};  // cosine and sine of its turn about the vertical
  float tint = 0;        // 0..1
  PlantKind kind{};
};
inline constexpr double kTreeHeight = 9.8;  // m, of size 1

class Plants {
 public:
  // Plants the patches that changed, on all cores.
  void update(const Ground& ground);
  // Returns the plants of a patch, by its index in Ground::patches().
  std::span<const Plant> of(std::size_t patch) const { return patches_[patch].plants; }
  std::uint64_t build_of(std::size_t patch) const { return patches_[patch].build; }  // a new number when they change
  std::size_t patches() const { return patches_.size(); }
  int trees() const { return trees_; }  // on all patches, without bushes and rocks
  // Returns the distance (m) from a point to the nearest crown or trunk of a tree; `most` if none is nearer.
  double distance(glm::dvec3 at, double most) const;

 private:
  struct PatchPlants {
    std::uint64_t ground = 0, build = 0;
    world::TilePlace place;
    std::vector<Plant> plants;
  };
  std::vector<PatchPlants> patches_;
  int across_ = 0, trees_ = 0;
  std::uint64_t ground_build_ = 0, build_ = 0;
};

}  // namespace coaster::sim
