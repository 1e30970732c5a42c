// The plants on the GPU: one small mesh for each kind and level of detail, and an instance for each plant, kept by
// patch and written only where plants or their light changed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/land_cache.h"
#include "sim/ground/land_mesh.h"
#include "sim/ground/plant_models.h"
#include "sim/ground/plants.h"

namespace coaster::gfx {

class PlantCache {
 public:
  explicit PlantCache(const Gl& gl);

  // Returns the bytes written.
  std::int64_t sync(const sim::Plants& plants, const sim::LandMesh& land);
  void clear() { held_.clear(), ++version_; }
  std::uint64_t version() const { return version_; }  // a new number when plants change

  struct Drawn {
    int draw_calls = 0;
    std::int64_t triangles = 0;
  };
  // Draws grass and flowers within sim::kMeadowReach of the eye, with the program in use: chosen and written anew by
  // each call, the fewer the farther away, on green ground.
  Drawn draw_grass(const sim::LandMesh& land, const sim::Ground& ground, const glm::mat4& view_projection,
                   glm::vec3 eye, bool unseen);
  // Draws the plants of a patch with the program in use (locations 0 position, 1 normal, 2 paint, 4 foot and size, 5
  // cosine and sine of the turn, 6 tint, sun, lamp, and how far the coarse land is below the fine), each group of
  // neighbours at the level of its distance to `eye`; `near` scales the distances up to which trees are detailed.
  Drawn draw(std::size_t patch, glm::vec3 eye, float near, bool unseen) const;
  // Draws them into a shadow map, coarsely. `light`: the map's clip space.
  Drawn cast(const glm::mat4& light, bool unseen) const;

 private:
  static constexpr int kGroups = 4;          // along a patch's side: squares of 16 m
  static constexpr std::size_t kMost = 192;  // plants of a patch
  static constexpr std::size_t kAllGroups = kGroups * kGroups;
  struct Instance {
    glm::vec3 foot{0};  // m
    float size = 1;
    std::array<std::int8_t, 4> turn{};   // cosine and sine, in 1/127
    std::array<std::uint8_t, 4> look{};  // tint, sun, lamp, sinking, in 1/255
  };
  struct Held {
    std::uint64_t plants = 0, light = 0;
    Box box;
    // Where each group's instances of a kind begin, in the patch's own, and their end.
    std::array<std::array<std::uint16_t, kAllGroups + 1>, sim::kPlantKinds> begins{};
  };
  void write(std::size_t patch, std::span<const sim::Plant> plants, const sim::LandMesh& land);
  void link(std::size_t first) const;
  void draw_run(std::size_t patch, std::size_t kind, sim::PlantLevel level, std::size_t begin, std::size_t end,
                bool unseen, Drawn& drawn) const;

  const Gl* gl_;
  GrowingBuffer<sim::LandVertex> vertices_;
  GrowingBuffer<std::uint16_t> indices_;
  GrowingBuffer<Instance> instances_, grass_;
  std::array<std::array<Range, sim::kPlantLevels>, sim::kPlantKinds> models_;  // their indices
  std::array<Range, sim::kMeadowKinds> meadow_;  // of grass and flowers, in the same buffers
  GlObject array_;
  std::vector<Held> held_;
  std::uint64_t version_ = 1;
};

}  // namespace coaster::gfx
