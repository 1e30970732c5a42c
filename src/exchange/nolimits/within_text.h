// Messages about numbers that are out of range.
#pragma once

#include <string>

#include <fmt/format.h>

#include "world/components.h"

namespace coaster::exchange {

// Returns what a file's number has to be, for messages: positions are in metres, and a file in millimetres goes beyond.
inline std::string within_text(double limit) {
  return limit == world::kMaxCoordinate ? fmt::format("a position within {:.0f} m", limit)
                                        : fmt::format("a number within {:.6g}", limit);
}

}  // namespace coaster::exchange
