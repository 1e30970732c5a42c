// Ranges of growing buffers.
#include "gfx/growing_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace coaster::gfx {
namespace ranges_test {

TEST(ranges, what_was_given_back_is_taken_first_fit) {
  RangeAllocator ranges;
  const Range a = ranges.take(7), b = ranges.take(5), c = ranges.take(11), d = ranges.take(3);
  EXPECT_EQ(d.first, 23u);
  ranges.give_back(b);
  ranges.give_back(a);
  EXPECT_EQ(ranges.take(12).first, 0u) << "neighbouring gaps are one";
  ranges.give_back(c);
  EXPECT_EQ(ranges.take(4).first, 12u);
  EXPECT_EQ(ranges.take(9).first, 26u) << "7 are left of c, so the end it is";
}

TEST(ranges, the_end_shrinks_over_gaps) {
  RangeAllocator ranges;
  const Range a = ranges.take(7), b = ranges.take(5), c = ranges.take(11);
  ranges.give_back(b);
  EXPECT_EQ(ranges.used(), 23u);
  ranges.give_back(c);
  EXPECT_EQ(ranges.used(), 7u);
  ranges.give_back(a);
  EXPECT_EQ(ranges.used(), 0u);
  ranges.give_back({});
  EXPECT_EQ(ranges.used(), 0u);
}

// Compares with a plain array of each element's owner.
TEST(ranges, no_two_owners_share_an_element) {
  RangeAllocator ranges;
  std::mt19937 bits(977);
  std::vector<int> owner(1u << 16, -1);
  std::vector<Range> live;
  for (int step = 0; step < 20'000; ++step) {
    if (live.size() < 40 && (live.empty() || bits() % 2)) {
      const auto size = static_cast<std::uint32_t>(1 + bits() % 97);
      const Range range = ranges.take(size);
      ASSERT_EQ(range.size, size);
      for (std::uint32_t i = 0; i < size; ++i) {
        ASSERT_EQ(owner.at(range.first + i), -1) << "at step " << step;
        owner[range.first + i] = step;
      }
      live.push_back(range);
    } else {
      const std::size_t which = bits() % live.size();
      const Range range = live[which];
      for (std::uint32_t i = 0; i < range.size; ++i) owner[range.first + i] = -1;
      ranges.give_back(range);
      live.erase(live.begin() + static_cast<std::ptrdiff_t>(which));
    }
    std::uint32_t end = 0;
    for (const Range& range : live) end = std::max(end, range.first + range.size);
    ASSERT_EQ(ranges.used(), end);
  }
}

}  // namespace ranges_test
}  // namespace coaster::gfx
