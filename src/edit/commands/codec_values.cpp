// Printing and reading the values of command fields.
#include "edit/commands/codec_values.h"

#include <limits>

#include "world/sections.h"

namespace coaster::edit {
namespace {

template <class T, class Parse>
bool read_number(base::WordReader& words, std::string_view what, Parse parse, T& value) {
  const base::Token* const word = words.take(what);
  if (!word) return false;
  const auto number = parse(word->text);
  if (!number) return words.reject_number(what);
  value = static_cast<T>(*number);
  return true;
}

bool read_word(base::WordReader& words, std::string_view expected, auto parse, auto& value) {
  const base::Token* const word = words.take(expected);
  const auto parsed = word ? parse(word->text) : std::nullopt;
  if (parsed) value = *parsed;
  return parsed || (word && words.reject(expected));
}

std::string words_of_name(world::EntityName name, const world::Document& document) {
  const auto* const section = document.entities.find<world::Section>(world::find(document, name));
  return section ? world::words_of(*section) : world::to_text(name);
}

template <class Several>
std::string words_of_several(const Several& value, std::string_view kind, const world::Document& document) {
  if (value.which == Knots::Which::all) return fmt::format("all {}", kind);
  if (value.which == Knots::Which::selected) return fmt::format("the selected {}", kind);
  if (value.which == Knots::Which::range)
    return fmt::format("{} to {}", words_of_name(value.names.front(), document),
                       words_of_name(value.names.back(), document));
  if (value.names.size() != 1) return fmt::format("{} {}", value.names.size(), kind);
  return words_of_name(value.names.front(), document);
}

// Knots or sections.
template <class Several>
std::string print_several(const Several& value) {
  if (value.which == Knots::Which::all) return "all";
  if (value.which == Knots::Which::selected) return "selected";
  const std::string_view between = value.which == Knots::Which::range ? "..@" : ",@";
  std::string text;
  for (const world::EntityName& name : value.names) {
    text += text.empty() ? "@" : between;
    text += world::to_text(name);
  }
  return text.empty() ? "none" : text;
}

std::optional<world::EntityName> read_name(std::string_view word) {
  return word.starts_with('@') ? world::parse_name(word.substr(1)) : std::nullopt;
}

template <class Several>
bool read_several(base::WordReader& words, std::string_view expected, Several& value) {
  const base::Token* const word = words.take(expected);
  if (!word) return false;
  value = {};
  if (word->text == "none") return true;
  if (word->text == "all") return value.which = Knots::Which::all, true;
  if (word->text == "selected") return value.which = Knots::Which::selected, true;
  std::string_view rest = word->text;
  if (const std::size_t dots = rest.find(".."); dots != std::string_view::npos) {
    const auto first = read_name(rest.substr(0, dots)), last = read_name(rest.substr(dots + 2));
    if (!first || !last || first->kind != last->kind) return words.reject(expected);
    value.which = Knots::Which::range, value.names = {*first, *last};
    return true;
  }
  for (;;) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const auto name = read_name(rest.substr(0, comma));
    if (!name) return words.reject(expected);
    value.names.push_back(*name);
    if (comma == rest.size()) return true;
    rest.remove_prefix(comma + 1);
  }
}

template <class T>
bool read_part(base::WordReader& words, std::optional<T>& part) {
  return read_value(words, part.emplace());
}
bool read_part(base::WordReader&, bool& part) { return part = true; }
template <class T>
std::string print_part(const std::optional<T>& part) {
  return ' ' + print_value(*part);
}
std::string print_part(bool) { return {}; }

// Values whose parts follow their names, in any order.
std::string print_parts(const auto& value) {
  std::string text;
  value.fields(value, [&](std::string_view name, const auto& part) {
    if (part) text += fmt::format("{}{}{}", text.empty() ? "" : " ", name, print_part(part));
  });
  return text;
}
bool read_parts(base::WordReader& words, auto& value, bool needs_one) {
  Names names;
  value.fields(value, [&](std::string_view name, auto&) { names.emplace_back(name); });
  for (bool more = needs_one || !words.at_end(); more; more = !words.at_end()) {
    const auto chosen = words.one_of(base::alternatives(names), names);
    bool read = false;
    value.fields(value, [&](std::string_view name, auto& part) {
      if (chosen && name == names[*chosen]) read = read_part(words, part);
    });
    if (!read) return false;
  }
  return true;
}

// --- Elements as text: "loop right height 20 top 90 shift 4"

constexpr std::string_view kLeft = "left", kRight = "right";

// Reads a number, or the name of a choice.
bool read_parameter(base::WordReader& words, const world::ElementParameter& parameter, double& value) {
  if (parameter.names.empty()) return read_value(words, value);
  const Names names = base::names_in(parameter.names);
  const auto row = words.one_of(joined(names), names);
  if (row) value = static_cast<double>(*row);
  return row.has_value();
}

// Returns the words that may follow an element's name.
Names words_of(const world::ElementRow& row) {
  Names names = base::names_in(row.parameters);
  if (row.sided) names.emplace_back(kLeft), names.emplace_back(kRight);
  return names;
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
std::string print_value(glm::vec2 v) { return fmt::format("{} {}", base::to_text(v.x), base::to_text(v.y)); }
std::string print_value(WaterLevel value) {
  return value.level == world::kNoWater ? "none" : base::to_text(value.level);
}
std::string print_value(bool value) { return value ? "on" : "off"; }
std::string print_value(world::Colour value) {
  return value.own() ? base::quoted(world::to_text(value)) : world::to_text(value);
}
std::string print_value(const std::string& value) { return base::quoted(value); }

std::string words_of(const Target& value, const world::Document& document) {
  return value.name.number == 0 ? "nothing" : words_of_name(value.name, document);
}
std::string words_of(const HandleTarget& value) {
  return fmt::format("the {} handle of {}", value.end == HandleEnd::in ? "incoming" : "outgoing",
                     world::to_text(value.knot));
}
std::string words_of(const Knots& value, const world::Document& document) {
  return words_of_several(value, "knots", document);
}
std::string words_of(const Sections& value, const world::Document& document) {
  return words_of_several(value, "sections", document);
}
std::string words_of(const KnotsOrSections& value, const world::Document& document) {
  const bool sections = !value.names.empty() && value.names.front().kind == world::EntityKind::section;
  return words_of_several(value,
                          sections                           ? "sections"
                          : value.which == Knots::Which::all ? "knots"
                                                             : "places",
                          document);
}
std::string words_of(glm::vec3 v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }
std::string words_of(WaterLevel value) {
  return value.level == world::kNoWater ? "none" : fmt::format("{:.6g} m", value.level);
}
std::string words_of(const world::Element& value) { return words_of(value.kind); }

std::string print_value(const Knots& value) { return print_several(value); }
std::string print_value(const Sections& value) { return print_several(value); }
bool read_value(base::WordReader& words, Knots& value) {
  return read_several(words, "knots such as @k3, @k1,@k2 or @k3..@k9, or all, or selected", value);
}
bool read_value(base::WordReader& words, Sections& value) {
  return read_several(words, "sections such as @q3, @q1,@q2 or @q3..@q9, or all, or selected", value);
}
bool read_value(base::WordReader& words, KnotsOrSections& value) {
  return read_several(words, "knots or sections such as @k3..@k9 or @q2, or all, or selected", value);
}

std::string print_value(const Phrase& value) { return value.text; }
bool read_value(base::WordReader& words, Phrase& value) {
  value.text.clear();
  while (const base::Token* const word = words.peek()) {
    if (!word->quoted && (word->text == "by" || word->text == "of")) break;
    words.take("a word");
    value.text += (value.text.empty() ? "" : " ") + (word->quoted ? base::quoted(word->text) : word->text);
  }
  if (!value.text.empty()) return true;
  return words.take("words") != nullptr && words.reject("words");
}

std::string print_value(const CameraChange& value) { return print_parts(value); }
std::string print_value(const exchange::ImportOptions& value) { return print_parts(value); }
bool read_value(base::WordReader& words, CameraChange& value) { return read_parts(words, value, true); }
bool read_value(base::WordReader& words, exchange::ImportOptions& value) { return read_parts(words, value, false); }

bool read_value(base::WordReader& words, Target& value) {
  const auto parse = [](std::string_view text) { return text == "none" ? world::EntityName{} : read_name(text); };
  return read_word(words, "an entity such as @k3, @s2, @c1 or @q1", parse, value.name);
}

bool read_value(base::WordReader& words, world::Colour& value) {
  return read_word(words, "a colour such as \"#d9452f\", or own", world::parse_colour, value);
}

bool read_value(base::WordReader& words, HandleTarget& value) {
  const auto parse = [](std::string_view text) -> std::optional<HandleTarget> {
    const bool in = text.ends_with(".in");
    if (!in && !text.ends_with(".out")) return {};
    const auto name = read_name(text.substr(0, text.size() - (in ? 3 : 4)));
    if (!name || name->kind != world::EntityKind::knot) return {};
    return HandleTarget{*name, in ? HandleEnd::in : HandleEnd::out};
  };
  return read_word(words, "a handle such as @k3.in or @k3.out", parse, value);
}

bool read_value(base::WordReader& words, glm::vec3& value) {
  for (const auto& [axis, what] : {std::pair{0, "a number (x of three)"}, std::pair{1, "a number (y of three)"},
                                   std::pair{2, "a number (z of three)"}})
    if (!read_number(words, what, base::parse_float, value[axis])) return false;
  return true;
}
bool read_value(base::WordReader& words, glm::vec2& value) {
  return read_number(words, "a number (x of x and z)", base::parse_float, value.x) &&
         read_number(words, "a number (z of x and z)", base::parse_float, value.y);
}
bool read_value(base::WordReader& words, WaterLevel& value) {
  const base::Token* const word = words.peek();
  const bool none = word && !word->quoted && word->text == "none";
  if (!none) return read_number(words, "a number, or none", base::parse_double, value.level);
  value = {};
  return words.take("none") != nullptr;
}
bool read_value(base::WordReader& words, float& value) {
  return read_number(words, "a number", base::parse_float, value);
}
bool read_value(base::WordReader& words, double& value) {
  return read_number(words, "a number", base::parse_double, value);
}
bool read_value(base::WordReader& words, std::int64_t& value) {
  return read_number(words, "a whole number", base::parse_int, value);
}
bool read_value(base::WordReader& words, int& value) {
  const auto parse = [](std::string_view text) {
    auto number = base::parse_int(text);
    if (number && (*number > std::numeric_limits<int>::max() || *number < std::numeric_limits<int>::min()))
      number.reset();
    return number;
  };
  return read_number(words, "a whole number", parse, value);
}
bool read_value(base::WordReader& words, bool& value) {
  static const Names kNames{"off", "on"};
  const auto row = words.one_of(joined(kNames), kNames);
  if (row) value = *row == 1;
  return row.has_value();
}
bool read_value(base::WordReader& words, std::string& value) {
  const base::Token* const word = words.take("a text");
  if (word) value = word->text;
  return word != nullptr;
}

std::string print_value(const world::Element& value) {
  const world::ElementRow& row = base::row_of(value.kind);
  std::string text(row.name);
  if (row.sided) text += fmt::format(" {}", value.right ? kRight : kLeft);
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const world::ElementParameter& parameter = row.parameters[i];
    text += fmt::format(" {} {}", parameter.name,
                        parameter.names.empty() ? base::to_text(value.values[i])
                                                : std::string(world::choice_of(parameter, value.values[i]).name));
  }
  return text;
}

bool read_value(base::WordReader& words, world::Element& value) {
  world::ElementKind kind{};
  if (!read_value(words, kind)) return false;
  value = world::usual_element(kind);
  const Names names = words_of(base::row_of(value.kind));
  const std::span<const world::ElementParameter> parameters = base::row_of(value.kind).parameters;
  while (words.peek()) {
    const auto word = words.one_of(joined(names), names);
    if (!word) return false;
    if (*word >= parameters.size()) value.right = names[*word] == kRight;
    else if (!read_parameter(words, parameters[*word], value.values[*word])) return false;
  }
  return true;
}

std::string usage_of(const world::Element&) {
  std::string text;
  for (const world::ElementRow& row : world::elements()) {
    text += fmt::format("{}{}{}", text.empty() ? "" : " | ", row.name, row.sided ? " [left|right]" : "");
    for (const world::ElementParameter& parameter : row.parameters)
      text += fmt::format(" [{} {}]", parameter.name,
                          parameter.names.empty() ? "NUMBER" : joined(base::names_in(parameter.names)));
  }
  return text;
}

}  // namespace coaster::edit
