// A window that shows nothing new draws nothing: it waits for events.
#pragma once

#include "platform/events.h"

namespace coaster::app {

struct Program;

inline constexpr double kIdleAfter = 1;        // s without an event or a movement; a tooltip needs less
inline constexpr double kIdleWait = 1 / 30.0;  // s that an idle window waits for events at most; gamepads are polled

// Returns whether the next frame would show what the last one did, unless an event comes. Never without a window, nor
// with a number of frames or a log of hashes.
bool is_idle(const Program& program);

// Returns whether there is anything but the passing of time.
bool has_input(const platform::Events& events);

// After a frame with these events: decides from when the window is idle, and when it has to show something by itself.
void plan_idle(Program& program, const platform::Events& events, bool commanded);

}  // namespace coaster::app
