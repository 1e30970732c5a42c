// Fingers on a screen as a mouse with three buttons: one finger is the left button, a long press the right one, two
// fingers pan by the middle button and zoom by the wheel. Without a finger the mouse is outside the window. Panels turn
// pans into scrolling (ui/host/imgui_backend).
#pragma once

#include <span>

#include "platform/events.h"

namespace coaster::platform {

struct Finger {
  long id = 0;
  float x = 0, y = 0;  // window pixels
};

class TouchTranslator {
 public:
  static constexpr double kLongPress = 0.5;  // s without moving, until it is the right button
  static constexpr float kSlop = 8;          // pixels of an ordinary screen, times `scale`: less is no movement
  static constexpr float kPerNotch = 1.12f;  // change of the distance of two fingers for one step of the wheel

  // Appends the events of one frame for the fingers that are down. A press and its release are in different frames, as
  // panels need: false requests the same fingers once more, in the next frame.
  bool follow(std::span<const Finger> fingers, double now, float scale, Events& events);

 private:
  enum class State { none, pending, drag, two, spent };  // spent: nothing until all fingers are up
  // Parts of follow(), by the number of fingers.
  bool follow_none(Events& events);
  bool follow_one(const Finger& finger, double now, float scale, Events& events);
  bool follow_two(const Finger& first, const Finger& second, Events& events);
  void press(Button button, Events& events);
  void release(Events& events);

  State state_ = State::none;
  Finger start_;
  double since_ = 0;    // s, of the pending press
  float distance_ = 0;  // of two fingers, pixels
  bool down_ = false, tapped_ = false;
  bool away_ = false;  // the mouse must leave the position that the finger has left
  Button button_ = Button::left;
};

}  // namespace coaster::platform
