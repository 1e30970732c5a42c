// Where a window was, and where it can be now that screens may have come or gone.
#pragma once

#include <span>

namespace coaster::platform {

// In the window system's coordinates, without its frame.
struct Placement {
  int x = 0, y = 0, width = 0, height = 0;
  bool maximised = false;
  friend bool operator==(const Placement&, const Placement&) = default;
};

// The part of a screen that windows may cover.
struct Screen {
  int x = 0, y = 0, width = 0, height = 0;
};

// `wanted`, made to fit: not larger than the screen it is mostly on, and moved there when its top edge, which holds the
// title, is out of reach: less than 100 px of it on a screen. On none at all: in the middle of the first screen.
// Without screens it stays.
Placement fitted(const Placement& wanted, std::span<const Screen> screens);

}  // namespace coaster::platform
