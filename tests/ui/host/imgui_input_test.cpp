// Input of Dear ImGui: src/ui/host/imgui_backend.
#include "ui/host/imgui_backend.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace imgui_input_test {

using platform::Button;
using platform::Key;

struct ImGuiInputTest : testing::Test {
  ImGuiInputTest() {
    ImGui::SetCurrentContext(context);
    ImGui::GetIO().IniFilename = nullptr;  // it would write one
    set_up_context();
    ImGui::GetIO().MouseDragThreshold = 3;  // as the host at density 1
    load_fonts(1);
    frame({});
  }
  ~ImGuiInputTest() override { ImGui::DestroyContext(context); }

  // What ImGui sees during a frame with these events.
  void frame(platform::Events events, double seconds = 1.0 / 60) {
    events.emplace_back(platform::Tick{seconds});
    input.feed(events, 640, 360, true);
    ImGui::NewFrame();
    const ImGuiIO& io = ImGui::GetIO();
    mouse = io.MousePos;
    wheel = io.MouseWheel;
    ctrl = io.KeyCtrl;
    clicked = io.MouseClicked[0];
    clicks += clicked ? 1 : 0;
    double_clicks += ImGui::IsMouseDoubleClicked(0) ? 1 : 0;
    down = io.MouseDown[0];
    a_pressed = ImGui::IsKeyPressed(ImGuiKey_A);
    text = io.InputQueueCharacters.Size;
    ImGui::EndFrame();
  }

  ImGuiContext* context = ImGui::CreateContext();
  ImGuiInput input;
  ImVec2 mouse;
  float wheel = 0;
  bool ctrl = false, clicked = false, down = false, a_pressed = false;
  int text = 0, clicks = 0, double_clicks = 0;
  const platform::MouseButton kDown{Button::left, true, {}}, kUp{Button::left, false, {}};
};

TEST_F(ImGuiInputTest, a_chord_arrives_in_the_frame_of_its_key) {
  frame({platform::KeyPress{Key::a, true, false, {.ctrl = true}}});
  EXPECT_TRUE(ctrl && a_pressed);
  frame({platform::KeyPress{Key::a, false, false, {}}});
  EXPECT_FALSE(ctrl || a_pressed);
}

TEST_F(ImGuiInputTest, every_press_of_a_key_counts_however_many_come_at_once) {
  const platform::KeyPress press{Key::a, true, false, {}}, release{Key::a, false, false, {}},
      repeat{Key::a, true, true, {}};
  int presses = 0;
  const auto play = [&](const platform::Events& events) {
    frame(events);
    presses += a_pressed ? 1 : 0;
  };
  play({press, release, press, release, press, release});
  for (int i = 0; input.keys_wait() && i < 10; ++i) play({});
  EXPECT_EQ(presses, 3);
  play({}), play({press, release}), play({press, release});
  for (int i = 0; i < 4; ++i) play({});
  EXPECT_EQ(presses, 5) << "in frames one after the other";
  play({press}), play({repeat}), play({repeat}), play({release}), play({});
  EXPECT_EQ(presses, 6) << "a key that is held is pressed once";
  EXPECT_FALSE(input.keys_wait());
}

TEST_F(ImGuiInputTest, a_frame_sees_its_move_wheel_and_click_together) {
  frame({platform::MouseMove{30, 40}, platform::Wheel{0, -1}, platform::Wheel{0, -0.5f},
         platform::MouseButton{Button::left, true, {.ctrl = true}}});
  EXPECT_EQ(mouse.x, 30);
  EXPECT_EQ(mouse.y, 40);
  EXPECT_EQ(wheel, -1.5f);
  EXPECT_TRUE(clicked && ctrl);
  frame({});
  EXPECT_EQ(wheel, 0);
  EXPECT_TRUE(down && !clicked);
}

// A panel as large as the display, with one button at the top, and fingers that drag over it.
struct FingerTest : ImGuiInputTest {
  // Returns how far the panel is scrolled after fingers have moved up by 30 px, in three frames.
  float scrolled(Button button, float y, bool finger) {
    float now = 0;
    const auto panel = [&](platform::Events events) {
      events.emplace_back(platform::Tick{1.0 / 60});
      input.feed(events, 640, 360, true);
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({640, 360});
      ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoTitleBar);
      ImGui::Button("button", {600, 60});
      ImGui::Dummy({600, 2000});
      now = ImGui::GetScrollY();
      ImGui::End();
      ImGui::EndFrame();
    };
    const auto move = [&](float to) { panel({platform::MouseMove{300, to, finger}}); };
    panel({});
    move(y);
    move(y);
    panel({platform::MouseMove{300, y, finger}, platform::MouseButton{button, true, {}}});
    for (const float up : {10.0f, 20.0f, 30.0f}) move(y - up);
    panel({platform::MouseButton{button, false, {}}});
    panel({});
    return now;
  }
};

TEST_F(FingerTest, two_fingers_scroll_a_panel_as_far_as_they_move) {
  EXPECT_NEAR(scrolled(Button::middle, 50, true), 30, 1);
}
TEST_F(FingerTest, one_finger_scrolls_where_it_holds_no_widget) {
  EXPECT_NEAR(scrolled(Button::left, 200, true), 30, 1);
}
TEST_F(FingerTest, one_finger_on_a_widget_scrolls_nothing) { EXPECT_EQ(scrolled(Button::left, 50, true), 0); }
TEST_F(FingerTest, a_mouse_scrolls_nothing) {
  EXPECT_EQ(scrolled(Button::middle, 50, false), 0);
  EXPECT_EQ(scrolled(Button::left, 200, false), 0);
}

TEST_F(ImGuiInputTest, a_click_within_a_frame_is_released_in_the_next) {
  frame({platform::MouseButton{Button::left, true, {}}, platform::MouseButton{Button::left, false, {}}});
  EXPECT_TRUE(clicked && down);
  frame({});
  EXPECT_FALSE(down);
}

// Two polls are all that is known of the times of two presses.
TEST_F(ImGuiInputTest, two_clicks_within_0_3_s_are_a_double_click_at_any_frame_rate) {
  for (const double frame_time : {1.0 / 240, 1.0 / 60, 1.0 / 20, 1.0 / 5, 1.0 / 2, 1.0})
    for (const double between : {0.05, 0.2, 0.29, 0.36, 0.6, 1.4, 2.4}) {
      frame({}, 5);
      clicks = double_clicks = 0;
      // Each event goes to the first poll after it.
      const double start = 0.9 * frame_time,  // so that most of the clicks come in two polls
          events[] = {start, start + 0.4 * between, start + between, start + 1.4 * between};
      std::size_t next = 0;
      double polled = 0, last_poll = 0;
      for (; next < 4 || polled < last_poll + 4 * frame_time; polled += frame_time) {
        platform::Events batch;
        for (; next < 4 && events[next] <= polled; ++next) {
          batch.emplace_back(next % 2 == 0 ? kDown : kUp);
          last_poll = polled;
        }
        frame(batch, frame_time);
      }
      EXPECT_EQ(clicks, 2) << frame_time << " " << between;
      if (between < 0.3) {
        EXPECT_EQ(double_clicks, 1) << frame_time << " " << between;
      } else if (between > 0.3 + 2 * frame_time) {
        EXPECT_EQ(double_clicks, 0) << frame_time << " " << between;
      }
    }
}

TEST_F(ImGuiInputTest, the_wait_of_an_idle_window_for_a_click_counts) {
  for (const double wait : {1.5, 5.0, 60.0}) {
    double_clicks = 0;
    frame({}, 5);
    frame({kDown, kUp}, 1.0 / 60);
    frame({}, 1.0 / 60);
    frame({kDown, kUp}, wait);
    frame({}, 1.0 / 60);
    EXPECT_EQ(double_clicks, 0) << wait;
  }
}

TEST_F(ImGuiInputTest, two_clicks_in_one_frame_are_a_double_click_and_a_third_one_is_not) {
  frame({kDown, kUp, kDown, kUp, kDown, kUp}, 0.2);
  for (int i = 0; i < 6; ++i) frame({}, 0.2);
  EXPECT_EQ(clicks, 3);
  EXPECT_EQ(double_clicks, 1);
  EXPECT_FALSE(down);
}

TEST_F(ImGuiInputTest, clicks_at_two_places_are_no_double_click_and_each_counts_where_it_was) {
  frame({platform::MouseMove{30, 40}, kDown, kUp, platform::MouseMove{37, 40}, kDown, platform::MouseMove{90, 90}});
  EXPECT_TRUE(clicked && mouse.x == 30 && mouse.y == 40);
  frame({});
  EXPECT_FALSE(down);
  frame({});
  EXPECT_TRUE(clicked && mouse.x == 37 && mouse.y == 40);
  frame({});
  EXPECT_TRUE(down && mouse.x == 90 && mouse.y == 90);
  EXPECT_EQ(double_clicks, 0);
}

TEST_F(ImGuiInputTest, text_beside_ctrl_arrives_a_frame_later) {
  frame({platform::KeyPress{Key::a, true, false, {.ctrl = true}}, platform::TextInput{"12"}});
  EXPECT_EQ(text, 0);
  frame({});
  EXPECT_EQ(text, 2);
  EXPECT_FALSE(ctrl) << "with Ctrl down ImGui drops text";
}

TEST_F(ImGuiInputTest, a_window_that_loses_the_focus_releases_everything) {
  frame({platform::MouseButton{Button::left, true, {.ctrl = true}}});
  EXPECT_TRUE(down && ctrl);
  frame({platform::Focus{false}});
  EXPECT_FALSE(down || ctrl);
}

}  // namespace imgui_input_test
}  // namespace coaster::ui
