// Notices that a window's display is gone. Private to the window surface.
#pragma once

#include <functional>

namespace coaster::platform {

// From now on `lost` is called when Xlib loses its connection; it must end the program, for else Xlib does.
void watch_display(std::function<void()> lost);

// Calls `lost` if the connection to a Wayland compositor is broken. After each poll.
void check_display();

}  // namespace coaster::platform
