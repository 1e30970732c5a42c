// One frame, for windows, scripts and recordings. A window whose picture would not change waits for events instead of
// drawing.
#pragma once

#include "app/program.h"
#include "platform/events.h"

namespace coaster::app {

// Runs one frame. `events` are its input, with Ticks as elapsed time; the ride advances by `ticks`. A frame of zero
// area (a minimised window) changes state and draws nothing.
void run_frame(Program& program, const platform::Events& events, int ticks);

// Runs one frame of a window with its player's input, in real time.
void play_frame(Program& program);

// Returns the whole ticks of 1/120 s that passed by `events`; the rest is carried over in `time`. A pause over 0.25 s
// counts as 0.25 s.
int take_ticks(FrameClock& time, const platform::Events& events);

// True if the last frame shows the present ticks and commands.
bool is_drawn(const Program& program);

inline constexpr double kIdleWait = 1 / 30.0;  // s, longest wait of an idle window for events; gamepads are polled

}  // namespace coaster::app
