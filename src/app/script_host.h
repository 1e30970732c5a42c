// The host of scripts: the functions that they call in the running program.
#pragma once

#include "app/program.h"
#include "script/host.h"

namespace coaster::app {

// Returns functions over `program`, which must outlive them.
script::Host make_script_host(Program& program);

}  // namespace coaster::app
