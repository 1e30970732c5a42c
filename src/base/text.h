// Scanning and printing of text for scripts, commands and files: tokens with positions, the words of a line read one by
// one, exact numbers, suggestions, and UTF-8 (RFC 3629) from outside.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

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

// Reads the words of one line for a grammar (commands, scripts, conditions); stores the first failure with its column.
class WordReader {
 public:
  WordReader(std::span<const Token> words, TextError& error) : words_(words), error_(error) {}

  bool at_end() const { return next_ >= words_.size(); }
  const Token* peek() const { return at_end() ? nullptr : &words_[next_]; }
  std::span<const Token> rest() const { return words_.subspan(next_); }
  // Skips the next word and returns true if it is this one, unquoted.
  bool accept(std::string_view word);
  // Takes the next word; fails at the end of the line with "expected WHAT".
  const Token* take(std::string_view what);
  std::optional<double> number(std::string_view what);
  // Takes a whole number in [low, high].
  std::optional<std::int64_t> whole(std::string_view what, std::int64_t low, std::int64_t high);
  std::optional<glm::vec3> vector(std::string_view what);
  // Takes "on" or "off" (true, yes, 1; false, no, 0).
  std::optional<bool> on_off();
  // Takes one of the names; fails with a suggestion for other words.
  std::optional<std::size_t> one_of(std::string_view what, std::span<const std::string> names);
  // Returns true at the end of the line.
  bool end();
  // Fails at the last word taken: "expected WHAT, found ...".
  bool reject(std::string_view what, std::string_view hint = {});
  // The same; a number is out of range, another word is wrong.
  bool reject_number(std::string_view what);
  bool fail(int column, std::string message) { return fail({column, std::move(message)}); }
  bool fail(TextError error);
  bool failed() const { return failed_; }
  int end_column() const;

 private:
  std::span<const Token> words_;
  TextError& error_;
  std::size_t next_ = 0;
  bool failed_ = false;
};

// Parses "on", "true", "yes" and their opposites; nothing for other words.
std::optional<bool> parse_switch(std::string_view word);
inline constexpr std::int64_t kMaxPixels = 7680 * 4320;  // 1.4 GB of framebuffer with 4 samples
// Parses "WIDTHxHEIGHT": sides of 1 to 16384, at most kMaxPixels together.
bool parse_size(std::string_view text, int& width, int& height);
// What parse_size() accepts, and the error for a text that it does not.
inline constexpr std::string_view kSizeWords = "WIDTHxHEIGHT such as 1280x720, up to 7680x4320";
TextError size_error(int column, std::string_view text);
std::string lower(std::string_view text);

}  // namespace coaster::base
