#include "gfx/swept_track.h"

#include <algorithm>
#include <cstddef>

namespace coaster::gfx {
namespace {

static_assert(sizeof(Piece) == 96, "pieces are uploaded with their memory layout");

// An edit changes the number of pieces: spare capacity keeps a segment in its range during a drag.
std::uint32_t room_for(std::size_t count) { return static_cast<std::uint32_t>(count + count / 4); }
bool has_room(Range range, std::size_t count) { return count <= range.size && range.size <= room_for(count) + 2; }

Piece piece_between(const sim::Ring& from, const sim::Ring& to, std::uint32_t segment) {
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
Piece piece_at(const sim::Ring& at, double half, std::uint32_t segment) {
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
  constexpr std::size_t kStride = sizeof(Piece);
  constexpr struct {
    int components;
    std::size_t offset;
  } kAttributes[] = {{3, offsetof(Piece, x)},      {3, offsetof(Piece, y)},           {3, offsetof(Piece, z)},
                     {3, offsetof(Piece, origin)}, {2, offsetof(Piece, along)},       {3, offsetof(Piece, next_y)},
                     {3, offsetof(Piece, next_z)}, {3, offsetof(Piece, next_origin)}, {1, offsetof(Piece, next_along)}};
  GLuint location = 3;
  for (const auto& attribute : kAttributes)
    float_attribute(gl, location++, attribute.components, kStride, first * kStride + attribute.offset, 1);
}

}  // namespace

SweptTrack::Row::Row(const Gl& gl, const sim::Mesh& mesh, const std::vector<std::uint32_t>& corners)
    : vertices(gl), indices(gl), pieces(gl), array(make_vertex_array(gl)), index_count(GLsizei(corners.size())) {
  vertices.fill(mesh.vertices);
  indices.fill(corners);
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  mesh_attributes(gl);
  float_attribute(gl, kEndAttribute, 1, sizeof(sim::MeshVertex), offsetof(sim::MeshVertex, along));
  gl.BindVertexArray(0);
}

SweptTrack::SweptTrack(const Gl& gl)
    : gl_(&gl), rows_([&]() -> ByKind<Row> {
        const sim::TrackPieces meshes = sim::track_pieces();
        return {Row(gl, meshes.tubes, meshes.tubes.indices), Row(gl, meshes.caps, meshes.caps.indices),
                Row(gl, meshes.tubes, meshes.tubes.coarse), Row(gl, meshes.tie, meshes.tie.indices)};
      }()) {}

void SweptTrack::stage(const sim::SegmentShape& shape, const sim::Detail& detail, std::uint32_t segment) {
  for (std::vector<Piece>& pieces : staged_) pieces.clear();
  if (detail.most_rings == 0) return;
  const std::vector<sim::Ring> rings = sim::rings_of(shape, detail.most_rings);
  const std::size_t last = rings.size() - 1;
  for (std::size_t i = 0; i < last; ++i) staged_[kTubes].push_back(piece_between(rings[i], rings[i + 1], segment));
  for (std::size_t i = 0; i < last; i += 2)
    staged_[kFarTubes].push_back(piece_between(rings[i], rings[std::min(i + 2, last)], segment));
  staged_[kCaps] = {piece_at(turned(rings[0]), 0, segment), piece_at(rings[last], 0, segment)};
  for (const sim::Ring& at : sim::tie_rings(shape, detail))
    staged_[kTies].push_back(piece_at(at, sim::kHalfTie, segment));
}

void SweptTrack::stage_far(const sim::SegmentShape& shape, const sim::Detail& detail, std::uint32_t segment) {
  for (std::vector<Piece>& pieces : staged_) pieces.clear();
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
    std::vector<Piece> none;
    put(rows_[kind], range, none);
    rows_[kind].ranges.give_back(range);
    range = count > 0 ? rows_[kind].ranges.take(room_for(count)) : Range{};
    rows_[kind].moved = true;
  }
}

// Writes pieces, and empty ones into the rest of their range.
void SweptTrack::put(Row& row, Range range, std::vector<Piece>& pieces) {
  if (range.size == 0) return;
  pieces.resize(range.size, Piece{});
  row.pieces.reserve(row.ranges.used());
  row.pieces.write(range.first, pieces);
}

void SweptTrack::measure(Segment& segment) const {
  constexpr float kReach = 1.2f;  // m, contains everything about a ring
  glm::vec3 low(3e38f), high(-3e38f);
  for (const std::size_t kind : {kTubes, kCaps, kFarTubes})
    for (const Piece& piece : staged_[kind])
      low = glm::min(low, glm::min(piece.origin, piece.next_origin)),
      high = glm::max(high, glm::max(piece.origin, piece.next_origin));
  if (staged_[kFarTubes].empty()) low = high = glm::vec3(0);
  segment.middle = 0.5f * low + 0.5f * high;
  segment.radius = 0.5f * glm::distance(low, high) + kReach;
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
    written += std::int64_t(segment.pieces[kind].size * sizeof(Piece));
  }
  ++version_;
  reach_ = {-1, -1};
  return written;
}

void SweptTrack::release(Id& id) {
  if (id == kNone) return;
  std::vector<Piece> none;
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
    const Row& row = rows_[kind];
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
  for (const Row& row : rows_) sum += std::int64_t(row.ranges.used() * sizeof(Piece));
  return sum;
}

}  // namespace coaster::gfx
