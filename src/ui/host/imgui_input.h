// Feeds a frame's events to Dear ImGui. ImGui sees one change of a button per frame, at the place where it happened:
// further ones wait for the next frames. Double clicks count by the time and the place of the presses, so they do not
// depend on the frame rate. The time of an event is that of its poll.
#pragma once

#include <imgui.h>

#include <array>
#include <cfloat>
#include <deque>
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
  void take_button(const platform::MouseButton& event);
  void show_mouse(ImVec2 wheel);

  // A change of a button that ImGui has not seen, and the last press of a button.
  struct Change {
    std::size_t button;
    bool down, twice;
    ImVec2 at;
    platform::Modifiers modifiers;
  };
  struct Press {
    double time = -1e9;  // s
    ImVec2 at;
    bool twice = false;  // the second one of a double click
  };

  double time_ = 0;  // s, the sum of the ticks
  std::deque<Change> waiting_;
  std::array<Press, 3> presses_;
  ImVec2 mouse_{-FLT_MAX, -FLT_MAX};  // ImGui's "nowhere"
  Buttons down_{};
  Keys held_{};
  platform::Modifiers modifiers_;
  std::string late_text_;
};

}  // namespace coaster::ui
