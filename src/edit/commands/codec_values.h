// Values of command fields as text: printing, reading and description of each type. Private to the codec.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "edit/commands/command.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"

namespace coaster::edit {

// Reads the words of a line; keeps the first failure with its column.
class WordReader {
 public:
  WordReader(std::span<const base::Token> words, base::TextError& error) : words_(words), error_(error) {}

  // Returns the next word, or null after the last.
  const base::Token* peek() const { return next_ < words_.size() ? &words_[next_] : nullptr; }
  // Takes the next word; at the end fails with "expected WHAT".
  const base::Token* take(std::string_view what);
  // Fails at the last word taken: "expected WHAT, found ...".
  bool reject(std::string_view what, std::string_view hint = {});
  bool fail(int column, std::string message);
  // Returns the column after the last word.
  int end_column() const;

 private:
  std::span<const base::Token> words_;
  base::TextError& error_;
  std::size_t next_ = 0;
};

using Names = std::vector<std::string>;
std::string joined(const Names& names);  // "a|b|c"
// Reads a word and sets the row that it names.
bool read_name(WordReader& words, const Names& names, int& row);

// For each type of field: printing (exactly what read_value() reads), reading, and the words for help. Reading fails
// through `words`.
std::string print_value(const Target& value);  // "@k3", "none"
std::string print_value(const HandleTarget& value);
std::string print_value(const Knots& value);  // "@k1,@k2", "all", "selected"
std::string print_value(glm::vec3 value);
std::string print_value(float value);
std::string print_value(double value);
std::string print_value(int value);
std::string print_value(std::int64_t value);
std::string print_value(bool value);
std::string print_value(const std::string& value);
std::string print_value(const world::Element& value);  // "loop left height 16 ..."

bool read_value(WordReader& words, Target& value);
bool read_value(WordReader& words, HandleTarget& value);
bool read_value(WordReader& words, Knots& value);
bool read_value(WordReader& words, glm::vec3& value);
bool read_value(WordReader& words, float& value);
bool read_value(WordReader& words, double& value);
bool read_value(WordReader& words, int& value);
bool read_value(WordReader& words, std::int64_t& value);
bool read_value(WordReader& words, bool& value);
bool read_value(WordReader& words, std::string& value);
bool read_value(WordReader& words,
                world::Element& value);  // to the end of the line; values that are not named get their defaults

std::string usage_of(const HandleTarget& value);
std::string usage_of(const Knots& value);
std::string usage_of(glm::vec3 value);
std::string usage_of(float value);
std::string usage_of(double value);
std::string usage_of(int value);
std::string usage_of(std::int64_t value);
std::string usage_of(bool value);
std::string usage_of(const std::string& value);
std::string usage_of(const world::Element& value);

// Values of an enumeration are written by their names.
template <base::Named E>
std::string print_value(E value) {
  return std::string(base::name_of(value));
}
template <base::Named E>
bool read_value(WordReader& words, E& value) {
  int row = 0;
  if (!read_name(words, base::names_of<E>(), row)) return false;
  value = static_cast<E>(row);
  return true;
}
template <base::Named E>
std::string usage_of(E) {
  return joined(base::names_of<E>());
}

}  // namespace coaster::edit
