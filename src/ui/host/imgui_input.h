// Feeds a frame's events to Dear ImGui. If a press and its release are in one frame, ImGui sees the release a frame
// later.
#pragma once

#include <imgui.h>

#include <array>
#include <cfloat>
#include <string>

#include "platform/events.h"

namespace coaster::ui {

class ImGuiInput {
 public:
  // Before NewFrame. Sets the display's size, the time step (the sum of the ticks), mouse, keys and text of the current
  // context. Tab goes to ImGui only while `text_has_keyboard`: elsewhere it is the program's.
  void feed(const platform::Events& events, int width, int height, bool text_has_keyboard);

 private:
  using Buttons = std::array<bool, 3>;
  using Keys = std::array<bool, 22>;  // by the rows of kKeys
  void take_key(const platform::KeyPress& event, bool text_has_keyboard, Keys& shown);
  void take_text(const std::string& utf8, bool ctrl);

  ImVec2 mouse_{-FLT_MAX, -FLT_MAX};  // ImGui's "nowhere"
  Buttons down_{};
  Keys held_{};
  platform::Modifiers modifiers_;
  std::string late_text_;
};

}  // namespace coaster::ui
