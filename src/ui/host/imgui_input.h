// Feeds a frame's events to Dear ImGui. If a press and its release are in one frame, ImGui sees the release a frame
// later.
#pragma once

#include <array>
#include <string>

#include "platform/events.h"

namespace coaster::ui {

class ImGuiInput {
 public:
  // Before NewFrame. Sets the display's size, the time step (the sum of the ticks), mouse, keys and text of the current
  // context. Tab goes to ImGui only while `text_has_keyboard`: elsewhere it is the program's.
  void feed(const platform::Events& events, int width, int height, bool text_has_keyboard);

 private:
  void feed_key(const platform::KeyPress& event, bool text_has_keyboard);
  std::array<bool, 3> down_{};   // mouse buttons
  std::array<bool, 64> held_{};  // keys by ImGuiKey, for ImGui before 1.87, which has no queue
  platform::Modifiers modifiers_;
  std::string late_text_;  // typed in a frame that also had Ctrl down, when ImGui would drop it
};

}  // namespace coaster::ui
