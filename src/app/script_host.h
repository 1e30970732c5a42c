// The host of scripts: the functions that they call in the running program. The tutorial is also a script.
#pragma once

#include "app/program.h"
#include "script/host.h"

namespace coaster::app {

// Returns functions over `program`, which must outlive them.
script::Host make_script_host(Program& program);

// Starts the tutorial (tutorials/first_coaster.coaster) when it is requested, and runs it up to its next lesson, which
// waits for the player. Call it after each frame of a window. The tutorial runs until its end, until the player leaves
// it, or until end_tutorial(). A notice reports errors.
void teach(Program& program);
// Ends the tutorial and restores the settings that it changed.
void end_tutorial(Program& program);

}  // namespace coaster::app
