#include "gfx/growing_buffer.h"

#include <iterator>

#include "base/check.h"

namespace coaster::gfx {

Range RangeAllocator::take(std::uint32_t size) {
  COASTER_CHECK(size > 0, "a range is not empty");
  for (auto gap = gaps_.begin(); gap != gaps_.end(); ++gap) {
    if (gap->second < size) continue;
    const Range range{gap->first, size};
    const std::uint32_t left = gap->second - size;
    gaps_.erase(gap);
    if (left > 0) gaps_.emplace(range.first + size, left);
    return range;
  }
  const Range range{used_, size};
  COASTER_CHECK(used_ + size > used_, "a vertex buffer has fewer than 2^32 elements");
  used_ += size;
  return range;
}

void RangeAllocator::give_back(Range range) {
  if (range.size == 0) return;
  auto next = gaps_.lower_bound(range.first);
  if (next != gaps_.end() && range.end() == next->first) {
    range.size += next->second;
    next = gaps_.erase(next);
  }
  if (next != gaps_.begin()) {
    const auto before = std::prev(next);
    if (before->first + before->second == range.first) {
      range = {before->first, before->second + range.size};
      gaps_.erase(before);
    }
  }
  if (range.end() == used_) used_ = range.first;
  else gaps_.emplace(range.first, range.size);
}

}  // namespace coaster::gfx
