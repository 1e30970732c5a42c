// Text scanning and printing shared by scripts, commands and files: tokens with places, exact numbers, suggestions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace coaster::base {

// One word of a line. `column` counts bytes from 1; `quoted` words had "..." around them (escapes \" \\ \n undone).
struct Token {
  std::string text;
  int column = 1;
  bool quoted = false;
  friend bool operator==(const Token&, const Token&) = default;
};

// A line that could not be cut into tokens, and where.
struct TextError {
  int column = 1;
  std::string message;
};

// Splits a line at blanks; `#` outside quotes starts a comment. On an unclosed quote or a control character
// returns false and fills `error`.
bool tokenise(std::string_view line, std::vector<Token>& tokens, TextError& error);

// Puts quotes and escapes around a text so that tokenise gives it back.
std::string quoted(std::string_view text);
// The same for messages, where 40 bytes are enough to know a text by: what follows them is "...".
std::string quoted_start(std::string_view text);

// The whole text as a finite number ("1e39" as float is refused, so are nan and inf, blanks and a leading '+').
std::optional<double> parse_double(std::string_view text);
std::optional<float> parse_float(std::string_view text);
std::optional<std::int64_t> parse_int(std::string_view text);

// The shortest text that parses back to the same number.
std::string to_text(float value);
std::string to_text(double value);

// The candidate nearest to `word` by edit distance, if it is near enough to be a likely slip; ties go to the first.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

// "did you mean ..." with a leading blank, or "" when nothing is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

// "FILE:LINE:COLUMN: error: MESSAGE".
std::string at_place(std::string_view file, int line, int column, std::string_view message);

}  // namespace coaster::base
