#include "ui/host/imgui_input.h"

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
    set_up_context();
    load_fonts(1);
    frame({});
  }
  ~ImGuiInputTest() override { ImGui::DestroyContext(context); }

  // What ImGui sees during a frame with these events.
  void frame(platform::Events events) {
    events.emplace_back(platform::Tick{1.0 / 60});
    input.feed(events, 640, 360, true);
    ImGui::NewFrame();
    const ImGuiIO& io = ImGui::GetIO();
    mouse = io.MousePos;
    wheel = io.MouseWheel;
    ctrl = io.KeyCtrl;
    clicked = io.MouseClicked[0];
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
  int text = 0;
};

TEST_F(ImGuiInputTest, a_chord_arrives_in_the_frame_of_its_key) {
  frame({platform::KeyPress{Key::a, true, false, {.ctrl = true}}});
  EXPECT_TRUE(ctrl && a_pressed);
  frame({platform::KeyPress{Key::a, false, false, {}}});
  EXPECT_FALSE(ctrl || a_pressed);
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

TEST_F(ImGuiInputTest, a_click_within_a_frame_is_released_in_the_next) {
  frame({platform::MouseButton{Button::left, true, {}}, platform::MouseButton{Button::left, false, {}}});
  EXPECT_TRUE(clicked && down);
  frame({});
  EXPECT_FALSE(down);
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
