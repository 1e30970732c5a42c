// The land on the GPU: vertices of each patch in a place of its own, written only where it changed, and lists of
// triangles that patches share.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/park/far_land.h"
#include "gfx/park/visible_patches.h"
#include "sim/ground/land_mesh.h"

namespace coaster::gfx {

// Set attributes 0 to 2, and 3, of the bound vertex array from a buffer, from a vertex on.
void land_attributes(const Gl& gl, GLuint buffer, std::size_t first);
void light_attribute(const Gl& gl, GLuint buffer, std::size_t first);

class LandCache {
 public:
  explicit LandCache(const Gl& gl)
      : gl_(&gl), vertices_(gl), light_(gl), own_(gl), shared_(gl), far_(gl), far_indices_(gl) {}

  struct UploadStats {
    int patches = 0;         // whose vertices or triangles were written
    std::int64_t bytes = 0;  // of all that was written
  };
  UploadStats sync(const sim::Ground& ground, const sim::LandMesh& mesh);

  // Draws one patch with the program in use (locations 0 position, 1 normal, 2 paint, 3 light) and returns the number
  // of triangles; `unseen`: only counts.
  std::int64_t draw(const sim::LandMesh& mesh, const VisiblePatch& patch, bool unseen) const;
  // Draws the far land that may be in the picture, and returns the number of triangles.
  std::int64_t draw_far(const glm::mat4& view_projection, bool unseen) const;
  const FarLand& far() const { return far_land_; }

 private:
  struct Held {
    std::uint64_t build = 0, light_build = 0;
    GlObject array;
    GLsizei indices = 0;
  };
  void link();
  void sync_far(const sim::Ground& ground, const sim::LandMesh& mesh, UploadStats& stats);
  void make_shared();

  const Gl* gl_;
  GrowingBuffer<sim::LandVertex> vertices_;
  GrowingBuffer<sim::LandLight> light_;
  GrowingBuffer<std::uint16_t> own_, shared_;   // indices by patch; those of steps and snapped sides
  std::map<std::pair<int, int>, Range> lists_;  // in `shared_`, by step and snapped sides
  std::vector<Held> held_;
  std::uint64_t reset_ = 0;
  FarLand far_land_;
  std::vector<std::uint64_t> far_key_;
  GrowingBuffer<sim::LandVertex> far_;
  GrowingBuffer<std::uint16_t> far_indices_;
  GlObject far_array_;
};

}  // namespace coaster::gfx
