// Printing and reading the values of command fields.
#include "edit/commands/codec_values.h"

#include <limits>

#include <fmt/format.h>

namespace coaster::edit {
namespace {

template <class T, class Parse>
bool read_number(base::Words& words, std::string_view what, Parse parse, T& value) {
  const base::Token* const word = words.take(what);
  if (!word) return false;
  const auto number = parse(word->text);
  if (!number) return words.reject(what);
  value = static_cast<T>(*number);
  return true;
}

template <class Several>
std::string words_of_several(const Several& value, std::string_view kind) {
  if (value.which == Knots::Which::all) return fmt::format("all {}", kind);
  if (value.which == Knots::Which::selected) return fmt::format("the selected {}", kind);
  if (value.names.size() != 1) return fmt::format("{} {}", value.names.size(), kind);
  return world::to_text(value.names.front());
}

}  // namespace

std::string joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "|") + name;
  return text;
}

std::string print_value(const Target& value) {
  return value.name.number == 0 ? "none" : "@" + world::to_text(value.name);
}
std::string print_value(const HandleTarget& value) {
  return "@" + world::to_text(value.knot) + (value.end == HandleEnd::in ? ".in" : ".out");
}
std::string print_value(glm::vec3 v) {
  return fmt::format("{} {} {}", base::to_text(v.x), base::to_text(v.y), base::to_text(v.z));
}
std::string print_value(bool value) { return value ? "on" : "off"; }
std::string print_value(const std::string& value) { return base::quoted(value); }

std::string words_of(const Target& value) { return value.name.number == 0 ? "nothing" : world::to_text(value.name); }
std::string words_of(const HandleTarget& value) {
  return fmt::format("the {} handle of {}", value.end == HandleEnd::in ? "incoming" : "outgoing",
                     world::to_text(value.knot));
}
std::string words_of(const Knots& value) { return words_of_several(value, "knots"); }
std::string words_of(const Sections& value) { return words_of_several(value, "sections"); }
std::string words_of(glm::vec3 v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }
std::string words_of(const world::Element& value) { return words_of(value.kind); }

namespace {

// Knots or sections.
template <class Several>
std::string print_several(const Several& value) {
  if (value.which == Knots::Which::all) return "all";
  if (value.which == Knots::Which::selected) return "selected";
  std::string text;
  for (const world::Name& name : value.names) text += (text.empty() ? "@" : ",@") + world::to_text(name);
  return text.empty() ? "none" : text;
}

template <class Several>
bool read_several(base::Words& words, std::string_view expected, Several& value) {
  const base::Token* const word = words.take(expected);
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
    if (!name) return words.reject(expected);
    value.names.push_back(*name);
    if (comma == rest.size()) return true;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace

std::string print_value(const Knots& value) { return print_several(value); }
std::string print_value(const Sections& value) { return print_several(value); }
bool read_value(base::Words& words, Knots& value) {
  return read_several(words, "knots such as @k3 or @k1,@k2, or all, or selected", value);
}
bool read_value(base::Words& words, Sections& value) {
  return read_several(words, "sections such as @q3 or @q1,@q2, or all, or selected", value);
}

bool read_value(base::Words& words, Target& value) {
  constexpr std::string_view kExpected = "an entity such as @k3, @s2, @c1 or @q1";
  const base::Token* const word = words.take(kExpected);
  if (!word) return false;
  if (word->text == "none") return value = {}, true;
  const auto name =
      word->text.starts_with('@') ? world::parse_name(std::string_view(word->text).substr(1)) : std::nullopt;
  if (!name) return words.reject(kExpected);
  value.name = *name;
  return true;
}

bool read_value(base::Words& words, HandleTarget& value) {
  constexpr std::string_view kExpected = "a handle such as @k3.in or @k3.out";
  const base::Token* const word = words.take(kExpected);
  if (!word) return false;
  std::string_view text = word->text;
  const bool in = text.ends_with(".in"), out = text.ends_with(".out");
  if (!text.starts_with('@') || (!in && !out)) return words.reject(kExpected);
  text.remove_prefix(1), text.remove_suffix(in ? 3 : 4);
  const auto name = world::parse_name(text);
  if (!name || name->kind != world::Kind::knot) return words.reject(kExpected);
  value = {*name, in ? HandleEnd::in : HandleEnd::out};
  return true;
}

bool read_value(base::Words& words, glm::vec3& value) {
  for (const auto& [axis, what] : {std::pair{0, "a number (x of three)"}, std::pair{1, "a number (y of three)"},
                                   std::pair{2, "a number (z of three)"}})
    if (!read_number(words, what, base::parse_float, value[axis])) return false;
  return true;
}
bool read_value(base::Words& words, float& value) { return read_number(words, "a number", base::parse_float, value); }
bool read_value(base::Words& words, double& value) { return read_number(words, "a number", base::parse_double, value); }
bool read_value(base::Words& words, std::int64_t& value) {
  return read_number(words, "a whole number", base::parse_int, value);
}
bool read_value(base::Words& words, int& value) {
  const auto parse = [](std::string_view text) {
    auto number = base::parse_int(text);
    if (number && (*number > std::numeric_limits<int>::max() || *number < std::numeric_limits<int>::min()))
      number.reset();
    return number;
  };
  return read_number(words, "a whole number", parse, value);
}
bool read_value(base::Words& words, bool& value) {
  static const Names kNames{"off", "on"};
  const auto row = words.one_of(joined(kNames), kNames);
  if (row) value = *row == 1;
  return row.has_value();
}
bool read_value(base::Words& words, std::string& value) {
  const base::Token* const word = words.take("a text");
  if (word) value = word->text;
  return word != nullptr;
}

}  // namespace coaster::edit
