// Growth by copies on the GPU. Only the copy targets are bound, so no vertex array is disturbed.
#include "gfx/growing_buffer.h"

#include <algorithm>

namespace coaster::gfx {
namespace {

constexpr std::size_t kSmallest = 64 * 1024;

}  // namespace

bool GrowingBuffer::reserve(std::size_t bytes) {
  if (bytes <= capacity_) return false;
  const std::size_t capacity = std::max({bytes, 2 * capacity_, kSmallest});
  Object grown = make_buffer(*gl_);
  gl_->BindBuffer(GL_COPY_WRITE_BUFFER, grown.id());
  gl_->BufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(capacity), nullptr, GL_DYNAMIC_DRAW);
  if (capacity_ > 0) {
    gl_->BindBuffer(GL_COPY_READ_BUFFER, object_.id());
    gl_->CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(capacity_));
  }
  object_ = std::move(grown);
  capacity_ = capacity;
  return true;
}

void GrowingBuffer::write(std::size_t offset, const void* data, std::size_t bytes) {
  COASTER_CHECK(offset + bytes <= capacity_, "writes stay within the reserved size");
  gl_->BindBuffer(GL_COPY_WRITE_BUFFER, object_.id());
  gl_->BufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(offset), GLsizeiptr(bytes), data);
}

}  // namespace coaster::gfx
