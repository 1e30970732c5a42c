// The position of a window, corrected for screens that have been added or removed.
#pragma once

#include <span>

namespace coaster::platform {

// Position and size in the window system's coordinates, without the window frame.
struct Placement {
  int x = 0, y = 0, width = 0, height = 0;
  bool maximised = false;
  friend bool operator==(const Placement&, const Placement&) = default;
};

// The area of a screen that windows may cover.
struct Screen {
  int x = 0, y = 0, width = 0, height = 0;
};

// Returns `wanted` adjusted to the screens: not larger than the screen it is mostly on, and moved there if less than
// 100 px of its top edge, which holds the title, is on a screen. If it is on no screen: centred on the first. Without
// screens: unchanged.
Placement fitted(const Placement& wanted, std::span<const Screen> screens);

}  // namespace coaster::platform
