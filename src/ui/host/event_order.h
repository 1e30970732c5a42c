// Keeps the order of what a player does faster than frames: the rest of a frame's events waits for the next one where
// it needs to see what came before.
#pragma once

#include "platform/events.h"

namespace coaster::ui {

class EventOrder {
 public:
  // Returns the events for this frame, with all of its ticks. A key or text waits until a click before it has been
  // seen. `keys_wait`: a former frame's click has not, or a text field is about to take the keyboard. Outside a text
  // field one key press is seen a frame, because it may open a field or a tool for the next one; in a text field the
  // same holds for Enter, Tab and Escape. A held key that repeats does not wait.
  platform::Events take(const platform::Events& events, bool text_has_keyboard, bool keys_wait);
  bool waits() const { return !waiting_.empty(); }

 private:
  platform::Events waiting_;
};

}  // namespace coaster::ui
