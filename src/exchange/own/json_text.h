// Prints JSON: the only place where a tree is printed, for every file that the program writes.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace coaster::exchange {

using Json = nlohmann::ordered_json;  // members keep their order

// Returns the text of a file: each member on its own line, `indent` blanks per level, a line feed at the end. Here and
// below, bytes that are not UTF-8 become U+FFFD.
std::string json_file(const Json& tree, int indent = 2);

// Returns a value on one line, without blanks.
std::string json_line(const Json& value);

// Returns a text in quotation marks, escaped for JSON.
std::string json_string(std::string_view text);

}  // namespace coaster::exchange
