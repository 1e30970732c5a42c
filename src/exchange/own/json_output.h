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

struct JsonMember;
using JsonMembers = std::vector<JsonMember>;
using JsonList = std::vector<JsonMembers>;  // of objects
using JsonValue =
    std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, std::array<double, 3>, JsonList>;
struct JsonMember {
  JsonMember(std::string n, JsonValue v) : name(std::move(n)), value(std::move(v)) {}
  std::string name;
  JsonValue value;
};

// Returns the text of a file with one object: each member on its own line, in order; of members with the same name only
// the last value is printed. Numbers that are not finite become null, bytes that are not UTF-8 become U+FFFD.
std::string json_members(const JsonMembers& members);

}  // namespace coaster::exchange
