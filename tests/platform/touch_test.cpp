#include "platform/touch.h"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

namespace coaster::platform {
namespace touch_test {

// "move 3,4", "left down", "wheel 2", of one frame, separated by "; ".
std::string told(const Events& events) {
  constexpr const char* kButtons[] = {"left", "right", "middle"};
  std::string text;
  for (const Event& event : events) {
    if (!text.empty()) text += "; ";
    if (const auto* move = std::get_if<MouseMove>(&event)) text += fmt::format("move {},{}", move->x, move->y);
    if (const auto* wheel = std::get_if<Wheel>(&event)) text += fmt::format("wheel {:.2f}", wheel->dy);
    if (const auto* button = std::get_if<MouseButton>(&event))
      text += fmt::format("{} {}", kButtons[static_cast<std::size_t>(button->button)], button->down ? "down" : "up");
  }
  return text;
}

// A screen: each call is a frame with these fingers.
struct Screen {
  TouchTranslator touch;
  double now = 0;
  bool taken = true;  // by the last frame
  std::string frame(std::vector<Finger> fingers, double dt = 0.02) {
    Events events;
    now += dt;
    taken = touch.follow(fingers, now, 1, events);
    return told(events);
  }
};

TEST(touch, a_tap_presses_and_releases_in_two_frames) {
  Screen screen;
  EXPECT_EQ(screen.frame({{1, 30, 40}}), "");
  EXPECT_EQ(screen.frame({{1, 33, 42}}), "") << "a finger is never quite still";
  EXPECT_EQ(screen.frame({}), "move 30,40; left down");
  EXPECT_FALSE(screen.taken);
  EXPECT_EQ(screen.frame({}), "left up");
  EXPECT_TRUE(screen.taken);
  screen.frame({});
  EXPECT_EQ(screen.frame({}), "move -1,-1") << "so that no tip stays";
  EXPECT_EQ(screen.frame({}), "");
}

TEST(touch, a_drag_begins_where_the_finger_came_down) {
  Screen screen;
  screen.frame({{1, 100, 100}});
  EXPECT_EQ(screen.frame({{1, 120, 100}}), "move 100,100; left down");
  EXPECT_EQ(screen.frame({{1, 120, 100}}), "move 120,100");
  EXPECT_EQ(screen.frame({{1, 140, 110}}), "move 140,110");
  EXPECT_EQ(screen.frame({}), "left up");
}

TEST(touch, a_long_press_is_the_right_button) {
  Screen screen;
  screen.frame({{1, 10, 10}});
  EXPECT_EQ(screen.frame({{1, 10, 10}}, 0.3), "");
  EXPECT_EQ(screen.frame({{1, 10, 10}}, 0.3), "move 10,10; right down");
  EXPECT_EQ(screen.frame({{1, 10, 10}}), "right up");
  EXPECT_EQ(screen.frame({{1, 90, 10}}), "") << "nothing more until it is up";
  EXPECT_EQ(screen.frame({}), "");
  screen.frame({{2, 5, 5}});
  EXPECT_EQ(screen.frame({}), "move 5,5; left down") << "and then it begins anew";
}

TEST(touch, two_fingers_pan_and_zoom) {
  Screen screen;
  screen.frame({{1, 100, 100}});
  EXPECT_EQ(screen.frame({{1, 100, 100}, {2, 200, 100}}), "move 150,100; middle down");
  EXPECT_EQ(screen.frame({{1, 110, 120}, {2, 210, 120}}), "move 160,120");
  const float wide = 100 * std::pow(TouchTranslator::kPerNotch, 2.0f);
  EXPECT_EQ(screen.frame({{1, 160 - wide / 2, 120}, {2, 160 + wide / 2, 120}}), "move 160,120; wheel 2.00");
  EXPECT_EQ(screen.frame({{1, 110, 120}}), "middle up");
  EXPECT_EQ(screen.frame({{1, 10, 20}}), "") << "the one that stays does not drag";
  EXPECT_EQ(screen.frame({}), "");
}

TEST(touch, a_second_finger_ends_a_drag_before_it_pans) {
  Screen screen;
  screen.frame({{1, 100, 100}});
  screen.frame({{1, 130, 100}});
  EXPECT_EQ(screen.frame({{1, 130, 100}, {2, 230, 100}}), "left up");
  EXPECT_FALSE(screen.taken);
  EXPECT_EQ(screen.frame({{1, 130, 100}, {2, 230, 100}}), "move 180,100; middle down");
  EXPECT_EQ(screen.frame({}), "middle up");
}

}  // namespace touch_test
}  // namespace coaster::platform
