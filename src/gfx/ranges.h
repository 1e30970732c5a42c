// Ranges of a growing buffer, allocated first-fit from freed ranges, else at the end. Independent of GL.
#pragma once

#include <cstdint>
#include <map>

namespace coaster::gfx {

struct Range {
  std::uint32_t first = 0, size = 0;
};

class Ranges {
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

}  // namespace coaster::gfx
