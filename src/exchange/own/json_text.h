// Prints JSON: the only place that prints a tree, for every file that the program writes.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace coaster::exchange {

using Json = nlohmann::ordered_json;  // members keep their order

// Returns the text of a file: each member on its own line, `indent` blanks per level, a line feed at the end. Here and
// below, bytes that are not UTF-8 become U+FFFD.
inline std::string json_file(const Json& tree, int indent = 2) {
  return tree.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Returns a value on one line, without blanks.
inline std::string json_line(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

// Returns a text in quotation marks, escaped for JSON.
inline std::string json_string(std::string_view text) { return json_line(Json(std::string(text))); }

}  // namespace coaster::exchange
