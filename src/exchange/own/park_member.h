// The park as a member of a track file: land, seed and sliders as numbers, tiles as a packed text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/own/json.h"
#include "world/components.h"
#include "world/park.h"

namespace coaster::exchange {

// Returns `{"land": "hills-1", "seed": 7, ...}`. Usual values are left out, but for land and seed. The park has a land.
std::string park_member(const world::Park& park);

// Reads the optional member "park". One with a land that this program does not know is left for the unknown members of
// the file, with a warning; the park stays plain.
bool read_park(JsonFieldReader& fields, world::Park& park, std::vector<std::string>& warnings);

// Returns the tiles as letters, digits, "-" and "_"; "" for none. docs/track-format.md has the bytes.
std::string pack_tiles(const world::GroundTiles& tiles);
// Returns the tiles of such a text. Code::bad_file with one line for a text that is damaged or unpacks to more than all
// tiles take, a tile outside the square, out of order or without content, and heights beyond the limit.
base::Result<world::GroundTiles> unpack_tiles(std::string_view text);

// Takes a member out of those that a document has kept, if it is among them.
void drop_member(world::UnknownMembers& kept, std::string_view member);

}  // namespace coaster::exchange
