// Keys of a browser's events.
#pragma once

#include <emscripten/html5.h>

#include <string>

#include "platform/events.h"

namespace coaster::platform {

// A page knows the layout only by the keys that are pressed.
class WebKeyboard {
 public:
  // Returns the key of an event. A layout is of another script from the first letter of it on.
  KeyPress read(const EmscriptenKeyboardEvent& event, bool down, Modifiers held);
  // Returns the text that the event types, in which AltGr or Option may be held; "" for none.
  std::string text(const EmscriptenKeyboardEvent& event, Modifiers held) const;
  void release() { alt_graph_ = false; }

 private:
  bool alt_graph_ = false, other_script_ = false;
};

}  // namespace coaster::platform
