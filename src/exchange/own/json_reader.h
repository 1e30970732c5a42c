// Reading JSON text into a tree with the checks that a parser's defaults leave out: duplicate members, deep nesting,
// numbers beyond range. Private to this room.
#pragma once

#include <string_view>

#include "base/status.h"
#include "exchange/own/json_text.h"

namespace coaster::exchange {

inline constexpr std::size_t kMaxNesting = 32;

// The tree of a whole text. Code::bad_file with "NAME:LINE:COLUMN: error: ..." where the text is not JSON (columns
// count bytes from 1; for a word that is its last byte), "NAME: error: PLACE: ..." for duplicate members and nesting. A
// leading byte-order mark is skipped.
base::Result<Json> read_json(std::string_view text, std::string_view name);

// What a value is, for messages: null, true, 1.5, "text", an array of 2, an object.
std::string describe(const Json& value);

}  // namespace coaster::exchange
