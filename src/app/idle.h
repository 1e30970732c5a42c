// Idle windows: a window whose picture would not change waits for events instead of drawing.
#pragma once

#include "platform/events.h"

namespace coaster::app {

struct Program;

inline constexpr double kIdleAfter = 1;        // s without an event or a movement; tooltips need less
inline constexpr double kIdleWait = 1 / 30.0;  // s, longest wait of an idle window for events; gamepads are polled

// Returns whether the next frame would equal the last one, unless an event arrives. Always false without a window, and
// with a number of frames or a log of hashes.
bool is_idle(const Program& program);

// Returns whether the events contain anything but elapsed time.
bool has_input(const platform::Events& events);

// Decides, after a frame with these events, from when the window is idle, and when it must draw without an event.
void plan_idle(Program& program, const platform::Events& events, bool commanded);

}  // namespace coaster::app
