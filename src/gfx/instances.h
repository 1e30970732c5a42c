// What is new in every frame: the overlay's lines and marks and the carts' poses, one instance each, in buffers rewritten whole.
#pragma once

#include <span>
#include <vector>

#include "gfx/growing_buffer.h"
#include "sim/ride.h"
#include "view/overlay.h"

namespace coaster::gfx {

class Instances {
 public:
  explicit Instances(const Gl& gl);
  void upload(const view::Overlay& overlay, std::span<const sim::Pose> carts);

  // Each binds an array and returns how many instances to draw. Lines and marks: a strip of 4 corners, in the list's order; carts:
  // cart_indices() 32-bit indices of the model.
  GLsizei bind_lines() const { return bind(line_array_, lines_); }
  GLsizei bind_marks() const { return bind(mark_array_, marks_); }
  GLsizei bind_carts() const { return bind(cart_array_, carts_); }
  GLsizei cart_indices() const { return cart_indices_; }

 private:
  GLsizei bind(const Object& array, GLsizei count) const {
    gl_->BindVertexArray(array.id());
    return count;
  }
  void link_lines();
  void link_marks();
  void link_carts();

  const Gl* gl_;
  GrowingBuffer line_buffer_, mark_buffer_, pose_buffer_, model_vertices_, model_indices_;
  Object line_array_, mark_array_, cart_array_;
  GLsizei lines_ = 0, marks_ = 0, carts_ = 0, cart_indices_ = 0;
  std::vector<float> staged_;  // kept for its capacity
};

}  // namespace coaster::gfx
