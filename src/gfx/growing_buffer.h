// Buffers on the GPU that grow, and the ranges that are allocated in them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <type_traits>
#include <vector>

#include "gfx/gl_objects.h"

namespace coaster::gfx {

struct Range {
  std::uint32_t first = 0, size = 0;
  std::uint32_t end() const { return first + size; }
};

// Adds the next range of a buffer to the runs of those that are `shown`; `open`: the range before it is. What lies
// between two shown neighbours becomes part of their run.
inline void add_to_runs(std::vector<Range>& runs, Range range, bool shown, bool& open) {
  if (shown && !open) runs.push_back(range);
  if (shown) runs.back().size = range.end() - runs.back().first;
  open = shown;
}

// Ranges allocated first-fit from freed ranges, else at the end. Independent of GL.
class RangeAllocator {
 public:
  // Allocates exactly `size` (> 0) elements. Linear in the number of gaps.
  Range take(std::uint32_t size);
  // Frees a range and merges it with adjacent gaps; a gap at the end reduces used().
  void give_back(Range range);
  // One past the last element of any range in use.
  std::uint32_t used() const { return used_; }

 private:
  std::map<std::uint32_t, std::uint32_t> gaps_;  // first -> size; gaps never touch each other or the end
  std::uint32_t used_ = 0;
};

// A vertex or index buffer that keeps its contents. Buffers of whole numbers are index buffers.
// Binds only the targets of copies, so no vertex array is affected; creating and growing index buffers leaves no vertex
// array bound.
template <class T>
class GrowingBuffer {
 public:
  explicit GrowingBuffer(const Gl& gl) : gl_(&gl), object_(made()) {}

  // Reserves at least `count` items. Returns true if the GL name changed, so that vertex arrays must be set up again:
  // the old items were copied on the GPU into a buffer of at least twice the size.
  bool reserve(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes <= capacity_) return false;
    constexpr std::size_t kSmallest = 64 * 1024;
    const std::size_t capacity = std::max({bytes, 2 * capacity_, kSmallest});
    GlObject grown = made();
    gl_->BindBuffer(GL_COPY_WRITE_BUFFER, grown.id());
    gl_->BufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(capacity), nullptr, GL_DYNAMIC_DRAW);
    if (capacity_ > 0) {
      gl_->BindBuffer(GL_COPY_READ_BUFFER, object_.id());
      gl_->CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(capacity_));
      gl_->Finish();  // NVIDIA's driver (580) lets the copy overwrite what is written after it
    }
    object_ = std::move(grown);
    capacity_ = capacity;
    return true;
  }
  // Writes within the reserved size, from item `first` on.
  void write(std::size_t first, std::span<const T> items) {
    if (items.empty()) return;  // a length of 0 means the rest of the memory in WebGL
    COASTER_CHECK(first * sizeof(T) + items.size_bytes() <= capacity_, "writes stay within the reserved size");
    gl_->BindBuffer(GL_COPY_WRITE_BUFFER, object_.id());
    gl_->BufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(first * sizeof(T)), GLsizeiptr(items.size_bytes()), items.data());
  }
  // Writes from the start; returns what reserve() does.
  bool fill(std::span<const T> items) {
    const bool moved = reserve(items.size());
    write(0, items);
    return moved;
  }
  GLuint id() const { return object_.id(); }

 private:
  // WebGL accepts as index buffers only buffers that were bound as such first.
  GlObject made() const {
    GlObject buffer = make_buffer(*gl_);
    if (std::is_integral_v<T>) {
      gl_->BindVertexArray(0);
      gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.id());
      gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    }
    return buffer;
  }
  const Gl* gl_;
  GlObject object_;
  std::size_t capacity_ = 0;  // bytes
};

}  // namespace coaster::gfx
