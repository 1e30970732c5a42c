#include "base/bits.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace coaster::base {
namespace bits_test {

struct Padded {
  std::uint8_t kind;  // three bytes of padding follow
  float value;
  std::uint8_t last;  // and here
};

// Returns a value in memory that was full of `filling` before.
Padded in_memory_of(unsigned char filling, std::uint8_t kind, float value, std::uint8_t last) {
  Padded made;
  std::memset(static_cast<void*>(&made), filling, sizeof made);
  made.kind = kind, made.value = value, made.last = last;
  return made;
}

bool same(const Padded& a, const Padded& b) {
  std::vector<Padded> left(2), right(2);
  for (int i = 0; i < 2; ++i) copy_bits(i == 1 ? a : b, left[i]), copy_bits(b, right[i]);
  return same_bits(left, right);
}

TEST(bits, what_nobody_wrote_decides_nothing) {
#if defined(__GNUC__) && !defined(__clang__)
  EXPECT_TRUE(same(in_memory_of(0, 1, 2.5f, 3), in_memory_of(0xff, 1, 2.5f, 3)));
#endif
  EXPECT_FALSE(same(in_memory_of(0, 1, 2.5f, 3), in_memory_of(0, 2, 2.5f, 3)));
  EXPECT_FALSE(same(in_memory_of(0, 1, 2.5f, 3), in_memory_of(0, 1, 2.5f, 4)));
}

TEST(bits, each_bit_of_a_value_counts) {
  EXPECT_FALSE(same(in_memory_of(0, 1, 0.0f, 3), in_memory_of(0, 1, -0.0f, 3)));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(same_bits(std::vector<float>{1, kNan}, std::vector<float>{1, kNan}));
  EXPECT_TRUE(same_bits(std::vector<int>{1, 2}, std::vector<int>{1, 2}));
  EXPECT_FALSE(same_bits(std::vector<int>{1, 2}, std::vector<int>{1, 3}));
  EXPECT_FALSE(same_bits(std::vector<int>{1, 2}, std::vector<int>{1}));
  EXPECT_TRUE(same_bits(std::vector<int>{}, std::vector<int>{}));
}

}  // namespace bits_test
}  // namespace coaster::base
