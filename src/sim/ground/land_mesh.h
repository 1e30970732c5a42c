// The land as it is drawn: patches of 32x32 cells with normals, paint and the light that reaches them. All of it is a
// pure function of ground, plants, sun and lamps; what did not change is kept.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "sim/ground/ground.h"
#include "sim/ground/lamps.h"
#include "sim/ground/plants.h"

namespace coaster::sim {

// Returns a number of 0..1 in 1/255.
inline std::uint8_t byte_of(float part) {
  return static_cast<std::uint8_t>(std::lround(255 * glm::clamp(part, 0.0f, 1.0f)));
}

// How a vertex of land, or of what stands on it, takes light.
struct LandFinish {
  std::array<std::int8_t, 4> normal{};  // in 1/127; the last is 0
  std::array<std::uint8_t, 4> paint{};  // square roots of linear light, then ambient light, in 1/255
  friend bool operator==(const LandFinish&, const LandFinish&) = default;
};
// `paint`: linear light; `ambient`: the part of the sky's light that arrives. Both are limited to 0..1.
LandFinish land_finish(glm::vec3 normal, glm::vec3 paint, float ambient);
struct LandVertex {
  glm::vec3 position{0};  // m
  LandFinish finish;
  friend bool operator==(const LandVertex&, const LandVertex&) = default;
};
// What reaches a vertex of the sun and of lamps (half of it), in 1/255.
struct LandLight {
  std::uint8_t sun = 255, lamp = 0;
  friend bool operator==(const LandLight&, const LandLight&) = default;
};

// Rows and columns of vertices, both ends included.
struct VertexRect {
  int x0 = 1 << 30, z0 = 1 << 30, x1 = -(1 << 30), z1 = -(1 << 30);
  bool empty() const { return x0 > x1 || z0 > z1; }
  void add(int x, int z);
  void add(const VertexRect& other);
  VertexRect grown(int by) const { return empty() ? *this : VertexRect{x0 - by, z0 - by, x1 + by, z1 + by}; }
  VertexRect within(const VertexRect& other) const;
};

// Heights and what lies on them for the whole square, by vertices of kGroundCell.
struct LandField {
  int across = 0;                         // cells along the square's side
  std::vector<float> heights;             // m
  std::vector<std::uint8_t> wood, earth;  // shade of crowns; earth under low track: in 1/255
  int side() const { return across + 1; }
  // Places beyond the square count as its edge.
  std::size_t at(int x, int z) const;
  float height(int x, int z) const { return heights[at(x, z)]; }
  float half() const { return 0.5f * static_cast<float>(across); }
};

struct LandPatch {
  static constexpr int kSide = GroundPatch::kSide;
  glm::vec2 corner{0};                       // m, the lower one
  std::vector<LandFinish> finish;            // of kSide rows of kSide vertices
  std::vector<LandLight> light;              // of those vertices
  std::vector<std::uint16_t> open;           // cells that are left out, for a tunnel's mouth: row by row, in order
  float low = 0, high = 0;                   // m
  std::uint64_t build = 0, light_build = 0;  // new numbers when vertices or open cells change, and when the light does
};

class LandMesh {
 public:
  // Brings all patches up to date with the ground, its plants (null: none), the unit direction to the sun and the
  // lamps: a fraction of a millisecond for each patch that changed. Without `sun_shines` the light is full everywhere.
  void update(const Ground& ground, const Plants* plants, glm::vec3 sun, bool sun_shines, std::span<const Lamp> lamps);
  std::span<const LandPatch> patches() const { return patches_; }  // in the order of Ground::patches()
  const LandField& field() const { return field_; }
  std::uint64_t reset_build() const { return reset_; }  // a new number when all patches are new
  // Returns how much sun and lamps reach a place, from the nearest vertex.
  LandLight light_at(double x, double z) const;
  // Returns the finish of the nearest vertex; there are patches.
  const LandFinish& finish_at(double x, double z) const;
  // Returns where (m) a vertex of a patch is.
  glm::vec3 place(std::size_t patch, std::size_t vertex) const;
  std::vector<LandVertex> vertices(std::size_t patch) const;
  // Returns the triangles of all cells of a patch that are not open, as indices of its vertices.
  std::vector<std::uint16_t> triangles(std::size_t patch) const;
  // Returns how much of the sun reaches a place over the land, 0..1, past hills but not past crowns.
  float sun_over(glm::vec3 place) const;

 private:
  struct Key {
    std::uint64_t ground = 0, plants = 0, track = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Stale {
    VertexRect vertices;
    bool open = false, light = false;
  };
  std::pair<const LandPatch*, std::size_t> nearest(double x, double z) const;
  void reset(const Ground& ground);
  VertexRect rect_of(std::size_t patch) const;
  std::vector<Key> keys_of(const Ground& ground, const Plants* plants) const;
  VertexRect take_heights(const GroundPatch& patch, const VertexRect& rect);
  VertexRect take_cover(const Ground& ground, const Plants* plants, std::size_t patch);
  void mark(const VertexRect& rect);
  void mark_shaded(const VertexRect& rect, float above);
  void mark_lamps(std::span<const Lamp> lamps);
  void build(const Ground& ground, std::size_t patch);
  void bake(std::size_t patch);

  world::Park park_;
  glm::vec3 sun_{0, 1, 0};
  bool sun_shines_ = true;
  std::vector<Lamp> lamps_;
  LandField field_;
  float lowest_ = 0, highest_ = 0;  // m, of the field
  std::vector<LandPatch> patches_;
  std::vector<Key> keys_;
  std::vector<Stale> stale_;
  std::vector<std::uint64_t> lamp_keys_;
  std::uint64_t build_ = 0, reset_ = 0;
};

}  // namespace coaster::sim
