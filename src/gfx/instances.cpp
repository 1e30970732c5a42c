// Packs overlay and poses into instance attributes.
#include "gfx/instances.h"

#include <cstddef>

#include "sim/solids/train_mesh.h"

namespace coaster::gfx {
namespace {

constexpr std::size_t kLineFloats = 11, kMarkFloats = 9, kPoseFloats = 16;

void push(std::vector<float>& out, glm::vec3 v) { out.insert(out.end(), {v.x, v.y, v.z}); }

// Appends 0xRRGGBBAA as four floats in 0..1.
void push_colour(std::vector<float>& out, std::uint32_t rgba) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(float((rgba >> shift) & 0xffu) / 255.0f);
}

// Appends the columns of the model matrix.
void push_matrix(std::vector<float>& out, glm::vec3 x, glm::vec3 y, glm::vec3 z, glm::vec3 origin) {
  const glm::vec3 columns[] = {x, y, z, origin};
  for (int i = 0; i < 4; ++i) {
    push(out, columns[i]);
    out.push_back(i == 3 ? 1.0f : 0.0f);
  }
}

double stretch(const sim::Pose& pose) {
  return pose.length / static_cast<double>(world::kCarLength);
}  // of the model along the rails

// Returns a car's hitch: in front (+1) or behind (-1).
glm::dvec3 hitch(const sim::Pose& pose, double way) {
  return pose.position + way * sim::kHitchBack * stretch(pose) * pose.frame.forward + sim::kHitchHeight * pose.frame.up;
}

}  // namespace

Instances::Model::Model(const Gl& gl, const sim::Mesh& mesh)
    : vertices(gl), indices(gl), poses(gl), array(make_vertex_array(gl)), index_count(GLsizei(mesh.indices.size())) {
  vertices.reserve(mesh.vertices.size() * sizeof(sim::MeshVertex));
  vertices.write(0, mesh.vertices.data(), mesh.vertices.size() * sizeof(sim::MeshVertex));
  indices.reserve(mesh.indices.size() * sizeof(std::uint32_t));
  indices.write(0, mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
}

void Instances::Model::link(const Gl& gl) {
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
  constexpr std::size_t kStride = sizeof(sim::MeshVertex);
  float_attribute(gl, 0, 3, kStride, offsetof(sim::MeshVertex, position));
  float_attribute(gl, 1, 3, kStride, offsetof(sim::MeshVertex, normal));
  float_attribute(gl, 2, 1, kStride, offsetof(sim::MeshVertex, part));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, poses.id());
  for (std::size_t column = 0; column < 4; ++column)
    float_attribute(gl, GLuint(3 + column), 4, kPoseFloats * sizeof(float), column * 4 * sizeof(float), 1);
}

Instances::Instances(const Gl& gl)
    : gl_(&gl),
      line_buffer_(gl),
      mark_buffer_(gl),
      line_array_(make_vertex_array(gl)),
      mark_array_(make_vertex_array(gl)),
      leading_(gl, sim::car_mesh(true)),
      following_(gl, sim::car_mesh(false)),
      coupling_(gl, sim::coupling_mesh()) {}

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
  lines_ = GLsizei(overlay.lines.size()), marks_ = GLsizei(overlay.marks.size());
  stage_cars(carts, true);
  send_poses(leading_);
  stage_cars(carts, false);
  send_poses(following_);
  stage_couplings(carts);
  send_poses(coupling_);
}

void Instances::stage_cars(std::span<const sim::Pose> cars, bool leading) {
  for (const sim::Pose& car : cars) {
    if (car.leads != leading) continue;
    const glm::vec3 forward = car.frame.forward, up = car.frame.up;
    push_matrix(staged_, static_cast<float>(stretch(car)) * forward, up, glm::cross(forward, up),
                glm::vec3(car.position));
  }
}

// Adds a coupling from each car to the rear of the car before it; cars that touch have none.
void Instances::stage_couplings(std::span<const sim::Pose> cars) {
  constexpr double kShortest = 0.02, kLongest = 25;  // m
  for (std::size_t i = 1; i < cars.size(); ++i) {
    if (cars[i].leads) continue;
    const glm::dvec3 from = hitch(cars[i], 1), way = hitch(cars[i - 1], -1) - from;
    const double length = glm::length(way);
    if (!(length > kShortest && length < kLongest)) continue;
    const glm::dvec3 forward = way / length, up = curve::perpendicular(forward, cars[i].frame.up);
    push_matrix(staged_, glm::vec3(way), glm::vec3(up), glm::vec3(glm::cross(forward, up)), glm::vec3(from));
  }
}

void Instances::send_poses(Model& model) {
  model.count = GLsizei(staged_.size() / kPoseFloats);
  const bool moved = model.poses.reserve(staged_.size() * sizeof(float));
  if (!staged_.empty()) model.poses.write(0, staged_.data(), staged_.size() * sizeof(float));
  if (moved) model.link(*gl_);
  staged_.clear();
}

int Instances::draw_cars() const {
  for (const Model* model : {&leading_, &following_, &coupling_}) {
    if (model->count == 0) continue;
    gl_->BindVertexArray(model->array.id());
    gl_->VertexAttrib4f(7, 0, 0, 0, 1);
    gl_->DrawElementsInstanced(GL_TRIANGLES, model->index_count, GL_UNSIGNED_INT, nullptr, model->count);
  }
  return car_draw_calls();
}

int Instances::car_draw_calls() const {
  int calls = 0;
  for (const Model* model : {&leading_, &following_, &coupling_}) calls += model->count > 0 ? 1 : 0;
  return calls;
}

std::int64_t Instances::car_triangles() const {
  std::int64_t indices = 0;
  for (const Model* model : {&leading_, &following_, &coupling_})
    indices += std::int64_t(model->index_count) * model->count;
  return indices / 3;
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

}  // namespace coaster::gfx
