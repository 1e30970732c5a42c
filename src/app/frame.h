// One frame, for windows, scripts and recordings alike.
#pragma once

#include "app/program.h"

namespace coaster::app {

// Events in, picture out. `events` holds what happened, its Ticks being the time that passed; `ticks` is by how much
// the ride goes on. A frame without area (a minimised window) changes state and draws nothing.
void run_frame(Program& program, const platform::Events& events, int ticks);

// One frame of a window: what its player does, in real time.
void play_frame(Program& program);

// Whole ticks of 1/120 s in the time that passed by `events`; what is left over waits in `time`. A pause over 0.25 s
// counts as that.
int take_ticks(FrameClock& time, const platform::Events& events);

// Whether the last frame shows the present ticks and commands.
bool is_drawn(const Program& program);

}  // namespace coaster::app
