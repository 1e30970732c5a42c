// The host of scripts: the functions that they call in the running program. The tutorial is a script, too.
#pragma once

#include "app/program.h"
#include "script/host.h"

namespace coaster::app {

// Returns functions over `program`, which must outlive them.
script::Host make_script_host(Program& program);

// Runs tutorials/first_coaster.coaster, lessons that the player of a window does, until its end, until the player
// leaves it, or until the program quits. A notice reports errors.
void run_tutorial(Program& program);

}  // namespace coaster::app
