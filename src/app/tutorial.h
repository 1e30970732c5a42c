// Teaches in the window: a script of lessons that the player does with their own hands.
#pragma once

#include "app/program.h"

namespace coaster::app {

// Runs tutorials/first_coaster.coaster to its end, to where the player leaves it, or to where the program is to end. A
// notice tells what is wrong.
void run_tutorial(Program& program);

}  // namespace coaster::app
