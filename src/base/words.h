// Reads the words of one line for a grammar (commands, scripts, conditions); stores the first failure with its column.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "base/text.h"

namespace coaster::base {

class Words {
 public:
  Words(std::span<const Token> words, TextError& error) : words_(words), error_(error) {}

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
