// Places in a growing buffer: ranges are taken first-fit from what was given back, else from the end. Knows nothing of
// GL.
#pragma once

#include <cstdint>
#include <map>

namespace coaster::gfx {

struct Range {
  std::uint32_t first = 0, size = 0;
};

class Ranges {
 public:
  // A range of exactly `size` (> 0) elements. Linear in the number of gaps.
  Range take(std::uint32_t size);
  // Merges with gaps at both sides; a gap at the end shortens used().
  void give_back(Range range);
  // One past the last element of any range in use.
  std::uint32_t used() const { return used_; }

 private:
  std::map<std::uint32_t, std::uint32_t> gaps_;  // first -> size, never touching each other nor the end
  std::uint32_t used_ = 0;
};

}  // namespace coaster::gfx
