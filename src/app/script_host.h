// The host of scripts: the functions that they call in the running program. The tutorial is a script, too.
#pragma once

#include "app/program.h"
#include "script/host.h"

namespace coaster::app {

// Returns functions over `program`, which must outlive them.
script::Host make_script_host(Program& program);

// After each frame of a window: starts the tutorial where it is wanted, and lets the one that runs go on up to its next
// lesson, which the player does: tutorials/first_coaster.coaster. It runs until its end, until the player leaves it, or
// until end_tutorial(). A notice reports errors.
void teach(Program& program);
// Gives back the settings that the tutorial has borrowed.
void end_tutorial(Program& program);

}  // namespace coaster::app
