// Data that changes in every frame: the overlay's lines and marks and the cars' poses, one instance each, in buffers
// that are rewritten as a whole.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gfx/growing_buffer.h"
#include "sim/ride/ride.h"
#include "sim/solids/mesh.h"
#include "view/overlay.h"
#include "world/coaster_kind.h"

namespace coaster::gfx {

class CarInstances {
 public:
  explicit CarInstances(const Gl& gl);
  // The number of cars drawn in full, those nearest to the eye; the others are drawn as blocks.
  static constexpr std::size_t kFullCars = 512;
  void upload(const view::Overlay& overlay, std::span<const sim::Pose> carts, glm::vec3 eye, world::CoasterKind kind);

  // Each binds an array and returns the number of instances to draw: a strip of 4 corners each, in the list's order.
  GLsizei bind_lines() const { return bind(line_array_, lines_); }
  GLsizei bind_marks() const { return bind(mark_array_, marks_); }
  // Returns the cars of all trains. draw_cars() draws them and their couplings with the program in use (locations 0
  // position, 1 normal, 2 part, 3 to 6 the columns of the model matrix, 7 zero) and returns the number of draw calls:
  // at most kKinds for any number of cars.
  int cars() const { return int(shown_.size()); }
  int draw_cars() const;
  int car_draw_calls() const;
  std::int64_t car_triangles() const;  // per draw

 private:
  GLsizei bind(const GlObject& array, GLsizei count) const {
    gl_->BindVertexArray(array.id());
    return count;
  }

  // A constant mesh, drawn once per pose.
  struct Model {
    explicit Model(const Gl& gl);
    void fill(const sim::Mesh& mesh);
    void link(const Gl& gl);
    GrowingBuffer<sim::MeshVertex> vertices;
    GrowingBuffer<std::uint32_t> indices;
    GrowingBuffer<float> poses;
    GlObject array;
    GLsizei index_count = 0, count = 0;
  };
  // Cars with riders of the first group whose hands are on the bar, couplings, blocks; then the other riders.
  enum Kind : std::uint8_t { leading, following, coupling, distant, kOthers };
  static constexpr std::size_t kKinds = kOthers + 6;
  static Kind kind_of(const sim::Pose& car);
  void take_kind(world::CoasterKind kind);
  void choose_cars(std::span<const sim::Pose> cars, glm::dvec3 eye);
  void stage_cars(std::span<const sim::Pose> cars, Kind kind);
  void stage_couplings(std::span<const sim::Pose> cars);
  void send_poses(Model& model);

  const Gl* gl_;
  GrowingBuffer<float> line_buffer_, mark_buffer_;
  GlObject line_array_, mark_array_;
  GLsizei lines_ = 0, marks_ = 0;
  std::optional<world::CoasterKind> kind_;  // of the models
  std::array<Model, kKinds> models_;        // by kind, in drawing order
  std::vector<Kind> shown_;                 // by car
  std::vector<double> distances_;           // m^2, kept for its capacity
  std::vector<float> staged_;               // kept for its capacity
};

}  // namespace coaster::gfx
