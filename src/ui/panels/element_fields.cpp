#include "ui/panels/element_fields.h"

#include "world/element_rows.h"

namespace coaster::ui {
namespace {

// Returns true if the side was changed.
bool side_field(Ui& ui, world::Element& element) {
  const bool right = element.right;
  if (radio(ui, "Left", !right, "Turn left.")) element.right = false;
  (void)beside_last(ui, "Right");
  if (radio(ui, "Right", right, "Turn right.")) element.right = true;
  return element.right != right;
}

// Returns the value that the user selected or typed.
std::optional<double> parameter_field(Ui& ui, const world::ElementParameter& p, double value) {
  if (!p.names.empty()) {
    std::vector<Choice> choices;
    for (const base::NameRow& choice : p.names)
      choices.push_back({std::string(choice.label), std::string(choice.help)});
    const auto to = combo(ui, p.label, choices, static_cast<int>(value), p.help);
    return to ? std::optional<double>(*to) : std::nullopt;
  }
  return number(ui, p.label, parameter_number(p, value), p.help);
}

}  // namespace

Number parameter_number(const world::ElementParameter& p, double value) {
  const double range = p.high - p.low, step = range > 100 ? 0.1 : range > 20 ? 0.05 : 0.01;
  const char* const unit = p.unit == "deg" ? "\u00B0" : p.unit.data();  // as other panels show it
  return {.value = value, .unit = unit, .step = step, .low = p.low, .high = p.high, .largest = 1e300};
}

std::optional<std::string_view> element_fields(Ui& ui, world::Element& element, const ElementRows& rows) {
  const world::ElementRow& row = base::row_of(element.kind);
  std::optional<std::string_view> changed;
  const auto shown = [&](std::string_view name) { return !rows.shown || rows.shown(name); };
  const auto below = [&](std::string_view name) {
    if (rows.below) rows.below(name);
  };
  if (row.sided && shown("side")) {
    if (side_field(ui, element)) changed = "side";
    below("side");
  }
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const world::ElementParameter& p = row.parameters[i];
    if (!shown(p.name) || !world::counts(element, p)) continue;
    if (const auto to = parameter_field(ui, p, element.values[i])) element.values[i] = *to, changed = p.name;
    below(p.name);
  }
  return changed;
}

}  // namespace coaster::ui
