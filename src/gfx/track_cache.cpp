// Keeps the slots of the track's buffers equal to the derived track.
#include "gfx/track_cache.h"

#include <cstddef>

#include "sim/solids/track_mesh.h"

namespace coaster::gfx {
namespace {

static_assert(sizeof(PolylineVertex) == 24, "vertices are uploaded with their memory layout");
static_assert(kControlBytes == 48, "so are control points");

}  // namespace

TrackCache::TrackCache(const Gl& gl)
    : gl_(&gl), lines_(gl), controls_(gl), swept_(gl), mesh_(gl), supports_(gl), line_array_(make_vertex_array(gl)) {}

TrackCache::Synced TrackCache::sync(const sim::Derived& derived, const sim::Clock& clock) {
  const bool on_processor = derived.evaluated_by == curve::EvaluatedBy::processor;
  synced_ = {};
  if (const sim::Detail detail = sim::detail_of(derived); !(detail == detail_)) {
    detail_ = detail;
    for (Slot& slot : slots_) slot.shape_build = 0;  // every mesh again
  }
  Stopwatch watch{clock};
  ++stamp_;
  watch.time([&] {
    for (const world::Entity segment : derived.order) slot_of(segment).seen = stamp_;
  });
  if (live_ > derived.order.size())
    for (Slot& slot : slots_)
      if (slot.segment.valid() && slot.seen != stamp_) release(slot);
  if (on_processor) drop_controls();
  else drop_lines();
  held_polyline_bytes_ = 0;
  for (const world::Entity segment : derived.order) {
    Slot& slot = slots_[segment.index];
    if (write_segment(derived.shape(segment), on_processor, slot, watch)) ++synced_.uploads;
    held_polyline_bytes_ += std::int64_t(slot.line.size * sizeof(PolylineVertex) + slot.control.size * kControlBytes);
  }
  synced_.cpu_seconds = watch.seconds;
  return synced_;
}

// Returns true if anything of the segment was written.
bool TrackCache::write_segment(const sim::SegmentShape& shape, bool on_processor, Slot& slot, Stopwatch& watch) {
  const bool line = on_processor && slot.polyline_build != shape.polyline_build;
  const bool reshaped = slot.shape_build != shape.shape_build, solids = reshaped || slot.fitted != shape.fitted;
  const bool control = !on_processor && (reshaped || slot.control.size == 0);
  if (line) write_polyline(shape, slot, watch);
  if (control) write_control(shape, slot);
  if (solids) write_solids(shape, slot, watch);
  return line || control || solids;
}

// Returns the slot of a segment, empty if the segment is new; releases the slot of an older generation.
TrackCache::Slot& TrackCache::slot_of(world::Entity segment) {
  if (segment.index >= slots_.size()) slots_.resize(segment.index + 1);
  Slot& slot = slots_[segment.index];
  if (slot.segment != segment) {
    if (slot.segment.valid()) release(slot);
    slot.segment = segment;
    ++live_;
  }
  return slot;
}

void TrackCache::release(Slot& slot) {
  fill_breaks(slot.line);
  empty_control(slot.control);
  line_ranges_.give_back(slot.line);
  control_ranges_.give_back(slot.control);
  placed_.resize(control_ranges_.used());
  swept_.release(slot.swept);
  mesh_.release(slot.mesh);
  slot = Slot{};
  --live_;
}

void TrackCache::write_polyline(const sim::SegmentShape& shape, Slot& slot, Stopwatch& watch) {
  watch.time([&] { sim::evaluate_polyline(shape, polyline_); });
  const auto count = static_cast<std::uint32_t>(polyline_.points.size() + 1);  // and the break
  if (slot.line.size != count) {
    fill_breaks(slot.line);
    line_ranges_.give_back(slot.line);
    slot.line = line_ranges_.take(count);
  }
  watch.time([&] {
    staged_line_.resize(count);
    for (std::size_t i = 0; i + 1 < count; ++i) staged_line_[i] = {polyline_.points[i], polyline_.tangents[i]};
    staged_line_.back() = {polyline_.points.back(), {kBreak, 0, 0}};
  });
  write_lines(slot.line);
  slot.polyline_build = shape.polyline_build;
}

void TrackCache::write_control(const sim::SegmentShape& shape, Slot& slot) {
  if (slot.control.size == 0) slot.control = control_ranges_.take(1);
  placed_.resize(control_ranges_.used());
  placed_[slot.control.first] = {slot.segment, shape.shape_build};
  controls_.reserve(control_ranges_.used());
  write(controls_, slot.control, std::span(&shape.key.cubic, 1));
}

void TrackCache::empty_control(Range range) {
  if (range.size == 0) return;
  const curve::Cubic none{{kBreak, 0, 0}};
  placed_[range.first] = {};
  write(controls_, range, std::span(&none, 1));
}

// Frees the buffer itself, not only its ranges: the other kind of slots takes over.
void TrackCache::drop_lines() {
  if (line_ranges_.used() == 0) return;
  for (Slot& slot : slots_) slot.line = {}, slot.polyline_build = 0;
  line_ranges_ = {};
  lines_ = GrowingBuffer<PolylineVertex>(*gl_);
}

void TrackCache::drop_controls() {
  if (control_ranges_.used() == 0) return;
  for (Slot& slot : slots_) slot.control = {};
  control_ranges_ = {};
  controls_ = GrowingBuffer<curve::Cubic>(*gl_);
  placed_.clear();
}

template <class T>
void TrackCache::write(GrowingBuffer<T>& buffer, Range range, std::span<const T> items) {
  buffer.write(range.first, items);
  synced_.bytes += std::int64_t(items.size_bytes());
  synced_.polyline_bytes += std::int64_t(items.size_bytes());
}

void TrackCache::write_solids(const sim::SegmentShape& shape, Slot& slot, Stopwatch& watch) {
  watch.time([&] {
    swept_.stage(shape, detail_, slot.segment.index);
    staged_mesh_.clear();
    if (shape.fitted) sim::add_fittings(shape, *shape.fitted, staged_mesh_, detail_);
    for (sim::MeshVertex& vertex : staged_mesh_.vertices) vertex.segment = static_cast<float>(slot.segment.index);
  });
  synced_.bytes += swept_.write(slot.swept);
  if (staged_mesh_.vertices.empty()) mesh_.release(slot.mesh);
  else synced_.bytes += mesh_.write(staged_mesh_, slot.mesh, watch);
  slot.shape_build = shape.shape_build;
  slot.fitted = shape.fitted;
}

void TrackCache::fill_breaks(Range range) {
  if (range.size == 0) return;
  staged_line_.assign(range.size, {{0, 0, 0}, {kBreak, 0, 0}});
  write_lines(range);
}

void TrackCache::write_lines(Range range) {
  if (lines_.reserve(line_ranges_.used())) link_lines();
  write(lines_, range, std::span<const PolylineVertex>(staged_line_));
}

void TrackCache::link_lines() {
  gl_->BindVertexArray(line_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, lines_.id());
  constexpr std::size_t kStride = sizeof(PolylineVertex);
  for (std::size_t attribute = 0; attribute < 4; ++attribute)
    float_attribute(*gl_, GLuint(attribute), 3, kStride, attribute * kStride / 2, 1);
  gl_->BindVertexArray(0);
}

}  // namespace coaster::gfx
