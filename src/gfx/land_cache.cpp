#include "gfx/land_cache.h"

#include <bit>
#include <cstddef>

namespace coaster::gfx {
namespace {

constexpr std::size_t kPatchVertices = std::size_t{sim::LandPatch::kSide} * sim::LandPatch::kSide;
constexpr std::size_t kPatchIndices = std::size_t{6} * world::kGroundTileCells * world::kGroundTileCells;

void byte_attribute(const Gl& gl, GLuint location, int components, GLenum type, std::size_t stride,
                    std::size_t offset) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, type, GL_TRUE, GLsizei(stride), reinterpret_cast<const void*>(offset));
}

}  // namespace

void land_attributes(const Gl& gl, GLuint buffer, std::size_t first) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  const std::size_t offset = first * sizeof(sim::LandVertex);
  float_attribute(gl, 0, 3, sizeof(sim::LandVertex), offset);
  byte_attribute(gl, 1, 4, GL_BYTE, sizeof(sim::LandVertex), offset + offsetof(sim::LandVertex, normal));
  byte_attribute(gl, 2, 4, GL_UNSIGNED_BYTE, sizeof(sim::LandVertex), offset + offsetof(sim::LandVertex, paint));
}

void light_attribute(const Gl& gl, GLuint buffer, std::size_t first) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  byte_attribute(gl, 3, 2, GL_UNSIGNED_BYTE, sizeof(sim::LandLight), first * sizeof(sim::LandLight));
}

void LandCache::make_shared() {
  std::vector<std::uint16_t> all;
  const auto add = [&](int step, int snapped) {
    const std::vector<std::uint16_t> list = patch_indices(step, static_cast<std::uint8_t>(snapped));
    lists_[{step, snapped}] = {static_cast<std::uint32_t>(all.size()), static_cast<std::uint32_t>(list.size())};
    all.insert(all.end(), list.begin(), list.end());
  };
  for (int snapped = 1; snapped <= kAllSides; ++snapped) add(1, snapped);
  add(2, kAllSides);
  add(4, kAllSides);
  shared_.fill(all);
}

// Gives each patch an array of its own, after the buffers have moved.
void LandCache::link() {
  const Gl& gl = *gl_;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (held_[i].array.id() == 0) held_[i].array = make_vertex_array(gl);
    gl.BindVertexArray(held_[i].array.id());
    land_attributes(gl, vertices_.id(), i * kPatchVertices);
    light_attribute(gl, light_.id(), i * kPatchVertices);
  }
  gl.BindVertexArray(0);
}

LandCache::UploadStats LandCache::sync(const sim::Ground& ground, const sim::LandMesh& mesh) {
  UploadStats stats;
  const std::span<const sim::LandPatch> patches = mesh.patches();
  if (lists_.empty()) make_shared();
  if (reset_ != mesh.reset_build() || held_.size() != patches.size()) {
    reset_ = mesh.reset_build();
    held_.clear();
    held_.resize(patches.size());
    vertices_.reserve(patches.size() * kPatchVertices);
    light_.reserve(patches.size() * kPatchVertices);
    own_.reserve(patches.size() * kPatchIndices);
    link();
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const sim::LandPatch& patch = patches[i];
    Held& held = held_[i];
    if (held.light_build != patch.light_build) {
      held.light_build = patch.light_build;
      light_.write(i * kPatchVertices, patch.light);
      stats.bytes += static_cast<std::int64_t>(patch.light.size() * sizeof(sim::LandLight));
    }
    if (held.build == patch.build) continue;
    held.build = patch.build;
    held.indices = GLsizei(patch.indices.size());
    vertices_.write(i * kPatchVertices, patch.vertices);
    own_.write(i * kPatchIndices, patch.indices);
    ++stats.patches;
    stats.bytes += static_cast<std::int64_t>(patch.vertices.size() * sizeof(sim::LandVertex) +
                                             patch.indices.size() * sizeof(std::uint16_t));
  }
  sync_far(ground, mesh, stats);
  return stats;
}

void LandCache::sync_far(const sim::Ground& ground, const sim::LandMesh& mesh, UploadStats& stats) {
  const world::Park& park = ground.land().park();
  std::vector<std::uint64_t> key{mesh.reset_build(), std::bit_cast<std::uint64_t>(park.relief),
                                 std::bit_cast<std::uint64_t>(park.woods)};
  const int across = ground.tiles_across();
  for (int i = 0; i < across * across; ++i)
    if (i % across == 0 || i % across == across - 1 || i / across == 0 || i / across == across - 1)
      key.push_back(mesh.patches()[static_cast<std::size_t>(i)].build);
  if (key == far_key_) return;
  far_key_ = std::move(key);
  far_land_ = far_land(ground, mesh.field());
  far_.fill(far_land_.vertices);
  far_indices_.fill(far_land_.indices);
  stats.bytes += static_cast<std::int64_t>(far_land_.vertices.size() * sizeof(sim::LandVertex) +
                                           far_land_.indices.size() * sizeof(std::uint16_t));
  if (far_array_.id() == 0) far_array_ = make_vertex_array(*gl_);
  gl_->BindVertexArray(far_array_.id());
  land_attributes(*gl_, far_.id(), 0);
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, far_indices_.id());
  gl_->BindVertexArray(0);
}

std::int64_t LandCache::draw(const sim::LandMesh& mesh, const VisiblePatch& patch, bool unseen) const {
  const Held& held = held_[patch.index];
  // A patch with open cells has only its own triangles, and its neighbours are as fine.
  const bool own = (patch.step == 1 && patch.snapped == 0) || mesh.patches()[patch.index].open;
  Range range{static_cast<std::uint32_t>(patch.index * kPatchIndices), static_cast<std::uint32_t>(held.indices)};
  if (!own) range = lists_.at({patch.step, patch.snapped});
  if (!unseen) {
    gl_->BindVertexArray(held.array.id());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, own ? own_.id() : shared_.id());
    gl_->DrawElements(GL_TRIANGLES, GLsizei(range.size), GL_UNSIGNED_SHORT,
                      reinterpret_cast<const void*>(std::size_t{range.first} * sizeof(std::uint16_t)));
  }
  return range.size / 3;
}

std::int64_t LandCache::draw_far(const glm::mat4& view_projection, bool unseen) const {
  std::int64_t triangles = 0;
  if (far_land_.vertices.empty()) return 0;
  const float half = far_land_.vertices[0].position.x < 0 ? -far_land_.vertices[0].position.x : 1;
  const float far = kFarthestLand * half;
  const Box whole{{-far, far_land_.low, -far}, {far, far_land_.high, far}};
  if (!unseen) {
    gl_->BindVertexArray(far_array_.id());
    gl_->VertexAttrib4f(3, 1, 0, 0, 0);  // full sunlight, no lamps
  }
  for (std::size_t side = 0; side < 4; ++side) {
    Box box = whole;
    if (side == 0) box.high.z = -half;
    if (side == 1) box.low.x = half;
    if (side == 2) box.low.z = half;
    if (side == 3) box.high.x = -half;
    if (!may_show(view_projection, box)) continue;
    const std::uint32_t first = far_land_.sides[side], count = far_land_.sides[side + 1] - first;
    if (!unseen)
      gl_->DrawElements(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_SHORT,
                        reinterpret_cast<const void*>(std::size_t{first} * sizeof(std::uint16_t)));
    triangles += count / 3;
  }
  return triangles;
}

}  // namespace coaster::gfx
