// One frame, for windows, scripts and recordings alike.
#pragma once

#include <vector>

#include "app/program.h"

namespace coaster::app {

// Events in, picture out. `events` holds what happened, its Ticks being the time that passed; `ticks` is by how much
// the ride goes on. A frame without area (a minimised window) changes state and draws nothing.
void run_frame(Program& program, const platform::Events& events, int ticks);

// The pixels of the last frame. Without a window nobody looks at most frames, so they are drawn only now; everything
// else of a frame has happened in it.
void draw_pixels(Program& program);

// One frame of a window: what its player does, in real time.
void play_frame(Program& program);

// Where each car of each train is.
std::vector<sim::Pose> cart_poses(const edit::Session& session);

// Whole ticks of 1/120 s in the time that passed by `events`; what is left over waits in the program. A pause over 0.25
// s counts as that.
int take_ticks(Program& program, const platform::Events& events);

// Whether the last frame shows the present ticks and commands.
bool is_drawn(const Program& program);

// The scene as it is, without panels, marks of knots and what is selected, into the renderer's picture; no frame, and
// no numbers of one.
void draw_scene_alone(Program& program, const view::View& view, platform::Size size);

}  // namespace coaster::app
