#include "gfx/mesh_pool.h"

#include <algorithm>
#include <cstddef>

namespace coaster::gfx {
namespace {

static_assert(sizeof(sim::MeshVertex) == 36, "vertices are uploaded with their memory layout");

constexpr std::size_t kMostRuns = 96;  // of neighbours drawn in full; if there are more, everything is drawn in full

// An edit changes the number of rings and ties: spare capacity keeps a mesh in its range during a drag.
std::uint32_t with_room(std::size_t count) { return static_cast<std::uint32_t>(count + count / 4 + 3); }
// Rounds to whole triangles, so that every slot and every gap starts with a triangle.
std::uint32_t with_room_for_triangles(std::size_t count) { return (with_room(count) + 2) / 3 * 3; }
bool fits(Range range, std::size_t count) { return count <= range.size && range.size <= 2 * with_room(count); }

}  // namespace

void mesh_attributes(const Gl& gl) {
  constexpr std::size_t kStride = sizeof(sim::MeshVertex);
  float_attribute(gl, 0, 3, kStride, offsetof(sim::MeshVertex, position));
  float_attribute(gl, 1, 3, kStride, offsetof(sim::MeshVertex, normal));
  float_attribute(gl, 2, 1, kStride, offsetof(sim::MeshVertex, part));
  float_attribute(gl, 7, 2, kStride, offsetof(sim::MeshVertex, along));
}

bool reaches(const glm::mat4& light, glm::vec3 middle, float radius) {
  const glm::vec4 at = light * glm::vec4(middle, 1);
  const glm::vec2 scale(glm::length(glm::vec3(light[0].x, light[1].x, light[2].x)),  // of a metre across the light
                        glm::length(glm::vec3(light[0].y, light[1].y, light[2].y)));
  return std::abs(at.x) <= 1 + scale.x * radius && std::abs(at.y) <= 1 + scale.y * radius;
}

// Allocates ranges for a solid.
void MeshPool::fit(const sim::Mesh& mesh, Id& id) {
  if (id == kNone) {
    if (free_.empty()) free_.push_back(static_cast<Id>(solids_.size())), solids_.emplace_back();
    id = free_.back();
    free_.pop_back();
    solids_[id] = {};
    solids_[id].used = true;
    moved_ = true;
  }
  Solid& solid = solids_[id];
  if (!fits(solid.vertices, mesh.vertices.size())) {
    vertex_ranges_.give_back(solid.vertices);
    solid.vertices = vertex_ranges_.take(with_room(mesh.vertices.size()));
  }
  for (Level& level : levels_) {
    const std::size_t count = (mesh.*level.indices).size();
    Range& range = solid.*level.range;
    if (fits(range, count)) continue;
    empty(level, range);
    level.ranges.give_back(range);
    range = level.ranges.take(with_room_for_triangles(count));
    moved_ = true;
  }
}

// Numbers the mesh's vertices as in the buffer and fills up its ranges.
void MeshPool::settle(sim::Mesh& mesh, Id id) {
  Solid& solid = solids_[id];
  const std::uint32_t first = solid.vertices.first;
  for (const Level& level : levels_) {
    for (std::uint32_t& index : mesh.*level.indices) index += first;
    (mesh.*level.indices).resize((solid.*level.range).size, first);
  }
  if (mesh.vertices.empty()) return;
  glm::vec3 low = mesh.vertices[0].position, high = low;
  for (const sim::MeshVertex& vertex : mesh.vertices)
    low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
  solid.middle = 0.5f * low + 0.5f * high;
  solid.radius = 0.5f * glm::distance(low, high);
}

std::int64_t MeshPool::write(sim::Mesh& mesh, Id& id, Stopwatch& watch) {
  written_ = 0;
  fit(mesh, id);
  watch.time([&] { settle(mesh, id); });
  const Solid& solid = solids_[id];
  if (vertices_.reserve(vertex_ranges_.used())) link();
  vertices_.write(solid.vertices.first, mesh.vertices);
  for (Level& level : levels_) write_indices(level, solid.*level.range, mesh.*level.indices);
  near_metres_ = -1;
  return written_ + std::int64_t(mesh.vertices.size() * sizeof(sim::MeshVertex));
}

void MeshPool::release(Id& id) {
  if (id == kNone) return;
  Solid& solid = solids_[id];
  vertex_ranges_.give_back(solid.vertices);
  for (Level& level : levels_) {
    empty(level, solid.*level.range);
    level.ranges.give_back(solid.*level.range);
  }
  solid = {};
  free_.push_back(id);
  id = kNone;
  moved_ = true;
}

// Fills gaps with degenerate triangles.
void MeshPool::empty(Level& level, Range range) {
  if (range.size > 0) write_indices(level, range, std::vector<std::uint32_t>(range.size, 0));
}

void MeshPool::write_indices(Level& level, Range range, const std::vector<std::uint32_t>& indices) {
  if (level.buffer.reserve(level.ranges.used())) link();
  ++version_;  // a solid never changes without its indices
  level.buffer.write(range.first, indices);
  written_ += std::int64_t(range.size * sizeof(std::uint32_t));
}

// Returns the runs of shown solids; the gaps between them hold degenerate triangles.
std::vector<Range> MeshPool::runs_of(const Level& level, const auto& shown) const {
  std::vector<Range> runs;
  bool open = false;
  for (const Id id : level.order) add_to_runs(runs, solids_[id].*level.range, shown(solids_[id]), open);
  return runs;
}

void MeshPool::gather(Level& level) const {
  level.runs = runs_of(level, [&](const Solid& solid) { return solid.far == level.far; });
}

void MeshPool::look_from(glm::vec3 eye, float near_metres) {
  if (!moved_ && eye == eye_ && near_metres == near_metres_) return;
  eye_ = eye, near_metres_ = near_metres;
  if (moved_) {
    for (Level& level : levels_) {
      level.order.clear();
      for (Id id = 0; id < solids_.size(); ++id)
        if (solids_[id].used) level.order.push_back(id);
      std::sort(level.order.begin(), level.order.end(),
                [&](Id a, Id b) { return (solids_[a].*level.range).first < (solids_[b].*level.range).first; });
    }
    moved_ = false;
  }
  for (Solid& solid : solids_) solid.far = glm::distance(eye, solid.middle) - solid.radius > near_metres;
  gather(levels_[0]);
  if (levels_[0].runs.size() > kMostRuns) {
    for (Solid& solid : solids_) solid.far = false;
    gather(levels_[0]);
  }
  gather(levels_[1]);
}

void MeshPool::bind(const Level& level) const {
  gl_->BindVertexArray(level.array.id());
  for (GLuint column = 0; column < 4; ++column)
    gl_->VertexAttrib4f(3 + column, column == 0, column == 1, column == 2, column == 3);
  gl_->VertexAttrib4f(kEndAttribute, -1, 0, 0, 1);
}

void MeshPool::draw(const Level& level, const std::vector<Range>& runs) const {
  if (runs.empty()) return;
  bind(level);
  for (const Range& run : runs)
    gl_->DrawElements(GL_TRIANGLES, GLsizei(run.size), GL_UNSIGNED_INT,
                      reinterpret_cast<const void*>(std::size_t(run.first) * sizeof(std::uint32_t)));
}

int MeshPool::draw() const {
  for (const Level& level : levels_) draw(level, level.runs);
  return draw_calls();
}

ShadowDrawStats MeshPool::cast(const glm::mat4& light, bool unseen) const {
  std::vector<Range> runs =
      runs_of(levels_[0], [&](const Solid& solid) { return reaches(light, solid.middle, solid.radius); });
  if (runs.size() > kMostRuns) runs = {{0, index_count()}};
  if (!unseen) draw(levels_[0], runs);
  ShadowDrawStats cast{static_cast<int>(runs.size())};
  for (const Range& run : runs) cast.triangles += run.size / 3;
  return cast;
}

std::int64_t MeshPool::triangles() const {
  std::int64_t indices = 0;
  for (const Level& level : levels_)
    for (const Range& run : level.runs) indices += run.size;
  return indices / 3;
}

void MeshPool::link() {
  for (const Level& level : levels_) {
    gl_->BindVertexArray(level.array.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, level.buffer.id());
    mesh_attributes(*gl_);
  }
  gl_->BindVertexArray(0);
}

}  // namespace coaster::gfx
