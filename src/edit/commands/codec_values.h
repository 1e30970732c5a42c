// Values of command fields as text: how each type is printed, read and described. Private to the codec.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "edit/commands/commands.h"

namespace coaster::edit {

// Walks the words of a line; the first failure is kept with its column.
class WordReader {
 public:
  WordReader(std::span<const base::Token> words, base::TextError& error) : words_(words), error_(error) {}

  // The next word, or null after the last.
  const base::Token* peek() const { return next_ < words_.size() ? &words_[next_] : nullptr; }
  // The next word; at the end fails with "expected WHAT".
  const base::Token* take(std::string_view what);
  // Fails at the word taken last: "expected WHAT, found ...".
  bool reject(std::string_view what, std::string_view hint = {});
  bool fail(int column, std::string message);
  // One past the last word.
  int end_column() const;

 private:
  std::span<const base::Token> words_;
  base::TextError& error_;
  std::size_t next_ = 0;
};

// The words of a table, in the order of its rows.
using Names = std::vector<std::string>;
template <class Rows>
Names names_of(const Rows& rows) {
  Names names;
  for (const auto& row : rows) names.emplace_back(row.name);
  return names;
}
std::string joined(const Names& names);  // "a|b|c"
std::string row_name(const Names& names, int row);
// The row that the next word names.
bool read_name(WordReader& words, const Names& names, int& row);
template <class Enum>
bool read_enum(WordReader& words, const Names& names, Enum& value) {
  int row = 0;
  if (!read_name(words, names, row)) return false;
  value = static_cast<Enum>(row);
  return true;
}

// Each type of field: text that read_value() gives back exactly, reading, and the words for help. reading fails through
// `words`.
std::string print_value(const Target& value);  // "@k3", "none"
std::string print_value(const HandleTarget& value);
std::string print_value(const Knots& value);  // "@k1,@k2", "all", "selected"
std::string print_value(world::Axis value);
std::string print_value(world::SplineSteps value);
std::string print_value(world::SnapTo value);
std::string print_value(glm::vec3 value);
std::string print_value(float value);
std::string print_value(double value);
std::string print_value(int value);
std::string print_value(std::int64_t value);
std::string print_value(bool value);
std::string print_value(const std::string& value);
std::string print_value(world::JointKind value);
std::string print_value(world::FrameMethod value);
std::string print_value(world::CameraMode value);
std::string print_value(world::EquipmentKind value);
std::string print_value(curve::EvaluatorId value);
std::string print_value(curve::ArcLengthId value);
std::string print_value(IntegratorId value);
std::string print_value(world::Layer value);
std::string print_value(world::Colouring value);
std::string print_value(world::LabPage value);
std::string print_value(const world::Element& value);  // "loop left height 16 ..."
std::string print_value(world::Theme value);
std::string print_value(world::Style value);

bool read_value(WordReader& words, Target& value);
bool read_value(WordReader& words, HandleTarget& value);
bool read_value(WordReader& words, Knots& value);
bool read_value(WordReader& words, world::Axis& value);
bool read_value(WordReader& words, world::SplineSteps& value);
bool read_value(WordReader& words, world::SnapTo& value);
bool read_value(WordReader& words, glm::vec3& value);
bool read_value(WordReader& words, float& value);
bool read_value(WordReader& words, double& value);
bool read_value(WordReader& words, int& value);
bool read_value(WordReader& words, std::int64_t& value);
bool read_value(WordReader& words, bool& value);
bool read_value(WordReader& words, std::string& value);
bool read_value(WordReader& words, world::JointKind& value);
bool read_value(WordReader& words, world::FrameMethod& value);
bool read_value(WordReader& words, world::CameraMode& value);
bool read_value(WordReader& words, world::EquipmentKind& value);
bool read_value(WordReader& words, curve::EvaluatorId& value);
bool read_value(WordReader& words, curve::ArcLengthId& value);
bool read_value(WordReader& words, IntegratorId& value);
bool read_value(WordReader& words, world::Layer& value);
bool read_value(WordReader& words, world::Colouring& value);
bool read_value(WordReader& words, world::LabPage& value);
bool read_value(WordReader& words,
                world::Element& value);  // to the end of the line; what is not named has its usual value
bool read_value(WordReader& words, world::Theme& value);
bool read_value(WordReader& words, world::Style& value);

std::string usage_of(const HandleTarget& value);
std::string usage_of(const Knots& value);
std::string usage_of(world::Axis value);
std::string usage_of(world::SplineSteps value);
std::string usage_of(world::SnapTo value);
std::string usage_of(glm::vec3 value);
std::string usage_of(float value);
std::string usage_of(double value);
std::string usage_of(int value);
std::string usage_of(std::int64_t value);
std::string usage_of(bool value);
std::string usage_of(const std::string& value);
std::string usage_of(world::JointKind value);
std::string usage_of(world::FrameMethod value);
std::string usage_of(world::CameraMode value);
std::string usage_of(world::EquipmentKind value);
std::string usage_of(curve::EvaluatorId value);
std::string usage_of(curve::ArcLengthId value);
std::string usage_of(IntegratorId value);
std::string usage_of(world::Layer value);
std::string usage_of(world::Colouring value);
std::string usage_of(world::LabPage value);
std::string usage_of(const world::Element& value);
std::string usage_of(world::Theme value);
std::string usage_of(world::Style value);

}  // namespace coaster::edit
