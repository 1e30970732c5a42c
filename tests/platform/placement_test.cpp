// Windows on the screens that there are.
#include "platform/surface.h"

#include <gtest/gtest.h>

#include <random>

namespace coaster::platform {
namespace placement_test {

constexpr Screen kLeft{0, 24, 1920, 1056}, kRight{1920, 0, 1280, 1024};
constexpr Screen kBoth[] = {kLeft, kRight};

TEST(placement, a_window_that_can_be_reached_stays_where_it_was) {
  for (const WindowPlacement p : {WindowPlacement{100, 100, 1280, 720}, WindowPlacement{2000, 50, 1000, 700, true},
                                  WindowPlacement{-900, 200, 1280, 720}})
    EXPECT_EQ(fitted(p, kBoth), p);
}

TEST(placement, a_window_of_a_screen_that_is_gone_comes_to_the_middle_of_the_first) {
  EXPECT_EQ(fitted({4000, 3000, 1280, 720}, kBoth), (WindowPlacement{320, 192, 1280, 720}));
  EXPECT_EQ(fitted({2400, 100, 800, 600}, std::span(&kLeft, 1)), (WindowPlacement{560, 252, 800, 600}));
}

TEST(placement, a_title_above_the_screen_or_a_sliver_at_its_side_is_brought_back) {
  EXPECT_EQ(fitted({100, -300, 1280, 720}, kBoth), (WindowPlacement{100, 24, 1280, 720}));
  EXPECT_EQ(fitted({-1250, 100, 1280, 720}, kBoth), (WindowPlacement{0, 100, 1280, 720}));
}

TEST(placement, nothing_is_larger_than_its_screen) {
  EXPECT_EQ(fitted({0, 24, 5000, 4000}, std::span(&kRight, 1)).width, 1280);
  EXPECT_EQ(fitted({1, 2, 5000, 4000}, {}), (WindowPlacement{1, 2, 5000, 4000})) << "without screens nothing is known";
}

TEST(placement, whatever_was_kept_a_hundred_pixels_of_the_title_are_on_a_screen) {
  std::mt19937 bits(7);
  const auto any = [&](int low, int high) {
    return low + static_cast<int>(bits() % static_cast<unsigned>(high - low));
  };
  for (int i = 0; i < 2000; ++i) {
    const WindowPlacement p = fitted({any(-5000, 5000), any(-5000, 5000), any(200, 4000), any(100, 3000)}, kBoth);
    int reach = 0;
    for (const Screen& s : kBoth)
      if (p.y >= s.y && p.y + 32 <= s.y + s.height)
        reach = std::max(reach, std::min(p.x + p.width, s.x + s.width) - std::max(p.x, s.x));
    EXPECT_GE(reach, 100) << p.x << " " << p.y << " " << p.width << " " << p.height;
    EXPECT_EQ(fitted(p, kBoth), p) << "fitting again moves nothing";
  }
}

}  // namespace placement_test
}  // namespace coaster::platform
