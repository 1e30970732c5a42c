// Keys of a force section on the clipboard. track_parse.cpp and track_print.cpp hold both functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
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

}  // namespace coaster::exchange
