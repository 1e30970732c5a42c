// Detects that a window's display is gone. Private to the window surface.
#pragma once

#include <functional>

namespace coaster::platform {

// Calls `lost` when Xlib loses its connection. It must end the program, or Xlib will.
void watch_display(std::function<void()> lost);

// Calls `lost` if the connection to a Wayland compositor is broken. Call it after each poll.
void check_display();

}  // namespace coaster::platform
