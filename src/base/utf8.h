// Text in UTF-8 (RFC 3629) that came from outside.
#pragma once

#include <string>
#include <string_view>

namespace coaster::base {

// Length in bytes of the well-formed character that `text` starts with, 1 to 4; 0 when it starts with none.
std::size_t utf8_length(std::string_view text);

// Whether a text is well-formed and without control characters (U+0000 to U+001F, U+007F).
bool is_printable_utf8(std::string_view text);

// The text with U+FFFD for each byte that belongs to no well-formed character, and '_' for control characters.
std::string printable_utf8(std::string_view text);

// The longest start of at most `most` bytes that does not end within a character.
std::string_view utf8_start(std::string_view text, std::size_t most);

}  // namespace coaster::base
