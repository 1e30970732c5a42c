// The modes of the program: check a file, run a script, ride without a window, or open one.
#pragma once

#include "app/options.h"

namespace coaster::app {

// Runs to the end and returns the exit code (base/status.h: Code). Data goes to stdout, messages to stderr.
int run_program(const Options& options);

}  // namespace coaster::app
