#include "base/numerics.h"

#include <random>

#include <gtest/gtest.h>

namespace coaster::base {
namespace numerics_test {

constexpr std::size_t kSize = 5;

// A x = b with integers, so that b is exact.
TEST(numerics, systems_are_solved_for_all_or_the_first_unknowns) {
  std::mt19937 bits(7);
  const auto whole = [&] { return static_cast<double>(static_cast<int>(bits() % 19) - 9); };
  for (int i = 0; i < 200; ++i) {
    std::array<std::array<double, kSize>, kSize> a{};
    std::array<double, kSize> x{}, b{};
    const std::size_t count = 1 + bits() % kSize;
    for (auto& row : a)
      for (double& value : row) value = whole();
    for (std::size_t k = 0; k < count; ++k) a[k][k] += k % 2 ? 40 : -40;  // regular
    std::swap(a[0], a[count - 1]);                                        // pivots are not on the diagonal
    for (double& value : x) value = whole();
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t c = 0; c < count; ++c) b[r] += a[r][c] * x[c];
    ASSERT_TRUE(solve_linear(a, b, count));
    for (std::size_t k = 0; k < count; ++k) EXPECT_NEAR(b[k], x[k], 1e-11);
  }
  std::array<std::array<double, 2>, 2> singular{{{1, 2}, {2, 4}}};
  std::array<double, 2> right{1, 2};
  EXPECT_FALSE(solve_linear(singular, right));
}

TEST(numerics, positive_systems_are_solved_from_their_lower_triangle) {
  // [4 2 0; 2 5 3; 0 3 6] x = [8 25 27] has the solution [0.5, 3, 3].
  const std::vector<double> x = solve_positive({4, -99, -99, 2, 5, -99, 0, 3, 6}, {8, 25, 27});
  ASSERT_EQ(x.size(), 3u);
  EXPECT_NEAR(x[0], 0.5, 1e-14);
  EXPECT_NEAR(x[1], 3, 1e-14);
  EXPECT_NEAR(x[2], 3, 1e-14);
}

TEST(numerics, bisection_ends_at_the_root_from_either_side) {
  const auto below = [](double t) { return t * t < 2; };
  EXPECT_DOUBLE_EQ(bisect({0, 2}, 60, below).middle(), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(bisect({2, 0}, 60, [](double t) { return t * t > 2; }).middle(), std::sqrt(2.0));
  const Interval few = bisect({0, 2}, 3, below);
  EXPECT_EQ(few.low, 1.25);
  EXPECT_EQ(few.high, 1.5);
  int calls = 0;
  bisect({0, 1}, 1000, [&](double) { return ++calls, false; });
  EXPECT_LE(calls, 1080);
  calls = 0;
  bisect({1, 2}, 1000, [&](double) { return ++calls, true; });
  EXPECT_LE(calls, 54) << "it ends at neighbouring numbers";
}

}  // namespace numerics_test
}  // namespace coaster::base
