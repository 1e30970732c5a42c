// The track on the GPU: each segment has a slot in one buffer of polyline vertices and in those of solids. A slot is
// rewritten only if the segment's build numbers or its equipment differ from those in the slot. No dirty flags. With a
// GPU evaluator there are no polyline vertices; the slots hold the four control points instead.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gfx/growing_buffer.h"
#include "gfx/mesh_pool.h"
#include "gfx/segment_detail_levels.h"
#include "gfx/swept_track.h"
#include "sim/shape/detail_limits.h"
#include "sim/solids/station_mesh.h"
#include "sim/solids/supports.h"

namespace coaster::gfx {

struct CurveSlots;  // gfx/gpu_curves.h

// Supports: one solid per segment that has any, rewritten only if it changed. Separate from the track's buffers, so
// that these are written only for moved track.
class SupportCache {
 public:
  explicit SupportCache(const Gl& gl) : mesh_(gl) {}

  struct UploadStats {
    int uploads = 0;         // segments whose supports were written
    double cpu_seconds = 0;  // time to prepare them, outside GL; 0 without a clock
  };
  // null: draws none. If nothing changed, costs one comparison for each segment that may have supports.
  // `near`: by the index of a segment's entity, whether its supports are held; null: all are.
  UploadStats sync(const sim::Supports* supports, const sim::Clock& clock,
                   const std::vector<std::uint8_t>* near = nullptr, world::CoasterKind kind = {});

  MeshPool& mesh() { return mesh_; }
  const MeshPool& mesh() const { return mesh_; }

 private:
  struct Slot {
    world::Entity segment;
    std::uint64_t build = 0, seen = 0;
    MeshPool::Id mesh = MeshPool::kNone;
  };
  MeshPool mesh_;
  std::vector<Slot> slots_;          // by the entity's index
  std::vector<std::uint32_t> held_;  // those with a segment
  std::uint64_t stamp_ = 0;          // of the current sync
  sim::Mesh staged_;                 // kept for its capacity
};

// 24 bytes. The vertex after a polyline's last one has kBreak in tangent.x: lines from or to it are not drawn. Gaps are
// filled with such vertices.
struct PolylineVertex {
  glm::vec3 position;
  glm::vec3 tangent;  // B'(t)
};
inline constexpr float kBreak = 3e38f;
// A slot of control points is a cubic; an empty one has kBreak in p0.x.
inline constexpr std::size_t kControlBytes = sizeof(curve::Cubic);

class TrackCache {
 public:
  explicit TrackCache(const Gl& gl);

  struct UploadStats {
    int uploads = 0;                  // segments with anything written
    std::int64_t bytes = 0;           // written to the track's buffers
    std::int64_t polyline_bytes = 0;  // of these, to polyline vertices or control points
    int looked_at = 0;                // segments compared with their slots
    double cpu_seconds = 0;           // time to prepare it, outside GL; 0 without a clock
  };
  // Updates the slots from the same DerivedTrack as before. Reads only the segments that DerivedTrack::changes_since()
  // lists and those whose level changes; all of them after a change of the track's order, of equipment or of the
  // evaluation of polylines.
  // Platforms stand on `ground`, null: on the plane y = 0; those over changed ground are written again.
  UploadStats sync(const sim::DerivedTrack& derived, const sim::Clock& clock, const sim::Ground* ground = nullptr);
  // From now on very long tracks are held in full only where this shows a difference, and have ties, equipment and
  // supports only within `ties` m of the eye, the reach of ties.
  void look_from(const LevelView& sight, float ties) { sight_ = sight, ties_ = ties; }
  // By the index of a segment's entity, as of the last sync: whether it has these. Null if all have.
  const std::vector<std::uint8_t>* near() const { return parts_everywhere_ ? nullptr : &near_; }

  // Returns rails, spine and ties of all segments.
  SweptTrack& swept() { return swept_; }
  const SweptTrack& swept() const { return swept_; }
  // Returns their equipment.
  MeshPool& mesh() { return mesh_; }
  const MeshPool& mesh() const { return mesh_; }
  // Returns the supports, which have separate buffers and counters.
  SupportCache& supports() { return supports_; }
  const SupportCache& supports() const { return supports_; }
  // Holds these buildings of stations from now on; null: none. Returns the bytes written.
  std::int64_t sync_buildings(const sim::StationBuildings* stations);
  MeshPool& buildings() { return buildings_; }
  const MeshPool& buildings() const { return buildings_; }
  // Changes whenever any of these is written or removed.
  std::uint64_t mesh_version() const {
    return swept_.version() + mesh_.version() + supports_.mesh().version() + buildings_.version();
  }
  // Binds the array whose instance i is the line from vertex i to vertex i+1: locations 0 and 1 are position and
  // tangent of vertex i, 2 and 3 of vertex i+1.
  void bind_lines() const { gl_->BindVertexArray(line_array_.id()); }
  GLsizei line_count() const { return line_ranges_.used() > 0 ? GLsizei(line_ranges_.used() - 1) : 0; }
  // The buffer of control points, 48 bytes per slot. Slot k belongs to the segment placed()[k]; an invalid entity marks
  // an empty slot.
  struct Placed {
    world::Entity segment;
    std::uint64_t shape_build = 0;
    friend bool operator==(const Placed&, const Placed&) = default;
  };
  GLuint control_buffer() const { return controls_.id(); }
  std::span<const Placed> placed() const { return placed_; }
  // The same slots with their numbers of lines, in runs.
  std::vector<CurveSlots> control_runs() const;
  // Returns the bytes of all segments' polylines: control points, or 24 per vertex and per break.
  std::int64_t held_polyline_bytes() const { return held_polyline_bytes_; }

 private:
  struct Slot {
    world::Entity segment;
    std::uint64_t shape_build = 0, polyline_build = 0;  // 0: never written
    std::uint64_t seen = 0, ground = 0;                 // build of the ground under a platform
    std::optional<world::EquipmentKind> fitted;
    Range line, control;
    SweptTrack::Id swept = SweptTrack::kNone;
    MeshPool::Id mesh = MeshPool::kNone;  // of its equipment
  };
  void take_order(const sim::DerivedTrack& derived);
  // How finely a segment is held; 0: not at all.
  enum class SolidDetail : std::uint8_t { none, straight, swept, with_parts };
  struct Level {
    int lines = 0;
    SolidDetail solid = SolidDetail::none;
    friend bool operator==(const Level&, const Level&) = default;
  };
  Level level_of(std::size_t index) const {
    const bool full = levels_.solid(sizes_[index]);
    return {levels_.lines_of(sizes_[index]), parts_everywhere_ || near_[index] != 0 ? SolidDetail::with_parts
                                             : full                                 ? SolidDetail::swept
                                                                                    : SolidDetail::straight};
  }
  Slot& slot_of(world::Entity segment);
  static std::int64_t bytes_of(const Slot& slot) {
    return std::int64_t(slot.line.size * sizeof(PolylineVertex) + slot.control.size * kControlBytes);
  }
  void release(Slot& slot);
  void take_near(const sim::DerivedTrack& derived);
  void take_ground(const sim::DerivedTrack& derived, bool on_processor, Stopwatch& watch);
  void change_levels(const sim::DerivedTrack& derived, bool on_processor, Stopwatch& watch);
  void change_level(std::size_t index, const sim::DerivedTrack& derived, bool on_processor, Stopwatch& watch);
  bool write_segment(const sim::SegmentShape& shape, bool on_processor, Slot& slot, Stopwatch& watch);
  void write_polyline(const sim::SegmentShape& shape, Slot& slot, Stopwatch& watch);
  void write_control(const sim::SegmentShape& shape, Slot& slot);
  void empty_control(Range range);
  void drop_lines();
  void drop_controls();
  template <class T>
  void write(GrowingBuffer<T>& buffer, Range range, std::span<const T> items);
  void write_solids(const sim::SegmentShape& shape, Slot& slot, Stopwatch& watch);
  void fill_breaks(Range range);
  void write_lines(Range range);
  void link_lines();

  const Gl* gl_;
  GrowingBuffer<PolylineVertex> lines_;
  GrowingBuffer<curve::Cubic> controls_;
  SweptTrack swept_;
  MeshPool mesh_;
  SupportCache supports_;
  MeshPool buildings_;
  MeshPool::Id building_ = MeshPool::kNone;
  std::uint64_t building_build_ = 0;
  GlObject line_array_;
  RangeAllocator line_ranges_, control_ranges_;
  std::vector<Slot> slots_;              // by the entity's index
  std::vector<SegmentSize> sizes_;       // by the entity's index
  std::vector<Level> levels_held_;       // by the entity's index: the level in the slot
  std::size_t live_ = 0;                 // slots with a segment
  std::uint64_t stamp_ = 0;              // of the current sync
  const sim::Ground* ground_ = nullptr;  // during a sync
  std::uint64_t ground_build_ = 0;
  UploadStats synced_;  // of the current sync
  std::int64_t held_polyline_bytes_ = 0;
  // Values of the last sync.
  std::uint64_t last_build_ = 0;
  world::Evaluation evaluation_;
  LevelView sight_, levels_for_;
  LevelChoice level_choice_;
  SegmentLevels levels_, levels_compared_;  // of this sync; those that all slots were last compared with
  std::vector<Placed> placed_;              // by slot of control points
  // Staging buffers; kept for their capacity.
  sim::Polyline polyline_;
  std::vector<PolylineVertex> staged_line_;
  sim::Mesh staged_mesh_;
  sim::SolidsDetail detail_, near_detail_;  // of the meshes
  sim::NearSegments near_track_;
  float ties_ = 0;
  bool parts_everywhere_ = true;
  std::vector<std::uint8_t> near_;        // by the entity's index: 1 where a very long track has parts
  std::vector<std::uint32_t> were_near_;  // indices of entities, now or before this sync
};

}  // namespace coaster::gfx
