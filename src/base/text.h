// Scanning and printing of text for scripts, commands and files: tokens with positions, exact numbers, suggestions, and
// UTF-8 (RFC 3629) from outside.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace coaster::base {

// One word of a line. `column` counts bytes from 1; `quoted` words had "..." around them (escapes \" \\ \n are
// resolved).
struct Token {
  std::string text;
  int column = 1;
  bool quoted = false;
  friend bool operator==(const Token&, const Token&) = default;
};

// The error in a line, and its column.
struct TextError {
  int column = 1;
  std::string message;
  bool out_of_range = false;  // the line has the right form, but a number in it is not accepted
  bool suggests = false;      // the message names the word that was probably meant
};

// Splits a line at blanks; `#` outside quotes starts a comment. On an unclosed quote, a control character
// outside quotes or a NUL in them returns false and fills `error`.
bool tokenise(std::string_view line, std::vector<Token>& tokens, TextError& error);

// Returns the text in quotes with escapes, so that tokenise reads it back unless it has a NUL.
std::string quoted(std::string_view text);

// Returns quoted text for messages, truncated to 200 bytes, followed by "...".
std::string quoted_start(std::string_view text);

// The same of a text that is not a number, for messages; says so if the reason may be a decimal comma.
std::string quoted_number(std::string_view text);

// Parses the whole text as a finite number (rejects "1e39" as float, nan and inf, blanks and a leading '+').
std::optional<double> parse_double(std::string_view text);
std::optional<float> parse_float(std::string_view text);
std::optional<std::int64_t> parse_int(std::string_view text);

// True if the whole text is a number of any size; "inf" and "nan" are numbers, too.
bool is_number(std::string_view text);

// Returns the shortest text that parses back to the same number.
std::string to_text(float value);
std::string to_text(double value);

// Returns the candidate nearest to `word` by edit distance, if it is close enough to be a typo; ties go to the first.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

// Returns "; did you mean ..." for the end of an error, or "" if nothing is close.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

// Returns an error as a sentence: "there is no knot @k7" becomes "There is no knot @k7."
std::string sentence(std::string error);

// Returns a message in which each word of more than 200 bytes is cut to them, followed by "...".
std::string cut_words(std::string_view message);

// Returns "FILE:LINE:COLUMN: error: MESSAGE".
std::string at_place(std::string_view file, int line, int column, std::string_view message);

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
