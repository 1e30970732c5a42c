// Keeps the order of what a player does faster than frames: the rest of a frame's events waits for the next one where
// it needs to see what came before.
#pragma once

#include "platform/events.h"

namespace coaster::ui {

class EventOrder {
 public:
  // Returns the events for this frame, with all of its ticks. A key or text waits until a click before it has been
  // seen: `clicks_wait` says that a former frame's is not. It also waits while a text field is about to take the
  // keyboard (`field_opens`), for at most three frames. Outside a text field one key press is seen a frame, because it
  // may open a field or a tool for the next one; in a text field the same holds for Enter, Tab and Escape, and
  // everything waits after a key with Ctrl, because Dear ImGui reads Ctrl at the end of the frame. A held key that
  // repeats does not wait.
  platform::Events take(const platform::Events& events, bool text_has_keyboard, bool clicks_wait, bool field_opens);
  bool waits() const { return !waiting_.empty(); }

 private:
  int opening_ = 0;  // frames for which a text field has been about to take the keyboard
  platform::Events waiting_;
};

}  // namespace coaster::ui
