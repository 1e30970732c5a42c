// Keeps the slots of the track's buffers equal to the derived track.
#include "gfx/track_cache.h"

#include <algorithm>
#include <cstddef>

#include "sim/solids/track_mesh.h"

namespace coaster::gfx {
namespace {

static_assert(sizeof(PolylineVertex) == 24, "vertices are uploaded with their memory layout");
static_assert(sizeof(curve::Cubic) == kControlBytes, "so are control points");

}  // namespace

TrackCache::TrackCache(const Gl& gl)
    : gl_(&gl), lines_(gl), controls_(gl), mesh_(gl), supports_(gl), line_array_(make_vertex_array(gl)) {}

template <class Work>
void TrackCache::timed(const Work& work) {
  const bool measured = clock_ != nullptr && *clock_;
  const double begin = measured ? (*clock_)() : 0;
  work();
  if (measured) synced_.cpu_seconds += (*clock_)() - begin;
}

TrackCache::Synced TrackCache::sync(const sim::Derived& derived, const sim::Clock& clock) {
  const bool on_processor = derived.evaluated_by == curve::EvaluatedBy::processor;
  synced_ = {};
  clock_ = &clock;
  ++stamp_;
  timed([&] {
    for (const world::Entity segment : derived.order) slot_of(segment).seen = stamp_;
  });
  if (live_ > derived.order.size()) release_unseen();
  if (on_processor) drop_controls();
  else drop_lines();
  held_polyline_bytes_ = 0;
  for (const world::Entity segment : derived.order) {
    Slot& slot = slots_[segment.index];
    if (write_segment(derived.shape(segment), on_processor, slot)) ++synced_.uploads;
    held_polyline_bytes_ += std::int64_t(slot.line.size * sizeof(PolylineVertex) + slot.control.size * kControlBytes);
  }
  clock_ = nullptr;
  return synced_;
}

// Returns true if anything of the segment was written.
bool TrackCache::write_segment(const sim::SegmentShape& shape, bool on_processor, Slot& slot) {
  const bool line = on_processor && slot.polyline_build != shape.polyline_build;
  const bool reshaped = slot.shape_build != shape.shape_build, mesh = reshaped || slot.fitted != shape.fitted;
  const bool control = !on_processor && (reshaped || slot.control.size == 0);
  if (line) write_polyline(shape, slot);
  if (control) write_control(shape, slot);
  if (mesh) write_mesh(shape, slot);
  return line || control || mesh;
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
  mesh_.release(slot.mesh);
  slot = Slot{};
  --live_;
}

void TrackCache::release_unseen() {
  for (Slot& slot : slots_)
    if (slot.segment.valid() && slot.seen != stamp_) release(slot);
}

void TrackCache::write_polyline(const sim::SegmentShape& shape, Slot& slot) {
  const auto count = static_cast<std::uint32_t>(shape.points.size() + 1);  // and the break
  if (slot.line.size != count) {
    fill_breaks(slot.line);
    line_ranges_.give_back(slot.line);
    slot.line = line_ranges_.take(count);
  }
  timed([&] {
    staged_line_.resize(count);
    for (std::size_t i = 0; i + 1 < count; ++i) staged_line_[i] = {shape.points[i], shape.tangents[i]};
    staged_line_.back() = {shape.points.back(), {kBreak, 0, 0}};
  });
  write_lines(slot.line);
  slot.polyline_build = shape.polyline_build;
}

void TrackCache::write_control(const sim::SegmentShape& shape, Slot& slot) {
  if (slot.control.size == 0) slot.control = control_ranges_.take(1);
  placed_.resize(control_ranges_.used());
  placed_[slot.control.first] = {slot.segment, shape.shape_build};
  controls_.reserve(std::size_t(control_ranges_.used()) * kControlBytes);
  write(controls_, slot.control.first * kControlBytes, &shape.key.cubic, kControlBytes, true);
}

void TrackCache::empty_control(Range range) {
  if (range.size == 0) return;
  const curve::Cubic none{{kBreak, 0, 0}};
  placed_[range.first] = {};
  write(controls_, range.first * kControlBytes, &none, kControlBytes, true);
}

// Frees the buffer itself, not only its ranges: the other kind of slots takes over.
void TrackCache::drop_lines() {
  if (line_ranges_.used() == 0) return;
  for (Slot& slot : slots_) slot.line = {}, slot.polyline_build = 0;
  line_ranges_ = {};
  lines_ = GrowingBuffer(*gl_);
}

void TrackCache::drop_controls() {
  if (control_ranges_.used() == 0) return;
  for (Slot& slot : slots_) slot.control = {};
  control_ranges_ = {};
  controls_ = GrowingBuffer(*gl_);
  placed_.clear();
}

void TrackCache::write(GrowingBuffer& buffer, std::size_t offset, const void* data, std::size_t bytes, bool polyline) {
  buffer.write(offset, data, bytes);
  synced_.bytes += std::int64_t(bytes);
  if (polyline) synced_.polyline_bytes += std::int64_t(bytes);
}

void TrackCache::write_mesh(const sim::SegmentShape& shape, Slot& slot) {
  timed([&] {
    sim::sweep_track(shape, staged_mesh_);
    if (shape.fitted) sim::add_fittings(shape, *shape.fitted, staged_mesh_);
    for (sim::MeshVertex& vertex : staged_mesh_.vertices) vertex.segment = static_cast<float>(slot.segment.index);
  });
  mesh_.fit(staged_mesh_, slot.mesh);
  timed([&] { mesh_.settle(staged_mesh_, slot.mesh); });
  synced_.bytes += mesh_.send(staged_mesh_, slot.mesh);
  slot.shape_build = shape.shape_build;
  slot.fitted = shape.fitted;
}

void TrackCache::fill_breaks(Range range) {
  if (range.size == 0) return;
  staged_line_.assign(range.size, {{0, 0, 0}, {kBreak, 0, 0}});
  write_lines(range);
}

void TrackCache::write_lines(Range range) {
  if (lines_.reserve(std::size_t(line_ranges_.used()) * sizeof(PolylineVertex))) link_lines();
  write(lines_, std::size_t(range.first) * sizeof(PolylineVertex), staged_line_.data(),
        range.size * sizeof(PolylineVertex), true);
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
