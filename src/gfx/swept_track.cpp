#include "gfx/swept_track.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace coaster::gfx {
namespace {

constexpr std::size_t kMostRunsOfKind = 96;  // of one kind

static_assert(sizeof(SweptPiece) == 96, "pieces are uploaded with their memory layout");

// An edit changes the number of pieces: spare capacity keeps a segment in its range during a drag.
std::uint32_t room_for(std::size_t count) { return static_cast<std::uint32_t>(count + count / 4); }
bool has_room(Range range, std::size_t count) { return count <= range.size && range.size <= room_for(count) + 2; }

SweptPiece piece_between(const sim::Ring& from, const sim::Ring& to, std::uint32_t segment) {
  const glm::dvec3 right = -from.frame.left(), next_right = -to.frame.left();
  return {.x = from.frame.forward,
          .y = from.frame.up,
          .z = right,
          .origin = from.position,
          .along = from.along,
          .segment = static_cast<float>(segment),
          .next_y = to.frame.up,
          .next_z = next_right,
          .next_origin = to.position,
          .next_along = to.along};
}

// Returns the piece at a ring, extended by `half` metres to both sides.
SweptPiece piece_at(const sim::Ring& at, double half, std::uint32_t segment) {
  sim::Ring from = at, to = at;
  from.position -= half * at.frame.forward, to.position += half * at.frame.forward;
  return piece_between(from, to, segment);
}

// Returns the same ring seen in the opposite direction.
sim::Ring turned(sim::Ring ring) {
  ring.frame.forward = -ring.frame.forward;
  return ring;
}

// Sets the attributes of an instance from the bound buffer, beginning with a piece.
void piece_attributes(const Gl& gl, std::uint32_t first) {
  constexpr std::size_t kStride = sizeof(SweptPiece);
  constexpr struct {
    int components;
    std::size_t offset;
  } kAttributes[] = {
      {3, offsetof(SweptPiece, x)},      {3, offsetof(SweptPiece, y)},           {3, offsetof(SweptPiece, z)},
      {3, offsetof(SweptPiece, origin)}, {2, offsetof(SweptPiece, along)},       {3, offsetof(SweptPiece, next_y)},
      {3, offsetof(SweptPiece, next_z)}, {3, offsetof(SweptPiece, next_origin)}, {1, offsetof(SweptPiece, next_along)}};
  GLuint location = 3;
  for (const auto& attribute : kAttributes)
    float_attribute(gl, location++, attribute.components, kStride, first * kStride + attribute.offset, 1);
}

}  // namespace

void SweptTrack::sort() {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (!rows_[kind].moved) continue;
    rows_[kind].moved = false;
    grouped_ = false;
    std::vector<Id>& order = rows_[kind].order;
    order.clear();
    for (Id id = 0; id < segments_.size(); ++id)
      if (segments_[id].pieces[kind].size > 0) order.push_back(id);
    std::sort(order.begin(), order.end(),
              [&](Id a, Id b) { return segments_[a].pieces[kind].first < segments_[b].pieces[kind].first; });
  }
  if (!std::exchange(grouped_, true)) group();
}

void SweptTrack::group() {
  constexpr std::uint32_t kMostPieces = 64;  // in a part
  near_.clear();
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    std::vector<SegmentGroup>& parts = parts_[kind];
    parts.clear();
    for (const Id id : rows_[kind].order) {
      const Segment& segment = segments_[id];
      const Range place = segment.pieces[kind];
      if (!segment.far) {
        parts.push_back({place, id});
        if (kind == kFarTubes) near_.push_back(id);
        continue;
      }
      const glm::vec3 low = segment.middle - segment.radius, high = segment.middle + segment.radius;
      const bool joins =
          !parts.empty() && parts.back().near == kNone && place.end() - parts.back().place.first <= kMostPieces;
      if (!joins) {
        parts.push_back({place, kNone, low, high});
        continue;
      }
      SegmentGroup& part = parts.back();
      part.place.size = place.end() - part.place.first;
      part.low = glm::min(part.low, low), part.high = glm::max(part.high, high);
    }
  }
}

// Makes the part of a far segment contain it. A group() makes it smaller again.
void SweptTrack::widen_part(const Segment& segment) {
  std::vector<SegmentGroup>& parts = parts_[kFarTubes];
  const auto first = [](const SegmentGroup& part) { return part.place.first; };
  const auto after = std::ranges::upper_bound(parts, segment.pieces[kFarTubes].first, {}, first);
  if (after == parts.begin()) return;
  SegmentGroup& part = *std::prev(after);
  part.low = glm::min(part.low, segment.middle - segment.radius);
  part.high = glm::max(part.high, segment.middle + segment.radius);
}

std::size_t SweptTrack::part_count() const {
  std::size_t count = 0;
  for (const std::vector<SegmentGroup>& parts : parts_) count += parts.size();
  return count;
}

// Collects runs of shown parts; the gaps between them hold empty pieces.
void SweptTrack::gather(Runs& runs, const auto& shows_far) const {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    runs[kind].clear();
    bool open = false;
    for (const SegmentGroup& part : parts_[kind]) {
      const bool shown = part.near == kNone ? shows_far(part) : (shown_[part.near] >> kind & 1) != 0;
      add_to_runs(runs[kind], part.place, shown, open);
    }
  }
}

void SweptTrack::choose(const DetailDistances& reach) {
  shown_.resize(segments_.size());
  for (const Id id : near_) {
    const Segment& segment = segments_[id];
    const float metres = glm::distance(eye_, segment.middle) - segment.radius;
    shown_[id] = static_cast<std::uint8_t>(metres > reach.full ? 1 << kFarTubes : 1 << kTubes | 1 << kCaps);
    if (metres <= reach.ties) shown_[id] |= 1 << kTies;
  }
  gather(chosen_, [](const SegmentGroup&) { return true; });
}

void SweptTrack::look_from(glm::vec3 eye, DetailDistances reach) {
  if (eye == eye_ && reach == reach_) return;
  eye_ = eye, reach_ = reach;
  sort();
  constexpr int kMostHalvings = 12;
  for (int halvings = 0;; ++halvings, reach.full /= 2, reach.ties /= 2) {
    if (halvings == kMostHalvings) reach = {-1, -1};
    choose(reach);
    const bool few_runs = std::all_of(chosen_.begin(), chosen_.end(),
                                      [](const std::vector<Range>& runs) { return runs.size() <= kMostRunsOfKind; });
    if (halvings == kMostHalvings || (few_runs && triangles() <= kTriangleBudget)) return;
  }
}

ShadowDrawStats SweptTrack::cast(const glm::mat4& light, float texel_metres, bool unseen) {
  sort();
  const bool full = texel_metres < 8 * static_cast<float>(sim::kRailRadius);
  const auto kinds = static_cast<std::uint8_t>(full ? 1 << kTubes | 1 << kCaps | 1 << kTies : 1 << kFarTubes);
  shown_.resize(segments_.size());
  for (const Id id : near_)
    shown_[id] = reaches(light, segments_[id].middle, segments_[id].radius) ? kinds : std::uint8_t{0};
  gather(cast_, [&](const SegmentGroup& part) {
    return reaches(light, 0.5f * (part.low + part.high), 0.5f * glm::distance(part.low, part.high));
  });
  for (std::vector<Range>& runs : cast_)
    if (runs.size() > kMostRunsOfKind) runs = {Range{runs.front().first, runs.back().end() - runs.front().first}};
  if (!unseen) draw(cast_);
  return {draw_calls(cast_), triangles(cast_)};
}

SweptTrack::PieceBatch::PieceBatch(const Gl& gl)
    : vertices(gl), indices(gl), pieces(gl), array(make_vertex_array(gl)) {}

void SweptTrack::PieceBatch::fill(const Gl& gl, const sim::Mesh& mesh, const std::vector<std::uint32_t>& corners) {
  index_count = GLsizei(corners.size());
  vertices.fill(mesh.vertices);
  indices.fill(corners);
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  mesh_attributes(gl);
  float_attribute(gl, kEndAttribute, 1, sizeof(sim::MeshVertex), offsetof(sim::MeshVertex, along));
  gl.BindVertexArray(0);
}

SweptTrack::SweptTrack(const Gl& gl) : gl_(&gl), rows_{PieceBatch(gl), PieceBatch(gl), PieceBatch(gl), PieceBatch(gl)} {
  take_kind({});
}

void SweptTrack::take_kind(world::CoasterKind kind) {
  if (kind_ == kind) return;
  kind_ = kind;
  const sim::TrackPieces meshes = sim::track_pieces(sim::form_of(kind));
  rows_[kTubes].fill(*gl_, meshes.tubes, meshes.tubes.indices),
      rows_[kCaps].fill(*gl_, meshes.caps, meshes.caps.indices);
  rows_[kFarTubes].fill(*gl_, meshes.tubes, meshes.tubes.coarse),
      rows_[kTies].fill(*gl_, meshes.tie, meshes.tie.indices);
  reach_ = {-1, -1};
}

void SweptTrack::stage(const sim::SegmentShape& shape, const sim::SolidsDetail& detail, std::uint32_t segment) {
  for (std::vector<SweptPiece>& pieces : staged_) pieces.clear();
  if (detail.most_rings == 0) return;
  const std::vector<sim::Ring> rings = sim::rings_of(shape, detail.most_rings);
  const std::size_t last = rings.size() - 1;
  for (std::size_t i = 0; i < last; ++i) staged_[kTubes].push_back(piece_between(rings[i], rings[i + 1], segment));
  for (std::size_t i = 0; i < last; i += 2)
    staged_[kFarTubes].push_back(piece_between(rings[i], rings[std::min(i + 2, last)], segment));
  staged_[kCaps] = {piece_at(turned(rings[0]), 0, segment), piece_at(rings[last], 0, segment)};
  for (const sim::Ring& at : sim::tie_rings(shape, detail))
    staged_[kTies].push_back(piece_at(at, sim::form_of(shape).half_tie, segment));
}

void SweptTrack::stage_far(const sim::SegmentShape& shape, const sim::SolidsDetail& detail, std::uint32_t segment) {
  for (std::vector<SweptPiece>& pieces : staged_) pieces.clear();
  if (detail.most_rings == 0) return;
  staged_[kFarTubes] = {piece_between(sim::ring_at(shape, 0), sim::ring_at(shape, shape.arc.length()), segment)};
}

// Allocates ranges for the staged pieces.
void SweptTrack::fit(Id& id) {
  if (id == kNone) {
    if (free_.empty()) free_.push_back(static_cast<Id>(segments_.size())), segments_.emplace_back();
    id = free_.back();
    free_.pop_back();
    segments_[id] = {};
  }
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    Range& range = segments_[id].pieces[kind];
    const std::size_t count = staged_[kind].size();
    if (has_room(range, count)) continue;
    std::vector<SweptPiece> none;
    put(rows_[kind], range, none);
    rows_[kind].ranges.give_back(range);
    range = count > 0 ? rows_[kind].ranges.take(room_for(count)) : Range{};
    rows_[kind].moved = true;
  }
}

// Writes pieces, and empty ones into the rest of their range.
void SweptTrack::put(PieceBatch& row, Range range, std::vector<SweptPiece>& pieces) {
  if (range.size == 0) return;
  pieces.resize(range.size, SweptPiece{});
  row.pieces.reserve(row.ranges.used());
  row.pieces.write(range.first, pieces);
}

void SweptTrack::measure(Segment& segment) const {
  const auto reach = static_cast<float>(sim::form_of(*kind_).reach);
  glm::vec3 low(3e38f), high(-3e38f);
  for (const std::size_t kind : {kTubes, kCaps, kFarTubes})
    for (const SweptPiece& piece : staged_[kind])
      low = glm::min(low, glm::min(piece.origin, piece.next_origin)),
      high = glm::max(high, glm::max(piece.origin, piece.next_origin));
  if (staged_[kFarTubes].empty()) low = high = glm::vec3(0);
  segment.middle = 0.5f * low + 0.5f * high;
  segment.radius = 0.5f * glm::distance(low, high) + reach;
  segment.far = staged_[kTubes].empty();
}

std::int64_t SweptTrack::write(Id& id) {
  fit(id);
  Segment& segment = segments_[id];
  const bool was_far = segment.far;
  measure(segment);
  if (was_far && segment.far) widen_part(segment);
  else if (was_far || segment.far) grouped_ = false;
  std::int64_t written = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    put(rows_[kind], segment.pieces[kind], staged_[kind]);
    written += std::int64_t(segment.pieces[kind].size * sizeof(SweptPiece));
  }
  ++version_;
  reach_ = {-1, -1};
  return written;
}

void SweptTrack::release(Id& id) {
  if (id == kNone) return;
  std::vector<SweptPiece> none;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    none.clear();
    put(rows_[kind], segments_[id].pieces[kind], none);
    rows_[kind].ranges.give_back(segments_[id].pieces[kind]);
    rows_[kind].moved = true;
  }
  segments_[id] = {};
  free_.push_back(id);
  id = kNone;
  ++version_;
  reach_ = {-1, -1};
}

void SweptTrack::draw(const Runs& runs) const {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (runs[kind].empty()) continue;
    const PieceBatch& row = rows_[kind];
    gl_->BindVertexArray(row.array.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, row.pieces.id());
    for (const Range& run : runs[kind]) {
      piece_attributes(*gl_, run.first);
      gl_->DrawElementsInstanced(GL_TRIANGLES, row.index_count, GL_UNSIGNED_INT, nullptr, GLsizei(run.size));
    }
  }
}

int SweptTrack::draw_calls(const Runs& runs) const {
  std::size_t calls = 0;
  for (const std::vector<Range>& of_kind : runs) calls += of_kind.size();
  return static_cast<int>(calls);
}

std::int64_t SweptTrack::triangles(const Runs& runs) const {
  std::int64_t sum = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind)
    for (const Range& run : runs[kind]) sum += std::int64_t{run.size} * (rows_[kind].index_count / 3);
  return sum;
}

std::int64_t SweptTrack::bytes() const {
  std::int64_t sum = 0;
  for (const PieceBatch& row : rows_) sum += std::int64_t(row.ranges.used() * sizeof(SweptPiece));
  return sum;
}

}  // namespace coaster::gfx
