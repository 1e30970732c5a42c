// Rails, spine and ties on the GPU, as instances of a few small meshes: 96 bytes for each interval between two rings,
// between which the vertex shader sweeps the cross-section (shaders/mesh.vert). A segment has pieces for near and for
// distant views. The level is chosen for runs of neighbours in the buffers, so a camera move uploads nothing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/mesh_pool.h"
#include "sim/solids/track_mesh.h"

namespace coaster::gfx {

// One instance: axes and origin of the first ring (forward x, up y, right z; x serves both rings) and of the second.
struct SweptPiece {
  glm::vec3 x, y, z, origin;
  float along, segment;
  glm::vec3 next_y, next_z, next_origin;
  float next_along;
};

// The largest number of triangles of rails, spine and ties in a picture, if fewer rings suffice. Shadow maps have a
// separate limit.
inline constexpr std::int64_t kTriangleBudget = 3'000'000;

class SweptTrack {
 public:
  // A segment's pieces. The user keeps the id and frees it in time.
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffffu;

  explicit SweptTrack(const Gl& gl);

  // Writes the pieces of a segment, into its old ranges if they fit there; an id of kNone is a new segment. stage()
  // prepares them outside GL. Returns the bytes written.
  // Sweeps the pieces of this kind from now on. Those of all segments must be written again after a change.
  void take_kind(world::CoasterKind kind);
  void stage(const sim::SegmentShape& shape, const sim::SolidsDetail& detail, std::uint32_t segment);
  // Does the same for a far segment, of which only a straight piece is visible, with the same rings at its ends.
  void stage_far(const sim::SegmentShape& shape, const sim::SolidsDetail& detail, std::uint32_t segment);
  std::int64_t write(Id& id);
  void release(Id& id);

  // The distances (m) up to which segments are drawn in full, and up to which they have ties.
  struct DetailDistances {
    float full = 0, ties = 0;
    friend bool operator==(const DetailDistances&, const DetailDistances&) = default;
  };
  // Selects full detail near `eye` from now on. Both distances are halved until the triangles stay within
  // kTriangleBudget and the draw calls within a few hundred. Linear in the segments that are not far, see stage_far();
  // no-op while neither the segments nor the eye changed.
  void look_from(glm::vec3 eye, DetailDistances reach);
  // Draws the segments with the program in use (the attributes of shaders/mesh.vert).
  void draw() const { draw(chosen_); }
  int draw_calls() const { return draw_calls(chosen_); }
  std::int64_t triangles() const { return triangles(chosen_); }  // per draw, gaps included

  // The same for the segments that reach into the clip space of `light`: in full unless the texels of the shadow map,
  // `texel_metres` wide, are larger than rail and gap.
  ShadowDrawStats cast(const glm::mat4& light, float texel_metres, bool unseen);

  // Changes whenever anything is written or removed.
  std::uint64_t version() const { return version_; }
  // Returns the number of parts that each choice iterates over: near segments, and runs of far ones.
  std::size_t part_count() const;
  // Bytes in use, gaps included.
  std::int64_t bytes() const;

 private:
  enum Kind : std::size_t { kTubes, kCaps, kFarTubes, kTies, kKinds };
  template <class T>
  using ByKind = std::array<T, kKinds>;
  using Runs = ByKind<std::vector<Range>>;
  struct Segment {
    ByKind<Range> pieces;
    glm::vec3 middle{0};
    float radius = 0;
    bool far = false;  // it has only distant tubes
  };
  // A mesh and its instances.
  struct PieceBatch {
    explicit PieceBatch(const Gl& gl);
    void fill(const Gl& gl, const sim::Mesh& mesh, const std::vector<std::uint32_t>& corners);
    GrowingBuffer<sim::MeshVertex> vertices;
    GrowingBuffer<std::uint32_t> indices;
    GrowingBuffer<SweptPiece> pieces;
    GlObject array;
    GLsizei index_count = 0;
    RangeAllocator ranges;
    std::vector<Id> order;  // by position in the buffer
    bool moved = true;      // ranges changed since the order was computed
  };
  // A near segment, or neighbours in a buffer that are all far.
  struct SegmentGroup {
    Range place;
    Id near = kNone;
    glm::vec3 low{0}, high{0};  // of the far ones
  };
  void fit(Id& id);
  void measure(Segment& segment) const;
  void put(PieceBatch& row, Range range, std::vector<SweptPiece>& pieces);
  void sort();
  void group();
  void widen_part(const Segment& segment);
  void gather(Runs& runs, const auto& shows_far) const;
  void choose(const DetailDistances& reach);
  void draw(const Runs& runs) const;
  int draw_calls(const Runs& runs) const;
  std::int64_t triangles(const Runs& runs) const;

  const Gl* gl_;
  std::optional<world::CoasterKind> kind_;  // of the meshes
  ByKind<PieceBatch> rows_;
  std::vector<Segment> segments_;
  std::vector<Id> free_;
  ByKind<std::vector<SegmentGroup>> parts_;  // by position in the buffers
  std::vector<Id> near_;                     // segments that are not far
  bool grouped_ = false;                     // parts_ and near_ are up to date
  Runs chosen_, cast_;
  std::uint64_t version_ = 0;
  glm::vec3 eye_{0};
  DetailDistances reach_{-1, -1};
  // Kept for their capacity.
  ByKind<std::vector<SweptPiece>> staged_;
  std::vector<std::uint8_t> shown_;  // by segment, a bit for each kind; of the near ones
};

}  // namespace coaster::gfx
