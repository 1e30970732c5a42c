// Solids in one buffer of vertices and two of indices: all of their triangles, and fewer for those that are far off.
// Which of the two is drawn is chosen by runs of neighbours in the buffers, so that a camera that moves uploads nothing
// and costs a few draw calls.
#pragma once

#include <cstdint>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/ranges.h"
#include "sim/solids/mesh.h"

namespace coaster::gfx {

class MeshPool {
 public:
  // A solid's places in the buffers, and a ball about it. Kept by the pool's user, who gives it back before its end.
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffffu;

  explicit MeshPool(const Gl& gl)
      : gl_(&gl),
        vertices_(gl),
        indices_(gl),
        coarse_(gl),
        fine_array_(make_vertex_array(gl)),
        coarse_array_(make_vertex_array(gl)) {}

  // Makes room for a solid, in its old place when it fits there. An id of kNone is a new solid.
  void fit(const sim::Mesh& mesh, Id& id);
  // Readies the mesh for its place: no GL. Its vertices are numbered as in the buffer afterwards, and the room is
  // filled up.
  void settle(sim::Mesh& mesh, Id id);
  // Returns the bytes written.
  std::int64_t send(const sim::Mesh& mesh, Id id);
  void release(Id& id);

  // What is nearer to `eye` than `near_metres` is drawn in full from now on. Linear in the solids; nothing while
  // neither these nor the eye changed.
  void look_from(glm::vec3 eye, float near_metres);
  // Draws all solids with the program in use; returns how many draw calls that took. Locations 0 position, 1 normal, 2
  // part, 3 to 6 the unit matrix, 7 place (along the segment, its index).
  int draw() const;
  int draw_calls() const { return int(fine_runs_.size() + coarse_runs_.size()); }
  std::int64_t triangles() const;  // of a draw, gaps included
  // All solids in full, wherever they are looked at from: one draw call.
  void draw_all() const;

  // Another number whenever anything was written or taken away.
  std::uint64_t version() const { return version_; }

  // One past the last index in use; 0: nothing to draw.
  std::uint32_t index_count() const { return index_ranges_.used(); }

 private:
  struct Solid {
    Range vertices, indices, coarse;
    glm::vec3 middle{0};
    float radius = 0;
    bool used = false, far = false;
  };
  struct Run {
    std::uint32_t first = 0, count = 0;  // indices
  };
  void write_indices(GrowingBuffer& buffer, const Ranges& ranges, Range range,
                     const std::vector<std::uint32_t>& indices);
  void empty(GrowingBuffer& buffer, const Ranges& ranges, Range range);
  void link();
  void bind(const Object& array) const;
  void gather(Range Solid::*range, bool far, const std::vector<Id>& order, std::vector<Run>& runs) const;

  const Gl* gl_;
  GrowingBuffer vertices_, indices_, coarse_;
  Object fine_array_, coarse_array_;
  Ranges vertex_ranges_, index_ranges_, coarse_ranges_;
  std::vector<Solid> solids_;
  std::vector<Id> free_;
  std::vector<Id> fine_order_, coarse_order_;  // by place in the two buffers
  std::vector<Run> fine_runs_, coarse_runs_;
  std::int64_t written_ = 0;
  std::uint64_t version_ = 0;
  bool moved_ = true;  // places changed since the orders were made
  glm::vec3 eye_{0};
  float near_metres_ = -1;
};

}  // namespace coaster::gfx
