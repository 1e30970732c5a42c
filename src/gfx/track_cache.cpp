#include "gfx/track_cache.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "gfx/gpu_curves.h"
#include "sim/ground/ground.h"
#include "sim/solids/track_mesh.h"

namespace coaster::gfx {

SupportCache::UploadStats SupportCache::sync(const sim::Supports* supports, const sim::Clock& clock,
                                             const std::vector<std::uint8_t>* near, world::CoasterKind kind) {
  UploadStats synced;
  ++stamp_;
  Stopwatch watch{clock};
  if (supports) {
    for (const world::Entity segment : supports->order()) {
      if (near != nullptr && (*near)[segment.index] == 0) continue;
      const sim::SegmentSupports& wanted = *supports->of(segment);
      if (segment.index >= slots_.size()) slots_.resize(segment.index + 1);
      Slot& slot = slots_[segment.index];
      slot.seen = stamp_;
      if (slot.segment == segment && slot.build == wanted.build) continue;
      if (!slot.segment.valid()) held_.push_back(segment.index);
      slot.segment = segment, slot.build = wanted.build;
      if (wanted.bars.empty()) {
        if (slot.mesh != MeshPool::kNone) ++synced.uploads;
        mesh_.release(slot.mesh);
        continue;
      }
      watch.time([&] {
        sim::build_support_mesh(wanted, sim::form_of(kind), staged_);
        for (sim::MeshVertex& vertex : staged_.vertices) vertex.segment = static_cast<float>(segment.index);
      });
      mesh_.write(staged_, slot.mesh, watch);
      ++synced.uploads;
    }
  }
  std::erase_if(held_, [&](std::uint32_t index) {
    Slot& slot = slots_[index];
    if (slot.seen == stamp_) return false;
    mesh_.release(slot.mesh);
    slot = {};
    return true;
  });
  synced.cpu_seconds = watch.seconds;
  return synced;
}

namespace {

static_assert(sizeof(PolylineVertex) == 24, "vertices are uploaded with their memory layout");
static_assert(kControlBytes == 48, "so are control points");

// Returns the build of the ground under a segment's platforms; 0 on the plane.
std::uint64_t ground_under(const sim::Ground* ground, const sim::SegmentShape& shape) {
  constexpr float kPlatform = 4;  // m beside the rails
  if (ground == nullptr) return 0;
  const auto [low, high] = curve::control_box(shape.key.cubic);
  return ground->build_under({low - kPlatform, high + kPlatform});
}

}  // namespace

TrackCache::TrackCache(const Gl& gl)
    : gl_(&gl),
      lines_(gl),
      controls_(gl),
      swept_(gl),
      mesh_(gl),
      supports_(gl),
      buildings_(gl),
      line_array_(make_vertex_array(gl)) {}

TrackCache::UploadStats TrackCache::sync(const sim::DerivedTrack& derived, const sim::Clock& clock,
                                         const sim::Ground* ground) {
  ground_ = ground;
  const bool on_processor = derived.evaluated_by == curve::EvaluatedBy::processor;
  synced_ = {};
  swept_.take_kind(derived.made.kind);
  Stopwatch watch{clock};
  auto changes = derived.changes_since(last_build_);
  if (!(evaluation_ == derived.made.evaluation)) changes.reset();
  if (const sim::SolidsDetail detail = sim::detail_of(derived); !(detail == detail_)) {
    detail_ = detail;
    for (Slot& slot : slots_) slot.shape_build = 0;  // every mesh is rewritten
    changes.reset();
  }
  last_build_ = derived.last_build, evaluation_ = derived.made.evaluation;
  if (!changes) watch.time([&] { take_order(derived); });
  if (on_processor) drop_controls();
  else drop_lines();
  const auto for_changed = [&](const auto& visit) {
    if (!changes) return std::ranges::for_each(derived.order, visit), void();
    for (const sim::ShapeChange& change : *changes) visit(derived.order[change.index]);
  };
  watch.time([&] {
    for_changed([&](world::Entity segment) {
      const SegmentSize size = size_of(derived.shape(segment).key.cubic);
      if (changes) level_choice_.replace(sizes_[segment.index], size);
      sizes_[segment.index] = size;
    });
    const LevelView sight = in_steps(sight_);
    if (!changes || !(sight == levels_for_)) level_choice_.begin(sizes_, derived.steps, sight);
    levels_for_ = sight;
    levels_ = level_choice_.levels();
  });
  watch.time([&] { take_near(derived); });
  for_changed([&](world::Entity segment) {
    ++synced_.looked_at;
    if (write_segment(derived.shape(segment), on_processor, slots_[segment.index], watch)) ++synced_.uploads;
  });
  change_levels(derived, on_processor, watch);
  take_ground(derived, on_processor, watch);
  synced_.cpu_seconds = watch.seconds;
  return synced_;
}

// Gives every segment a slot, and frees those of vanished ones.
void TrackCache::take_order(const sim::DerivedTrack& derived) {
  ++stamp_;
  for (const world::Entity segment : derived.order) slot_of(segment).seen = stamp_;
  if (live_ > derived.order.size())
    for (Slot& slot : slots_)
      if (slot.segment.valid() && slot.seen != stamp_) release(slot);
}

// Returns true if anything of the segment was written.
bool TrackCache::write_segment(const sim::SegmentShape& shape, bool on_processor, Slot& slot, Stopwatch& watch) {
  const Level held = levels_held_[slot.segment.index], wanted = level_of(slot.segment.index);
  const bool line = on_processor && (slot.polyline_build != shape.polyline_build || held.lines != wanted.lines);
  const bool reshaped = slot.shape_build != shape.shape_build;
  const bool solids = reshaped || slot.fitted != shape.fitted || held.solid != wanted.solid;
  const bool control = !on_processor && (reshaped || slot.control.size == 0);
  if (line) write_polyline(shape, slot, watch);
  if (control) write_control(shape, slot);
  if (solids) write_solids(shape, slot, watch);
  return line || control || solids;
}

// Notes which segments are near, and those that were.
void TrackCache::take_near(const sim::DerivedTrack& derived) {
  near_track_.look_from({sight_.eye, ties_});
  near_track_.update(derived);
  if (near_track_.everywhere() != parts_everywhere_) levels_compared_ = {};  // a look at all of them
  parts_everywhere_ = near_track_.everywhere();
  near_detail_ = near_track_.detail(detail_);
  near_.resize(slots_.size());
  for (const std::uint32_t index : were_near_) near_[index] = 0;
  std::erase_if(were_near_, [&](std::uint32_t index) { return levels_held_[index].solid != SolidDetail::with_parts; });
  for (const std::size_t i : near_track_.indices()) {
    const std::uint32_t index = derived.order[i].index;
    near_[index] = 1;
    if (levels_held_[index].solid != SolidDetail::with_parts) were_near_.push_back(index);
  }
}

// Writes the platforms again under which the ground changed.
void TrackCache::take_ground(const sim::DerivedTrack& derived, bool on_processor, Stopwatch& watch) {
  const std::uint64_t build = ground_ != nullptr && !ground_->plain() ? ground_->build() : 0;
  if (std::exchange(ground_build_, build) == build) return;
  for (Slot& slot : slots_) {
    if (!slot.segment.valid() || slot.fitted != world::EquipmentKind::station) continue;
    const sim::SegmentShape& shape = derived.shape(slot.segment);
    if (slot.ground == ground_under(ground_, shape)) continue;
    slot.shape_build = 0;
    if (write_segment(shape, on_processor, slot, watch)) ++synced_.uploads;
  }
}

// Writes the segments again that should be held more finely or more coarsely.
void TrackCache::change_levels(const sim::DerivedTrack& derived, bool on_processor, Stopwatch& watch) {
  if (levels_ == levels_compared_) {
    for (const std::uint32_t index : were_near_) change_level(index, derived, on_processor, watch);
    return;
  }
  levels_compared_ = levels_;
  for (std::size_t i = 0; i < slots_.size(); ++i) change_level(i, derived, on_processor, watch);
}

void TrackCache::change_level(std::size_t index, const sim::DerivedTrack& derived, bool on_processor,
                              Stopwatch& watch) {
  Slot& slot = slots_[index];
  if (!slot.segment.valid()) return;
  Level wanted = level_of(index);
  if (!on_processor) wanted.lines = levels_held_[index].lines;
  if (levels_held_[index] == wanted) return;
  ++synced_.looked_at;
  if (write_segment(derived.shape(slot.segment), on_processor, slot, watch)) ++synced_.uploads;
}

// Returns the slot of a segment, empty if the segment is new; releases the slot of an older generation.
TrackCache::Slot& TrackCache::slot_of(world::Entity segment) {
  if (segment.index >= slots_.size()) {
    slots_.resize(segment.index + 1);
    sizes_.resize(slots_.size()), levels_held_.resize(slots_.size());
  }
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
  sizes_[slot.segment.index] = {}, levels_held_[slot.segment.index] = {};
  held_polyline_bytes_ -= bytes_of(slot);
  slot = Slot{};
  --live_;
}

void TrackCache::write_polyline(const sim::SegmentShape& shape, Slot& slot, Stopwatch& watch) {
  watch.time([&] { sim::evaluate_polyline(shape, polyline_); });
  const std::size_t index = slot.segment.index, last = polyline_.points.size() - 1;
  const auto lines = static_cast<std::size_t>(levels_.lines_of(sizes_[index]));
  const auto count = static_cast<std::uint32_t>(lines + 2);  // its vertices and the break
  if (slot.line.size != count) {
    fill_breaks(slot.line);
    line_ranges_.give_back(slot.line);
    held_polyline_bytes_ -= bytes_of(slot);
    slot.line = line_ranges_.take(count);
    held_polyline_bytes_ += bytes_of(slot);
  }
  watch.time([&] {
    staged_line_.resize(count);
    for (std::size_t i = 0; i <= lines; ++i)
      staged_line_[i] = {polyline_.points[last * i / lines], polyline_.tangents[last * i / lines]};
    staged_line_.back() = {polyline_.points.back(), {kBreak, 0, 0}};
  });
  write_lines(slot.line);
  slot.polyline_build = shape.polyline_build;
  levels_held_[index].lines = static_cast<int>(lines);
}

void TrackCache::write_control(const sim::SegmentShape& shape, Slot& slot) {
  if (slot.control.size == 0) {
    slot.control = control_ranges_.take(1);
    held_polyline_bytes_ += bytes_of(slot);
  }
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

// Frees the buffer itself, not only its ranges, because the other kind of slots replaces it.
void TrackCache::drop_lines() {
  if (line_ranges_.used() == 0) return;
  for (Slot& slot : slots_) slot.line = {}, slot.polyline_build = 0;
  for (Level& level : levels_held_) level.lines = 0;
  held_polyline_bytes_ = 0;
  line_ranges_ = {};
  lines_ = GrowingBuffer<PolylineVertex>(*gl_);
}

void TrackCache::drop_controls() {
  if (control_ranges_.used() == 0) return;
  for (Slot& slot : slots_) slot.control = {};
  held_polyline_bytes_ = 0;
  control_ranges_ = {};
  controls_ = GrowingBuffer<curve::Cubic>(*gl_);
  placed_.clear();
}

std::vector<CurveSlots> TrackCache::control_runs() const {
  constexpr std::size_t kMostRuns = 192;
  std::vector<CurveSlots> runs;
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    const int lines = levels_.far_lines == levels_.steps || !placed_[k].segment.valid()
                          ? levels_.far_lines
                          : levels_.lines_of(sizes_[placed_[k].segment.index]);
    if (runs.empty() || runs.back().steps != lines) runs.push_back({controls_.id(), static_cast<int>(k), 0, lines});
    ++runs.back().count;
  }
  if (runs.size() > kMostRuns) runs = {{controls_.id(), 0, static_cast<int>(placed_.size()), levels_.far_lines}};
  return runs;
}

template <class T>
void TrackCache::write(GrowingBuffer<T>& buffer, Range range, std::span<const T> items) {
  buffer.write(range.first, items);
  synced_.bytes += std::int64_t(items.size_bytes());
  synced_.polyline_bytes += std::int64_t(items.size_bytes());
}

void TrackCache::write_solids(const sim::SegmentShape& shape, Slot& slot, Stopwatch& watch) {
  const SolidDetail solid = level_of(slot.segment.index).solid;
  sim::SolidsDetail detail = solid == SolidDetail::with_parts ? near_detail_ : detail_;
  detail.parts = solid == SolidDetail::with_parts;
  watch.time([&] {
    if (solid == SolidDetail::straight) swept_.stage_far(shape, detail, slot.segment.index);
    else swept_.stage(shape, detail, slot.segment.index);
    staged_mesh_.clear();
    if (shape.fitted) sim::add_fittings(shape, *shape.fitted, staged_mesh_, detail, ground_);
    for (sim::MeshVertex& vertex : staged_mesh_.vertices) vertex.segment = static_cast<float>(slot.segment.index);
  });
  synced_.bytes += swept_.write(slot.swept);
  if (staged_mesh_.vertices.empty()) mesh_.release(slot.mesh);
  else synced_.bytes += mesh_.write(staged_mesh_, slot.mesh, watch);
  slot.shape_build = shape.shape_build;
  slot.fitted = shape.fitted;
  if (slot.fitted == world::EquipmentKind::station) slot.ground = ground_under(ground_, shape);
  levels_held_[slot.segment.index].solid = solid;
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

std::int64_t TrackCache::sync_buildings(const sim::StationBuildings* stations) {
  const std::uint64_t build = stations != nullptr && !stations->mesh.indices.empty() ? stations->build : 0;
  if (building_build_ == build) return 0;
  building_build_ = build;
  if (build == 0) return buildings_.release(building_), 0;
  sim::Mesh mesh = stations->mesh;
  const sim::Clock unmeasured;
  Stopwatch watch{unmeasured};
  return buildings_.write(mesh, building_, watch);
}

}  // namespace coaster::gfx
