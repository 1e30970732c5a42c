// JSON as text: the one place where a tree is printed, for every file that the program writes.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace coaster::exchange {

using Json = nlohmann::ordered_json;  // members keep their order

// The text of a file: members on lines of their own, `indent` blanks a level, a line feed at the end. Here and below,
// bytes that are no UTF-8 become U+FFFD.
std::string json_file(const Json& tree, int indent = 2);

// A value on one line, without blanks.
std::string json_line(const Json& value);

// A text between quotation marks, escaped as JSON wants it.
std::string json_string(std::string_view text);

}  // namespace coaster::exchange
