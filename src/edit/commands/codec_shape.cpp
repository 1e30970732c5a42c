// Values of the commands that shape several knots, as text.
#include "edit/commands/codec_values.h"

namespace coaster::edit {
namespace {

template <class Table>
Names words_of(const Table& table) {
  return Names(table.begin(), table.end());
}

constexpr std::string_view kKnotsUsage = "@knot,...|all|selected";

}  // namespace

std::string print_value(const Knots& value) {
  if (value.which == Knots::Which::all) return "all";
  if (value.which == Knots::Which::selected) return "selected";
  std::string text;
  for (const world::Name& name : value.names) text += (text.empty() ? "@" : ",@") + world::to_text(name);
  return text.empty() ? "none" : text;
}

bool read_value(WordReader& words, Knots& value) {
  constexpr std::string_view kExpected = "knots such as @k3 or @k1,@k2, or all, or selected";
  const base::Token* const word = words.take(kExpected);
  if (!word) return false;
  value = {};
  if (word->text == "none") return true;
  if (word->text == "all") return value.which = Knots::Which::all, true;
  if (word->text == "selected") return value.which = Knots::Which::selected, true;
  std::string_view rest = word->text;
  for (;;) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view one = rest.substr(0, comma);
    const auto name = one.starts_with('@') ? world::parse_name(one.substr(1)) : std::nullopt;
    if (!name) return words.reject(kExpected);
    value.names.push_back(*name);
    if (comma == rest.size()) return true;
    rest.remove_prefix(comma + 1);
  }
}

std::string usage_of(const Knots&) { return std::string(kKnotsUsage); }

std::string print_value(world::Axis value) { return row_name(words_of(world::kAxisNames), static_cast<int>(value)); }
std::string print_value(world::SplineSteps value) {
  return row_name(words_of(world::kSplineStepNames), static_cast<int>(value));
}
std::string print_value(world::SnapTo value) { return row_name(words_of(world::kSnapNames), static_cast<int>(value)); }

bool read_value(WordReader& words, world::Axis& value) { return read_enum(words, words_of(world::kAxisNames), value); }
bool read_value(WordReader& words, world::SplineSteps& value) {
  return read_enum(words, words_of(world::kSplineStepNames), value);
}
bool read_value(WordReader& words, world::SnapTo& value) {
  return read_enum(words, words_of(world::kSnapNames), value);
}

std::string usage_of(world::Axis) { return joined(words_of(world::kAxisNames)); }
std::string usage_of(world::SplineSteps) { return joined(words_of(world::kSplineStepNames)); }
std::string usage_of(world::SnapTo) { return joined(words_of(world::kSnapNames)); }

}  // namespace coaster::edit
