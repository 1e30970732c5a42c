// Solids in one vertex buffer and two index buffers: all of their triangles, and fewer for distant ones. The choice is
// made for runs of neighbours in the buffers, so a camera move uploads nothing and costs a few draw calls.
#pragma once

#include <cstdint>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/ranges.h"
#include "sim/solids/mesh.h"

namespace coaster::gfx {

class MeshPool {
 public:
  // A solid's ranges in the buffers, and its bounding sphere. The pool's user keeps the id and frees it in time.
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffffu;

  explicit MeshPool(const Gl& gl)
      : gl_(&gl),
        vertices_(gl),
        indices_(gl),
        coarse_(gl),
        fine_array_(make_vertex_array(gl)),
        coarse_array_(make_vertex_array(gl)) {}

  // Makes room for a solid, in its old range if it fits there. An id of kNone is a new solid.
  void fit(const sim::Mesh& mesh, Id& id);
  // Prepares the mesh for its range, without GL: numbers its vertices as in the buffer and fills up the range.
  void settle(sim::Mesh& mesh, Id id);
  // Returns the bytes written.
  std::int64_t send(const sim::Mesh& mesh, Id id);
  void release(Id& id);

  // From now on draws solids closer to `eye` than `near_metres` in full. Linear in the solids; does nothing while
  // neither these nor the eye changed.
  void look_from(glm::vec3 eye, float near_metres);
  // Draws all solids with the program in use; returns the number of draw calls. Locations 0 position, 1 normal, 2 part,
  // 3 to 6 the unit matrix, 7 position along the segment and the segment's index.
  int draw() const;
  int draw_calls() const { return int(fine_runs_.size() + coarse_runs_.size()); }
  std::int64_t triangles() const;  // per draw, gaps included
  // Draws all solids in full, independent of the eye: one draw call.
  void draw_all() const;

  // Changes whenever anything is written or removed.
  std::uint64_t version() const { return version_; }

  // One past the last index in use; 0: empty.
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
  std::vector<Id> fine_order_, coarse_order_;  // by position in the two buffers
  std::vector<Run> fine_runs_, coarse_runs_;
  std::int64_t written_ = 0;
  std::uint64_t version_ = 0;
  bool moved_ = true;  // ranges changed since the orders were computed
  glm::vec3 eye_{0};
  float near_metres_ = -1;
};

}  // namespace coaster::gfx
