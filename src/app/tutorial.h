// The tutorial in a window: a script of lessons that the player does.
#pragma once

#include "app/program.h"

namespace coaster::app {

// Runs tutorials/first_coaster.coaster until its end, until the player leaves it, or until the program quits. A notice
// reports errors.
void run_tutorial(Program& program);

}  // namespace coaster::app
