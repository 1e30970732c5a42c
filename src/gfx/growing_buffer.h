// A vertex or index buffer on the GPU that grows and keeps its contents.
#pragma once

#include "gfx/objects.h"

namespace coaster::gfx {

class GrowingBuffer {
 public:
  explicit GrowingBuffer(const Gl& gl) : gl_(&gl), object_(make_buffer(gl)) {}
  // Reserves at least `bytes`. Returns true if the GL name changed, so that vertex arrays must be set up again: the old
  // bytes were copied on the GPU into a buffer of at least twice the size.
  bool reserve(std::size_t bytes);
  // Writes within the reserved size.
  void write(std::size_t offset, const void* data, std::size_t bytes);
  GLuint id() const { return object_.id(); }

 private:
  const Gl* gl_;
  Object object_;
  std::size_t capacity_ = 0;
};

}  // namespace coaster::gfx
