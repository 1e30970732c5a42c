// Packs overlay and poses into instance attributes.
#include "gfx/per_frame_instances.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numeric>

#include "gfx/mesh_pool.h"
#include "sim/solids/train_mesh.h"

namespace coaster::gfx {
namespace {

constexpr std::size_t kPoseFloats = 16;

// Sets attributes of so many floats each, from location `first` on, one value per instance, from the bound buffer.
void instance_attributes(const Gl& gl, GLuint first, std::initializer_list<int> sizes) {
  const std::size_t stride = std::size_t(std::accumulate(sizes.begin(), sizes.end(), 0)) * sizeof(float);
  std::size_t offset = 0;
  for (const int size : sizes) {
    float_attribute(gl, first++, size, stride, offset, 1);
    offset += std::size_t(size) * sizeof(float);
  }
}

void push(std::vector<float>& out, glm::vec3 v) { out.insert(out.end(), {v.x, v.y, v.z}); }

// Appends 0xRRGGBBAA as four floats in 0..1.
void push_colour(std::vector<float>& out, std::uint32_t rgba) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(float((rgba >> shift) & 0xffu) / 255.0f);
}

// Appends the columns of the model matrix.
void push_matrix(std::vector<float>& out, glm::vec3 x, glm::vec3 y, glm::vec3 z, glm::vec3 origin) {
  const float columns[] = {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, origin.x, origin.y, origin.z, 1};
  out.insert(out.end(), std::begin(columns), std::end(columns));
}

double stretch(const sim::Pose& pose) {
  return pose.length / static_cast<double>(world::kCarLength);
}  // of the model along the rails

// Returns a car's hitch: in front (+1) or behind (-1).
glm::dvec3 hitch(const sim::Pose& pose, double way, double height) {
  return pose.position + way * sim::kHitchBack * stretch(pose) * pose.frame.forward + height * pose.frame.up;
}

}  // namespace

CarInstances::Model::Model(const Gl& gl) : vertices(gl), indices(gl), poses(gl), array(make_vertex_array(gl)) {}

void CarInstances::Model::fill(const sim::Mesh& mesh) {
  index_count = GLsizei(mesh.indices.size());
  vertices.fill(mesh.vertices);
  indices.fill(mesh.indices);
}

void CarInstances::Model::link(const Gl& gl) {
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
  mesh_attributes(gl);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, poses.id());
  instance_attributes(gl, 3, {4, 4, 4, 4});
}

CarInstances::CarInstances(const Gl& gl)
    : gl_(&gl),
      line_buffer_(gl),
      mark_buffer_(gl),
      line_array_(make_vertex_array(gl)),
      mark_array_(make_vertex_array(gl)),
      models_{Model(gl), Model(gl), Model(gl), Model(gl), Model(gl),
              Model(gl), Model(gl), Model(gl), Model(gl), Model(gl)} {}

// The others are leading and following cars by group and arms, without those that come first.
CarInstances::Kind CarInstances::kind_of(const sim::Pose& car) {
  const int riders = 2 * (car.group % sim::kRiderGroups) + int{car.arms_up};
  if (riders == 0) return car.leads ? leading : following;
  return static_cast<Kind>(kOthers + 2 * (riders - 1) + int{!car.leads});
}

void CarInstances::take_kind(world::CoasterKind kind) {
  if (kind_ == kind) return;
  kind_ = kind;
  for (const bool leads : {true, false})
    for (std::uint8_t group = 0; group < sim::kRiderGroups; ++group)
      for (const bool arms_up : {false, true})
        models_[kind_of({.leads = leads, .group = group, .arms_up = arms_up})].fill(
            sim::car_mesh(kind, leads, {group, arms_up}));
  models_[coupling].fill(sim::coupling_mesh()), models_[distant].fill(sim::distant_car_mesh(kind));
  for (Model& model : models_) model.link(*gl_);
}

void CarInstances::upload(const view::Overlay& overlay, std::span<const sim::Pose> carts, glm::vec3 eye,
                          world::CoasterKind kind) {
  take_kind(kind);
  const auto send = [&](GrowingBuffer<float>& buffer, const GlObject& array, std::initializer_list<int> sizes) {
    if (buffer.fill(staged_)) {
      gl_->BindVertexArray(array.id());
      gl_->BindBuffer(GL_ARRAY_BUFFER, buffer.id());
      instance_attributes(*gl_, 0, sizes);
    }
    staged_.clear();
  };
  for (const view::Line& line : overlay.lines) {
    push(staged_, line.from);
    push(staged_, line.to);
    staged_.push_back(line.width_px);
    push_colour(staged_, line.rgba);
  }
  send(line_buffer_, line_array_, {3, 3, 1, 4});
  for (const view::Mark& mark : overlay.marks) {
    push(staged_, mark.position);
    staged_.push_back(mark.radius_px);
    staged_.push_back(mark.shape == view::MarkShape::square ? 1.0f : 0.0f);
    push_colour(staged_, mark.rgba);
  }
  send(mark_buffer_, mark_array_, {3, 1, 1, 4});
  lines_ = GLsizei(overlay.lines.size()), marks_ = GLsizei(overlay.marks.size());
  choose_cars(carts, eye);
  for (std::size_t i = 0; i < kKinds; ++i) {
    if (const auto each = static_cast<Kind>(i); each == coupling) stage_couplings(carts);
    else stage_cars(carts, each);
    send_poses(models_[i]);
  }
}

void CarInstances::choose_cars(std::span<const sim::Pose> cars, glm::dvec3 eye) {
  const auto distance = [&](const sim::Pose& car) {
    const glm::dvec3 away = car.position - eye;
    return glm::dot(away, away);
  };
  double far = std::numeric_limits<double>::infinity();
  if (cars.size() > kFullCars) {
    distances_.clear();
    for (const sim::Pose& car : cars) distances_.push_back(distance(car));
    const auto first_far = distances_.begin() + static_cast<std::ptrdiff_t>(kFullCars);
    std::nth_element(distances_.begin(), first_far, distances_.end());
    far = *first_far;
  }
  shown_.clear();
  for (const sim::Pose& car : cars) shown_.push_back(distance(car) >= far ? distant : kind_of(car));
}

void CarInstances::stage_cars(std::span<const sim::Pose> cars, Kind kind) {
  for (std::size_t i = 0; i < cars.size(); ++i) {
    if (shown_[i] != kind) continue;
    const sim::Pose& car = cars[i];
    const glm::vec3 forward = car.frame.forward, up = car.frame.up;
    push_matrix(staged_, static_cast<float>(stretch(car)) * forward, up, glm::cross(forward, up),
                glm::vec3(car.position));
  }
}

// Adds a coupling from each car to the rear of the car before it; cars that touch have none.
void CarInstances::stage_couplings(std::span<const sim::Pose> cars) {
  constexpr double kShortest = 0.02, kLongest = 25;  // m
  for (std::size_t i = 1; i < cars.size(); ++i) {
    if (cars[i].leads || shown_[i] == distant) continue;
    const double height = sim::form_of(*kind_).hitch;
    const glm::dvec3 from = hitch(cars[i], 1, height), way = hitch(cars[i - 1], -1, height) - from;
    const double length = glm::length(way);
    if (!(length > kShortest && length < kLongest)) continue;
    const glm::dvec3 forward = way / length, up = curve::perpendicular(forward, cars[i].frame.up);
    push_matrix(staged_, glm::vec3(way), glm::vec3(up), glm::vec3(glm::cross(forward, up)), glm::vec3(from));
  }
}

void CarInstances::send_poses(Model& model) {
  model.count = GLsizei(staged_.size() / kPoseFloats);
  if (model.poses.fill(staged_)) model.link(*gl_);
  staged_.clear();
}

int CarInstances::draw_cars() const {
  for (const Model& model : models_) {
    if (model.count == 0) continue;
    gl_->BindVertexArray(model.array.id());
    gl_->VertexAttrib4f(kEndAttribute, -1, 0, 0, 1);
    gl_->DrawElementsInstanced(GL_TRIANGLES, model.index_count, GL_UNSIGNED_INT, nullptr, model.count);
  }
  return car_draw_calls();
}

int CarInstances::car_draw_calls() const {
  return int(std::ranges::count_if(models_, [](const Model& model) { return model.count > 0; }));
}

std::int64_t CarInstances::car_triangles() const {
  std::int64_t indices = 0;
  for (const Model& model : models_) indices += std::int64_t(model.index_count) * model.count;
  return indices / 3;
}

}  // namespace coaster::gfx
