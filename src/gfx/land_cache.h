// The land on the GPU: which patches a view shows, and how finely; the land beyond the square; and buffers that are
// written only where the land changed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "gfx/growing_buffer.h"
#include "sim/ground/land_mesh.h"

namespace coaster::gfx {

struct Box {
  glm::vec3 low{0}, high{0};  // m
};
// Returns false if nothing of the box can be in the picture.
bool may_show(const glm::mat4& view_projection, const Box& box);
// Returns the distance from a point to a box; 0 inside.
float distance_to(const Box& box, glm::vec3 from);

// Returns the box around a patch and what stands on it, up to `above` m.
Box box_of(const sim::LandPatch& patch, float above);

struct VisiblePatch {
  std::size_t index = 0;
  float metres = 0;  // from the eye to its box
  int step = 1;      // cells along a side of the drawn ones: 1, 2 or 4
  // Sides on whose border every fourth vertex is drawn, as by the patch beyond: bits 0 to 3 for -x, +x, -z, +z. All of
  // them with steps above 1.
  std::uint8_t snapped = 0;
};
inline constexpr std::uint8_t kAllSides = 15;
inline constexpr float kPlantHeight = 14;  // m over the land that a patch's box includes

// Returns the patches in the picture, the nearest first. `near` scales the distances up to which they are fine.
std::vector<VisiblePatch> visible_patches(std::span<const sim::LandPatch> patches, const glm::mat4& view_projection,
                                          glm::vec3 eye, float near);

// Returns the triangles of a patch with a step and its snapped sides, as indices of its vertices.
std::vector<std::uint16_t> patch_indices(int step, std::uint8_t snapped);

// The land beyond the square: rings of triangles out to the horizon, which begin at the square's edge.
struct FarLand {
  std::vector<sim::LandVertex> vertices;
  std::vector<std::uint16_t> indices;    // by the sides of the square
  std::array<std::uint32_t, 5> sides{};  // where each side's indices begin, and their end
  float low = 0, high = 0;               // m
};
// Returns the far land around the ground's square, whose patches' borders at every fourth vertex it continues.
FarLand far_land(const sim::Ground& ground, const sim::LandField& field);

inline constexpr float kFarthestLand = 18;  // half sides of the square, level, along an axis

// Sets an attribute of bytes from the bound buffer: parts of 255, or of 127 if they are signed.
void byte_attribute(const Gl& gl, GLuint location, int components, GLenum type, std::size_t stride, std::size_t offset,
                    GLuint divisor = 0);
// Set attributes 0 to 2 of the bound vertex array from a buffer of land vertices; 3 from a buffer of light, from a
// vertex on.
void land_attributes(const Gl& gl, GLuint buffer);
void light_attribute(const Gl& gl, GLuint buffer, std::size_t first);
// Tells the land's programs that attribute 0 is a place in the world: they add a patch's corner and heights to it.
void no_corner(const Gl& gl);

class LandCache {
 public:
  explicit LandCache(const Gl& gl)
      : gl_(&gl), grid_(gl), heights_(gl), finish_(gl), light_(gl), own_(gl), shared_(gl), far_(gl), far_indices_(gl) {}

  struct UploadStats {
    int patches = 0;         // whose vertices were written
    std::int64_t bytes = 0;  // of all that was written
  };
  UploadStats sync(const sim::Ground& ground, const sim::LandMesh& mesh);
  // Writes the triangles of those patches that are drawn with their own. Returns the bytes.
  std::int64_t prepare(const sim::LandMesh& mesh, std::span<const VisiblePatch> visible);

  // Draws one prepared patch with the program in use (locations 0 and 4 position, 1 normal, 2 paint, 3 light, 5 the
  // patch's corner) and returns the number of triangles; `unseen`: only counts.
  std::int64_t draw(const sim::LandMesh& mesh, const VisiblePatch& patch, bool unseen) const;
  // Draws the far land that may be in the picture, and returns the number of triangles.
  std::int64_t draw_far(const glm::mat4& view_projection, bool unseen) const;
  const FarLand& far() const { return far_land_; }

 private:
  struct Held {
    std::uint64_t build = 0, light_build = 0, own_build = 0;
    GlObject array;
    Range slot;  // in `own_`
    std::uint32_t indices = 0;
  };
  void link();
  void sync_far(const sim::Ground& ground, const sim::LandMesh& mesh, UploadStats& stats);
  void make_shared();

  const Gl* gl_;
  GrowingBuffer<glm::vec3> grid_;  // places of a patch's vertices from its corner, on the level
  GrowingBuffer<float> heights_;
  GrowingBuffer<sim::LandFinish> finish_;
  GrowingBuffer<sim::LandLight> light_;
  GrowingBuffer<std::uint16_t> own_, shared_;   // indices of single patches; those of steps and snapped sides
  RangeAllocator slots_;                        // in `own_`
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
