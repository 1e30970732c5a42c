// Parses JSON text into a tree with checks that the parser leaves out by default: duplicate members, deep nesting,
// numbers out of range. Private to this room.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "base/status.h"
#include "exchange/own/json_text.h"

namespace coaster::exchange {

inline constexpr std::size_t kMaxNesting = 32;
// A tree of this many values takes at most 0.6 GB while it grows. A file of 64 MiB of knots has half as many.
inline constexpr std::size_t kMaxValues = 8'000'000;
inline constexpr std::size_t kMaxMembers = 200'000;  // of one object

// Receives each object in an array of the root as soon as it is complete: element `index` of the root's member `list`.
// Returns true if it has read the object: the tree then holds null instead of it, so the tree of a large file stays
// small. If the text turns out not to be plain JSON (json_scan.h), the objects are offered again from the first one on.
using TakeElement =
    std::function<bool(const Json& root, std::string_view list, std::size_t index, const Json& element)>;

// Returns the tree of a whole text. Code::bad_file with "NAME:LINE:COLUMN: error: ..." if the text is not JSON (columns
// count bytes from 1; for a word, its last byte), "NAME: error: PLACE: ..." for duplicate members, nesting and more
// than `most_values` or kMaxMembers. Skips a leading byte-order mark.
base::Result<Json> read_json(std::string_view text, std::string_view name, const TakeElement& take = {},
                             std::size_t most_values = kMaxValues);

// Describes a value for messages: null, true, 1.5, "text", an array of 2, an object.
std::string describe(const Json& value);

}  // namespace coaster::exchange
