// Elements as text: "loop right height 20 top 90 shift 4".
#include <algorithm>

#include "edit/commands/codec_values.h"

namespace coaster::edit {
namespace {

constexpr std::string_view kLeft = "left", kRight = "right";

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
  if (row.sided) text += " " + std::string(value.right ? kRight : kLeft);
  for (std::size_t i = 0; i < row.parameters.size(); ++i)
    text += " " + std::string(row.parameters[i].name) + " " + base::to_text(value.values[i]);
  return text;
}

bool read_value(WordReader& words, world::Element& value) {
  world::ElementKind kind{};
  if (!read_value(words, kind)) return false;
  value = world::usual_element(kind);
  const Names names = words_of(base::row_of(value.kind));
  const std::size_t parameters = base::row_of(value.kind).parameters.size();
  while (words.peek()) {
    int word = 0;
    if (!read_name(words, names, word)) return false;
    const auto index = static_cast<std::size_t>(word);
    if (index >= parameters) value.right = names[index] == kRight;
    else if (!read_value(words, value.values[index])) return false;
  }
  return true;
}

std::string usage_of(const world::Element&) {
  std::string text;
  for (const world::ElementRow& row : world::elements()) {
    text += (text.empty() ? "" : " | ") + std::string(row.name) + (row.sided ? " [left|right]" : "");
    for (const world::ElementParameter& parameter : row.parameters)
      text += " [" + std::string(parameter.name) + " NUMBER]";
  }
  return text;
}

}  // namespace coaster::edit
