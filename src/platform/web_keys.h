// Keys of a browser's events.
#pragma once

#include <emscripten/html5.h>

#include "platform/events.h"

namespace coaster::platform {

// Returns the key by its place on the keyboard, a letter by what it types; Key::unknown for others.
Key key_of(const EmscriptenKeyboardEvent& event);

}  // namespace coaster::platform
