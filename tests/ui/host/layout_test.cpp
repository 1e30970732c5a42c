#include "ui/host/layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coaster::ui {
namespace layout_test {

bool apart(const view::Viewport& a, const view::Viewport& b) {
  constexpr float kRounding = 1e-3f;  // px
  return a.x + a.width <= b.x + kRounding || b.x + b.width <= a.x + kRounding || a.y + a.height <= b.y + kRounding ||
         b.y + b.height <= a.y + kRounding;
}

TEST(layout, regions_tile_the_window_and_the_viewport_keeps_two_fifths) {
  for (const auto& [width, height] :
       {std::pair{1280, 720}, {1920, 1080}, {640, 360}, {801, 601}, {3840, 2160}, {333, 222}}) {
    for (const float scale : {0.8f, 1.0f, 1.7f, 3.0f}) {
      for (const bool open : {false, true}) {
        const Layout l = make_layout(width, height, scale, 23 * scale, true, {open});
        const view::Viewport all[] = {l.menu, l.left, l.right, l.strip, l.status, l.scene};
        float area = 0;
        for (const view::Viewport& one : all) area += one.width * one.height;
        EXPECT_NEAR(area, static_cast<float>(width) * static_cast<float>(height), 1)
            << width << "x" << height << " at " << scale;
        for (std::size_t i = 0; i < 6; ++i)
          for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(apart(all[i], all[k])) << i << " and " << k << " at " << width;
        EXPECT_GE(l.scene.width, 0.4f * static_cast<float>(width));
        EXPECT_GE(l.scene.height, 0.5f * l.left.height - 1) << width << "x" << height << " at " << scale;
      }
    }
  }
}

TEST(layout, the_strip_folds_to_a_bar_and_opens_by_a_quarter_of_the_window) {
  const float bar = 23;
  EXPECT_EQ(make_layout(1280, 720, 1, bar, true, {false}).strip.height, bar);
  EXPECT_EQ(make_layout(1280, 720, 1, bar, true, {true}).strip.height, 190);
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, true, {true}).strip.height, 280);
  const Layout small = make_layout(640, 360, 0.8f, 19, true, {true});
  EXPECT_GT(small.strip.height, 100);
  EXPECT_LE(small.strip.height, small.scene.height + 1);
  EXPECT_EQ(make_layout(640, 180, 1, bar, true, {true}).strip.height, bar);  // nothing could be read in 67 px
}

TEST(layout, the_strip_has_its_share_of_the_height_between_the_bars) {
  const float bar = 23, middle = 1080 - 2 * bar;
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, true, {true, 0.7f}).strip.height, std::floor(0.7f * middle));
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, true, {true, 0.01f}).strip.height, 4 * bar);  // what can be read
  EXPECT_EQ(make_layout(1920, 1080, 1, bar, true, {false, 0.7f}).strip.height, bar);
}

TEST(layout, hidden_panels_leave_the_whole_window) {
  const Layout l = make_layout(641, 359, 1.3f, 30, false, {true});
  EXPECT_EQ(l.scene.width, 641);
  EXPECT_EQ(l.scene.height, 359);
  EXPECT_EQ(l.left.width * l.left.height + l.right.width * l.right.height + l.menu.height + l.status.height, 0);
}

TEST(layout, small_windows_shrink_text_by_a_fifth_at_most) {
  EXPECT_FLOAT_EQ(fitted_scale(1280, 720, 1, 1), 1);
  EXPECT_FLOAT_EQ(fitted_scale(640, 360, 1, 1), 0.8f);
  EXPECT_FLOAT_EQ(fitted_scale(64, 36, 1, 1), 0.8f);
  EXPECT_FLOAT_EQ(fitted_scale(2560, 1440, 1.5f, 2), 3);  // a dense screen is no small window
}

}  // namespace layout_test
}  // namespace coaster::ui
