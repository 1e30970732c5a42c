// Values of command fields as text: printing, reading and description of each type. Private to the codec.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/command.h"
#include "edit/commands/commands_park.h"
#include "exchange/own/import_options.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "world/document.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/paint.h"

namespace coaster::edit {

using Names = std::vector<std::string>;
std::string joined(const Names& names);  // "a|b|c"

// For each type of field: printing (exactly what read_value() reads), reading, and the words for help. Reading fails
// through `words`.
std::string print_value(const Target& value);  // "@k3", "none"
std::string print_value(const HandleTarget& value);
std::string print_value(const Knots& value);  // "@k1,@k2", "all", "selected"
std::string print_value(const Sections& value);
std::string print_value(const Phrase& value);
std::string print_value(const CameraChange& value);
std::string print_value(const exchange::ImportOptions& value);  // "" for the default
std::string print_value(glm::vec3 value);
std::string print_value(glm::vec2 value);
std::string print_value(WaterLevel value);  // "none" below all land
std::string print_value(bool value);
std::string print_value(world::Colour value);  // "\"#d9452f\"", because # begins a comment
std::string print_value(const std::string& value);
std::string print_value(const world::Element& value);  // "loop left height 16 ..."
inline std::string print_value(std::floating_point auto value) { return base::to_text(value); }
inline std::string print_value(std::integral auto value) { return std::to_string(value); }

inline std::string print_value(const Flag&) { return {}; }  // its keyword says it all

// The same in words for sentences: "k4", "28 knots", "the outgoing handle of k3", a section's title in the document.
std::string words_of(const Target& value, const world::Document& document);
std::string words_of(const HandleTarget& value);
std::string words_of(const Knots& value, const world::Document& document);
std::string words_of(const Sections& value, const world::Document& document);
std::string words_of(const KnotsOrSections& value, const world::Document& document);
inline std::string words_of(const Phrase& value) { return value.text; }
inline std::string words_of(const CameraChange& value) { return print_value(value); }
inline std::string words_of(const exchange::ImportOptions& value) { return print_value(value); }
std::string words_of(glm::vec3 value);
inline std::string words_of(glm::vec2 value) { return fmt::format("({:.6g}, {:.6g})", value.x, value.y); }
std::string words_of(WaterLevel value);
std::string words_of(const world::Element& value);
inline std::string words_of(world::Colour value) { return world::to_text(value); }
inline std::string words_of(bool value) { return print_value(value); }
inline std::string words_of(const std::string& value) { return print_value(value); }
inline std::string words_of(const Flag&) { return {}; }
std::string words_of(std::floating_point auto value) { return fmt::format("{:.6g}", value); }
inline std::string words_of(std::integral auto value) { return std::to_string(value); }

bool read_value(base::WordReader& words, Target& value);
bool read_value(base::WordReader& words, HandleTarget& value);
bool read_value(base::WordReader& words, Knots& value);
bool read_value(base::WordReader& words, Sections& value);
bool read_value(base::WordReader& words, KnotsOrSections& value);
bool read_value(base::WordReader& words, Phrase& value);
bool read_value(base::WordReader& words, CameraChange& value);             // reads to the end of the line
bool read_value(base::WordReader& words, exchange::ImportOptions& value);  // reads to the end of the line
bool read_value(base::WordReader& words, glm::vec3& value);
bool read_value(base::WordReader& words, glm::vec2& value);  // x and z
bool read_value(base::WordReader& words, WaterLevel& value);
bool read_value(base::WordReader& words, float& value);
bool read_value(base::WordReader& words, double& value);
bool read_value(base::WordReader& words, int& value);
bool read_value(base::WordReader& words, std::int64_t& value);
bool read_value(base::WordReader& words, bool& value);
bool read_value(base::WordReader& words, world::Colour& value);
bool read_value(base::WordReader& words, std::string& value);
bool read_value(base::WordReader& words,
                world::Element& value);  // reads to the end of the line; missing values get their defaults
inline bool read_value(base::WordReader&, Flag& value) { return value.set = true; }  // its keyword was read already

inline std::string usage_of(const HandleTarget&) { return "@knot.in|@knot.out"; }
inline std::string usage_of(const Knots&) { return "@knot,...|@knot..@knot|all|selected"; }
inline std::string usage_of(const Sections&) { return "@section,...|@section..@section|all|selected"; }
inline std::string usage_of(const KnotsOrSections&) { return "@knot,...|@knot..@knot|@section,...|all|selected"; }
inline std::string usage_of(const Phrase&) { return "WORDS"; }
inline std::string usage_of(const CameraChange&) { return "[target X Y Z] [yaw A] [pitch B] [distance D]"; }
inline std::string usage_of(const exchange::ImportOptions&) {
  return "[up x|y|z] [scale NUMBER] [smooth NUMBER] [bank level|auto] [origin]";
}
inline std::string usage_of(glm::vec3) { return "X Y Z"; }
inline std::string usage_of(glm::vec2) { return "X Z"; }
inline std::string usage_of(WaterLevel) { return "NUMBER|none"; }
inline std::string usage_of(world::Colour) { return "\"#d9452f\"|own"; }
inline std::string usage_of(bool) { return "on|off"; }
inline std::string usage_of(const Flag&) { return {}; }
inline std::string usage_of(const std::string&) { return "\"TEXT\""; }
inline std::string usage_of(std::floating_point auto) { return "NUMBER"; }
inline std::string usage_of(std::integral auto) { return "N"; }
std::string usage_of(const world::Element& value);

// Values of an enumeration are printed and read by name.
template <base::Named E>
std::string print_value(E value) {
  return std::string(base::name_of(value));
}
template <base::Named E>
std::string words_of(E value) {
  std::string words = print_value(value);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}
template <base::Named E>
bool read_value(base::WordReader& words, E& value) {
  const Names names = base::names_of<E>();
  const auto row = words.one_of(joined(names), names);
  if (row) value = static_cast<E>(*row);
  return row.has_value();
}
template <base::Named E>
std::string usage_of(E) {
  return joined(base::names_of<E>());
}

}  // namespace coaster::edit
