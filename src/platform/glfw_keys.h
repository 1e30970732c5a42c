#pragma once

#include "platform/events.h"

struct GLFWwindow;

namespace coaster::platform {

// Returns the key of a press, by GLFW's codes; Key::unknown with AltGr, which makes text.
Key key_of(GLFWwindow* window, int code, int scancode, int mods);

}  // namespace coaster::platform
