// UTF-8 text (RFC 3629) from outside.
#pragma once

#include <string>
#include <string_view>

namespace coaster::base {

// Returns the length in bytes of the well-formed character at the start of `text`, 1 to 4; 0 if there is none.
std::size_t utf8_length(std::string_view text);

// True if a text is well-formed and without control characters (U+0000 to U+001F, U+007F).
bool is_printable_utf8(std::string_view text);

// Returns the text with U+FFFD for each byte that is not part of a well-formed character, and '_' for control
// characters.
std::string printable_utf8(std::string_view text);

// Returns the text for terminals and for files that people may show on one, with each control character but tabs and
// line ends (\n, \r\n) as "\u001b", and each byte that is not part of well-formed UTF-8 as "\xff". Control characters
// are U+0000 to U+001F, U+007F to U+009F, and those that change the direction of text or end a line (U+061C, U+200E,
// U+200F, U+2028 to U+202E, U+2066 to U+2069).
std::string visible_text(std::string_view text);

// Returns the longest start of at most `most` bytes that does not end within a character.
std::string_view utf8_start(std::string_view text, std::size_t most);

}  // namespace coaster::base
