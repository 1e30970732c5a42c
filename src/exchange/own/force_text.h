// The keys of a force section in a track file and on the clipboard.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exchange/own/json_fields.h"
#include "world/force.h"

namespace coaster::exchange {

// Keys of one channel on the clipboard: `{"force-keys": "time", "keys": [[0, 1], [20, 3.5, 0.1, 5, 8]]}`, those of
// curvature with `"of": "curvature"`.
struct CopiedKeys {
  world::ForceOver over{};
  std::vector<world::ForceKey> keys;  // ascending, at least one
  world::ForceOf of{};
};
std::string print_keys(const CopiedKeys& copied);
// Returns the keys, or the error in the text.
base::Result<CopiedKeys> parse_keys(std::string_view text);

// Returns `, "vertical": [[0, 1], [20, 3.5, 0.1, 5, 8]], "roll": [...]`: the position, the value and, if not 0, the
// slope and the lengths of the handles of each key. Channels without keys are left out.
std::string force_keys(const world::ForceProgram& force);

// Reads the keys of all channels. Returns false after a failure, also for a program beyond its limits.
bool read_force_keys(Fields& fields, world::ForceProgram& force);

}  // namespace coaster::exchange
