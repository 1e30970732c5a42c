// Elements as text: "loop right height 20 top 90 shift 4".
#include <fmt/format.h>

#include "edit/commands/codec_values.h"

namespace coaster::edit {
namespace {

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
