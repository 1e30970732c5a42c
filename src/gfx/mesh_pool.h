// Solids in one vertex buffer and two index buffers: all of their triangles, and fewer for distant ones. The level is
// chosen for runs of neighbours in the buffers, so a camera move uploads nothing and costs a few draw calls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gfx/growing_buffer.h"
#include "sim/shape/derived_track.h"
#include "sim/solids/mesh.h"

namespace coaster::gfx {

// Adds up the time of some work; 0 without a clock.
struct Stopwatch {
  const sim::Clock& clock;
  double seconds = 0;
  void time(const auto& work) {
    const double began = clock ? clock() : 0;
    work();
    if (clock) seconds += clock() - began;
  }
};

// Sets the attributes 0 position, 1 normal, 2 part and 7 place of the bound vertex array from the bound buffer of
// MeshVertex.
void mesh_attributes(const Gl& gl);
// The attribute that selects the second ring of a SweptPiece (gfx/swept_track.h); a constant -1 for all other meshes.
inline constexpr GLuint kEndAttribute = 12;

// The statistics of drawing into a shadow map.
struct ShadowDrawStats {
  int draw_calls = 0;
  std::int64_t triangles = 0;
};
// True if a sphere reaches into the clip space of a light, at any depth.
bool reaches(const glm::mat4& light, glm::vec3 middle, float radius);

class MeshPool {
 public:
  // A solid's ranges in the buffers, and its bounding sphere. The pool's user keeps the id and frees it in time.
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffffu;

  explicit MeshPool(const Gl& gl)
      : gl_(&gl),
        vertices_(gl),
        levels_{{{gl, &Solid::indices, &sim::Mesh::indices, false}, {gl, &Solid::coarse, &sim::Mesh::coarse, true}}} {}

  // Writes a solid, into its old range if it fits there; an id of kNone is a new solid. Numbers the mesh's vertices as
  // in the buffer. Returns the bytes written. `watch` measures the work outside GL.
  std::int64_t write(sim::Mesh& mesh, Id& id, Stopwatch& watch);
  void release(Id& id);

  // Selects full detail for solids closer to `eye` than `near_metres` from now on. Linear in the solids; no-op while
  // neither these nor the eye changed.
  void look_from(glm::vec3 eye, float near_metres);
  // Draws all solids with the program in use; returns the number of draw calls. Locations 0 position, 1 normal, 2 part,
  // 3 to 6 the unit matrix, 7 position along the segment and the segment's index.
  int draw() const;
  int draw_calls() const { return int(levels_[0].runs.size() + levels_[1].runs.size()); }
  std::int64_t triangles() const;  // per draw, gaps included
  // Draws the solids that reach into the clip space of `light` in full, independent of the eye; `unseen`: only counts.
  // Call after look_from().
  ShadowDrawStats cast(const glm::mat4& light, bool unseen) const;

  // Changes whenever anything is written or removed.
  std::uint64_t version() const { return version_; }

  // One past the last index in use; 0: empty.
  std::uint32_t index_count() const { return levels_[0].ranges.used(); }

 private:
  struct Solid {
    Range vertices, indices, coarse;
    glm::vec3 middle{0};
    float radius = 0;
    bool used = false, far = false;
  };
  // The indices of all solids, in full or for distant views.
  struct Level {
    Level(const Gl& gl, Range Solid::*in_solid, std::vector<std::uint32_t> sim::Mesh::*in_mesh, bool distant)
        : buffer(gl), array(make_vertex_array(gl)), range(in_solid), indices(in_mesh), far(distant) {}
    GrowingBuffer<std::uint32_t> buffer;
    GlObject array;
    Range Solid::*range;
    std::vector<std::uint32_t> sim::Mesh::*indices;
    bool far;
    RangeAllocator ranges;
    std::vector<Id> order;    // by position in the buffer
    std::vector<Range> runs;  // of indices
  };
  void fit(const sim::Mesh& mesh, Id& id);
  void settle(sim::Mesh& mesh, Id id);
  void write_indices(Level& level, Range range, const std::vector<std::uint32_t>& indices);
  void empty(Level& level, Range range);
  void link();
  void bind(const Level& level) const;
  void gather(Level& level) const;
  std::vector<Range> runs_of(const Level& level, const auto& shown) const;
  void draw(const Level& level, const std::vector<Range>& runs) const;

  const Gl* gl_;
  GrowingBuffer<sim::MeshVertex> vertices_;
  RangeAllocator vertex_ranges_;
  std::array<Level, 2> levels_;
  std::vector<Solid> solids_;
  std::vector<Id> free_;
  std::int64_t written_ = 0;
  std::uint64_t version_ = 0;
  bool moved_ = true;  // ranges changed since the orders were computed
  glm::vec3 eye_{0};
  float near_metres_ = -1;
};

}  // namespace coaster::gfx
