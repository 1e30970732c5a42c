// The members of a section in a track file, except those of a way home and of forces. Private to this room.
#pragma once

#include <cstddef>
#include <string>

#include "exchange/own/json_fields.h"
#include "world/components.h"

namespace coaster::exchange {

// Returns `"segments": 3, "kind": "loop", "side": "left", "height": 16, ...`.
std::string section_members(const world::Section& section, std::size_t segments);

// Reads the section. Missing parameters have their default values. Returns false after a failure, also with more
// segments than are `left`.
bool read_section_members(Fields& fields, std::size_t left, world::Section& section, std::size_t& segments);

}  // namespace coaster::exchange
