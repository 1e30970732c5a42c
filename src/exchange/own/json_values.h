// JSON for rooms that only print values: it includes no JSON library.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace coaster::exchange {

using JsonValue = std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, std::array<double, 3>>;
using JsonMembers = std::vector<std::pair<std::string, JsonValue>>;

// Returns the text of a file with one object: each member on its own line, in order; of members with the same name only
// the last value is printed. Numbers that are not finite become null, bytes that are not UTF-8 become U+FFFD.
std::string json_members(const JsonMembers& members);

}  // namespace coaster::exchange
