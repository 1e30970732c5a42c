// Packs overlay and poses into instance attributes.
#include "gfx/instances.h"

#include <cstddef>

#include "sim/track_mesh.h"

namespace coaster::gfx {
namespace {

constexpr std::size_t kLineFloats = 11, kMarkFloats = 9, kPoseFloats = 16;

void push(std::vector<float>& out, glm::vec3 v) { out.insert(out.end(), {v.x, v.y, v.z}); }

// 0xRRGGBBAA as four floats in 0..1.
void push_colour(std::vector<float>& out, std::uint32_t rgba) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(float((rgba >> shift) & 0xffu) / 255.0f);
}

// Columns of the model's matrix: forward +X, up +Y, right +Z.
void push_pose(std::vector<float>& out, const sim::Pose& pose) {
  const glm::vec3 forward = pose.frame.forward, up = pose.frame.up;
  const float stretch = static_cast<float>(pose.length) / world::kCarLength;  // of the model along the rails
  const glm::vec3 columns[] = {stretch * forward, up, glm::cross(forward, up), glm::vec3(pose.position)};
  for (int i = 0; i < 4; ++i) {
    push(out, columns[i]);
    out.push_back(i == 3 ? 1.0f : 0.0f);
  }
}

}  // namespace

Instances::Instances(const Gl& gl)
    : gl_(&gl),
      line_buffer_(gl), mark_buffer_(gl), pose_buffer_(gl), model_vertices_(gl), model_indices_(gl),
      line_array_(make_vertex_array(gl)), mark_array_(make_vertex_array(gl)), cart_array_(make_vertex_array(gl)) {
  const sim::Mesh model = sim::cart_mesh();
  cart_indices_ = GLsizei(model.indices.size());
  model_vertices_.reserve(model.vertices.size() * sizeof(sim::MeshVertex));
  model_vertices_.write(0, model.vertices.data(), model.vertices.size() * sizeof(sim::MeshVertex));
  model_indices_.reserve(model.indices.size() * sizeof(std::uint32_t));
  model_indices_.write(0, model.indices.data(), model.indices.size() * sizeof(std::uint32_t));
}

void Instances::upload(const view::Overlay& overlay, std::span<const sim::Pose> carts) {
  const auto send = [&](GrowingBuffer& buffer) {
    const bool moved = buffer.reserve(staged_.size() * sizeof(float));
    if (!staged_.empty()) buffer.write(0, staged_.data(), staged_.size() * sizeof(float));
    staged_.clear();
    return moved;
  };
  staged_.clear();
  for (const view::Line& line : overlay.lines) {
    push(staged_, line.from);
    push(staged_, line.to);
    staged_.push_back(line.width_px);
    push_colour(staged_, line.rgba);
  }
  if (send(line_buffer_)) link_lines();
  for (const view::Mark& mark : overlay.marks) {
    push(staged_, mark.position);
    staged_.push_back(mark.radius_px);
    staged_.push_back(mark.shape == view::MarkShape::square ? 1.0f : 0.0f);
    push_colour(staged_, mark.rgba);
  }
  if (send(mark_buffer_)) link_marks();
  for (const sim::Pose& pose : carts) push_pose(staged_, pose);
  if (send(pose_buffer_)) link_carts();
  lines_ = GLsizei(overlay.lines.size()), marks_ = GLsizei(overlay.marks.size()), carts_ = GLsizei(carts.size());
}

void Instances::link_lines() {
  gl_->BindVertexArray(line_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, line_buffer_.id());
  constexpr std::size_t kFloat = sizeof(float), kStride = kLineFloats * kFloat;
  float_attribute(*gl_, 0, 3, kStride, 0, 1);
  float_attribute(*gl_, 1, 3, kStride, 3 * kFloat, 1);
  float_attribute(*gl_, 2, 1, kStride, 6 * kFloat, 1);
  float_attribute(*gl_, 3, 4, kStride, 7 * kFloat, 1);
}

void Instances::link_marks() {
  gl_->BindVertexArray(mark_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, mark_buffer_.id());
  constexpr std::size_t kFloat = sizeof(float), kStride = kMarkFloats * kFloat;
  float_attribute(*gl_, 0, 3, kStride, 0, 1);
  float_attribute(*gl_, 1, 1, kStride, 3 * kFloat, 1);
  float_attribute(*gl_, 2, 1, kStride, 4 * kFloat, 1);
  float_attribute(*gl_, 3, 4, kStride, 5 * kFloat, 1);
}

void Instances::link_carts() {
  gl_->BindVertexArray(cart_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, model_vertices_.id());
  constexpr std::size_t kStride = sizeof(sim::MeshVertex);
  float_attribute(*gl_, 0, 3, kStride, offsetof(sim::MeshVertex, position));
  float_attribute(*gl_, 1, 3, kStride, offsetof(sim::MeshVertex, normal));
  float_attribute(*gl_, 2, 1, kStride, offsetof(sim::MeshVertex, part));
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, model_indices_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, pose_buffer_.id());
  for (std::size_t column = 0; column < 4; ++column)
    float_attribute(*gl_, GLuint(3 + column), 4, kPoseFloats * sizeof(float), column * 4 * sizeof(float), 1);
}

}  // namespace coaster::gfx
