// Walks the words of one line for a grammar (scripts, conditions); the first failure is kept with its place.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
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
  // True, and one word further, when the next word is this one, unquoted.
  bool accept(std::string_view word);
  // The next word; fails at the end of the line with "expected WHAT".
  const Token* take(std::string_view what);
  std::optional<double> number(std::string_view what);
  // A whole number in [low, high].
  std::optional<std::int64_t> whole(std::string_view what, std::int64_t low, std::int64_t high);
  std::optional<glm::vec3> vector(std::string_view what);
  // "on" or "off" (true, yes, 1; false, no, 0).
  std::optional<bool> on_off();
  // One of the names, with a suggestion when it is none of them.
  std::optional<std::size_t> one_of(std::string_view what, std::span<const std::string> names);
  // True when the line ends here.
  bool end();
  bool fail(int column, std::string message);
  bool failed() const { return failed_; }
  int end_column() const;

 private:
  std::span<const Token> words_;
  TextError& error_;
  std::size_t next_ = 0;
  bool failed_ = false;
};

// "on", "true", "yes" and their opposites; nothing for other words.
std::optional<bool> parse_switch(std::string_view word);
// "WIDTHxHEIGHT" in 1..16384.
bool parse_size(std::string_view text, int& width, int& height);
std::string lower(std::string_view text);

}  // namespace coaster::base
