// Parses JSON text into a tree with checks that the parser leaves out by default: duplicate members, deep nesting,
// numbers out of range. Private to this room.
#pragma once

#include <string_view>

#include "base/status.h"
#include "exchange/own/json_text.h"

namespace coaster::exchange {

inline constexpr std::size_t kMaxNesting = 32;
// A tree of so many values takes at most 0.6 GB while it grows. A file of 64 MiB of knots has half as many.
inline constexpr std::size_t kMaxValues = 8'000'000;
inline constexpr std::size_t kMaxMembers = 200'000;  // of one object

// Returns the tree of a whole text. Code::bad_file with "NAME:LINE:COLUMN: error: ..." if the text is not JSON (columns
// count bytes from 1; for a word, its last byte), "NAME: error: PLACE: ..." for duplicate members, nesting and more
// than kMaxValues or kMaxMembers. Skips a leading byte-order mark.
base::Result<Json> read_json(std::string_view text, std::string_view name);

// Describes a value for messages: null, true, 1.5, "text", an array of 2, an object.
std::string describe(const Json& value);

}  // namespace coaster::exchange
