#include "gfx/mesh_pool.h"

#include <algorithm>
#include <cstddef>

namespace coaster::gfx {
namespace {

static_assert(sizeof(sim::MeshVertex) == 36, "vertices are uploaded with their memory layout");

constexpr std::size_t kMostRuns = 96;  // of neighbours drawn in full; with more runs everything is

// An edit changes the number of rings and ties: spare room keeps a mesh in its range while a knot is dragged.
std::uint32_t with_room(std::size_t count) { return static_cast<std::uint32_t>(count + count / 4 + 3); }
// Whole triangles, so that every slot and every gap starts with a triangle.
std::uint32_t with_room_for_triangles(std::size_t count) { return (with_room(count) + 2) / 3 * 3; }
bool fits(Range range, std::size_t count) { return count <= range.size && range.size <= 2 * with_room(count); }

}  // namespace

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
  const auto place = [&](std::size_t count, GrowingBuffer& buffer, Ranges& ranges, Range& range) {
    if (fits(range, count)) return;
    empty(buffer, ranges, range);
    ranges.give_back(range);
    range = ranges.take(with_room_for_triangles(count));
    moved_ = true;
  };
  place(mesh.indices.size(), indices_, index_ranges_, solid.indices);
  place(mesh.coarse.size(), coarse_, coarse_ranges_, solid.coarse);
}

void MeshPool::settle(sim::Mesh& mesh, Id id) {
  Solid& solid = solids_[id];
  const std::uint32_t first = solid.vertices.first;
  for (std::uint32_t& index : mesh.indices) index += first;
  for (std::uint32_t& index : mesh.coarse) index += first;
  mesh.indices.resize(solid.indices.size, first);
  mesh.coarse.resize(solid.coarse.size, first);
  if (mesh.vertices.empty()) return;
  glm::vec3 low = mesh.vertices[0].position, high = low;
  for (const sim::MeshVertex& vertex : mesh.vertices)
    low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
  solid.middle = 0.5f * low + 0.5f * high;
  solid.radius = 0.5f * glm::distance(low, high);
}

std::int64_t MeshPool::send(const sim::Mesh& mesh, Id id) {
  written_ = 0;
  const Solid& solid = solids_[id];
  if (vertices_.reserve(std::size_t(vertex_ranges_.used()) * sizeof(sim::MeshVertex))) link();
  const std::size_t bytes = mesh.vertices.size() * sizeof(sim::MeshVertex);
  if (bytes > 0)
    vertices_.write(std::size_t(solid.vertices.first) * sizeof(sim::MeshVertex), mesh.vertices.data(), bytes);
  write_indices(indices_, index_ranges_, solid.indices, mesh.indices);
  write_indices(coarse_, coarse_ranges_, solid.coarse, mesh.coarse);
  near_metres_ = -1;
  return written_ + std::int64_t(bytes);
}

void MeshPool::release(Id& id) {
  if (id == kNone) return;
  Solid& solid = solids_[id];
  empty(indices_, index_ranges_, solid.indices);
  empty(coarse_, coarse_ranges_, solid.coarse);
  vertex_ranges_.give_back(solid.vertices);
  index_ranges_.give_back(solid.indices);
  coarse_ranges_.give_back(solid.coarse);
  solid = {};
  free_.push_back(id);
  id = kNone;
  moved_ = true;
}

// Fills gaps with degenerate triangles.
void MeshPool::empty(GrowingBuffer& buffer, const Ranges& ranges, Range range) {
  if (range.size > 0) write_indices(buffer, ranges, range, std::vector<std::uint32_t>(range.size, 0));
}

void MeshPool::write_indices(GrowingBuffer& buffer, const Ranges& ranges, Range range,
                             const std::vector<std::uint32_t>& indices) {
  if (buffer.reserve(std::size_t(ranges.used()) * sizeof(std::uint32_t))) link();
  ++version_;  // a solid never changes without its indices
  buffer.write(std::size_t(range.first) * sizeof(std::uint32_t), indices.data(), range.size * sizeof(std::uint32_t));
  written_ += std::int64_t(range.size * sizeof(std::uint32_t));
}

// Collects runs of solids that are adjacent in a buffer and of the same kind; the gaps between them hold degenerate
// triangles.
void MeshPool::gather(Range Solid::*range, bool far, const std::vector<Id>& order, std::vector<Run>& runs) const {
  runs.clear();
  bool open = false;
  for (const Id id : order) {
    const Solid& solid = solids_[id];
    const Range place = solid.*range;
    if (solid.far != far) {
      open = false;
      continue;
    }
    if (!open) runs.push_back({place.first, 0});
    runs.back().count = place.first + place.size - runs.back().first;
    open = true;
  }
}

void MeshPool::look_from(glm::vec3 eye, float near_metres) {
  if (!moved_ && eye == eye_ && near_metres == near_metres_) return;
  eye_ = eye, near_metres_ = near_metres;
  if (moved_) {
    const auto sorted = [&](Range Solid::*range, std::vector<Id>& order) {
      order.clear();
      for (Id id = 0; id < solids_.size(); ++id)
        if (solids_[id].used) order.push_back(id);
      std::sort(order.begin(), order.end(),
                [&](Id a, Id b) { return (solids_[a].*range).first < (solids_[b].*range).first; });
    };
    sorted(&Solid::indices, fine_order_);
    sorted(&Solid::coarse, coarse_order_);
    moved_ = false;
  }
  for (Solid& solid : solids_) solid.far = glm::distance(eye, solid.middle) - solid.radius > near_metres;
  gather(&Solid::indices, false, fine_order_, fine_runs_);
  if (fine_runs_.size() > kMostRuns) {
    for (Solid& solid : solids_) solid.far = false;
    gather(&Solid::indices, false, fine_order_, fine_runs_);
  }
  gather(&Solid::coarse, true, coarse_order_, coarse_runs_);
}

void MeshPool::bind(const Object& array) const {
  gl_->BindVertexArray(array.id());
  for (GLuint column = 0; column < 4; ++column)
    gl_->VertexAttrib4f(3 + column, column == 0, column == 1, column == 2, column == 3);
}

int MeshPool::draw() const {
  const auto pass = [&](const Object& array, const std::vector<Run>& runs) {
    if (runs.empty()) return;
    bind(array);
    for (const Run& run : runs)
      gl_->DrawElements(GL_TRIANGLES, GLsizei(run.count), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(std::size_t(run.first) * sizeof(std::uint32_t)));
  };
  pass(fine_array_, fine_runs_);
  pass(coarse_array_, coarse_runs_);
  return draw_calls();
}

void MeshPool::draw_all() const {
  bind(fine_array_);
  gl_->DrawElements(GL_TRIANGLES, GLsizei(index_ranges_.used()), GL_UNSIGNED_INT, nullptr);
}

std::int64_t MeshPool::triangles() const {
  std::int64_t indices = 0;
  for (const auto* runs : {&fine_runs_, &coarse_runs_})
    for (const Run& run : *runs) indices += run.count;
  return indices / 3;
}

void MeshPool::link() {
  for (const bool far : {false, true}) {
    gl_->BindVertexArray((far ? coarse_array_ : fine_array_).id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, (far ? coarse_ : indices_).id());
    constexpr std::size_t kStride = sizeof(sim::MeshVertex);
    float_attribute(*gl_, 0, 3, kStride, offsetof(sim::MeshVertex, position));
    float_attribute(*gl_, 1, 3, kStride, offsetof(sim::MeshVertex, normal));
    float_attribute(*gl_, 2, 1, kStride, offsetof(sim::MeshVertex, part));
    float_attribute(*gl_, 7, 2, kStride, offsetof(sim::MeshVertex, along));
  }
  gl_->BindVertexArray(0);
}

}  // namespace coaster::gfx
