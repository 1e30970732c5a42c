// The keys of a force section in a track file. Private to this room.
#pragma once

#include <string>

#include "exchange/own/json_fields.h"
#include "world/force.h"

namespace coaster::exchange {

// Returns `, "vertical": [[0, 1], [20, 3.5, 0.1, 5, 8]], "roll": [...]`: the place, the value and, where they are not
// 0, the slope and the lengths of the handles of each key. Channels without keys are left out.
std::string force_keys(const world::ForceProgram& force);

// Reads them. Returns false after a failure, also for a program beyond its limits.
bool read_force_keys(Fields& fields, world::ForceProgram& force);

}  // namespace coaster::exchange
