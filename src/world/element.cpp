// Rows and parameters of elements by name.
#include "world/element.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "world/element_rows.h"

namespace coaster::world {

Element usual_element(ElementKind kind) {
  Element element{kind, false, {}};
  const std::span<const ElementParameter> parameters = base::row_of(kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) element.values[i] = parameters[i].usual;
  return element;
}

std::vector<Element> usual_elements() {
  std::vector<Element> all;
  for (std::size_t i = 0; i < base::count_of<ElementKind>(); ++i)
    all.push_back(usual_element(static_cast<ElementKind>(i)));
  return all;
}

Element first_element() { return usual_element(ElementKind::curve); }
ElementKind first_of_forces() { return ElementKind::force_hill; }
bool is_of_forces(ElementKind kind) { return kind >= first_of_forces(); }

bool within_limits(const Element& element) {
  if (!base::has_row(element.kind)) return false;
  const ElementRow& row = base::row_of(element.kind);
  if (element.right && !row.sided) return false;
  for (std::size_t i = 0; i < element.values.size(); ++i) {
    const double value = element.values[i];
    const bool named = i < row.parameters.size();
    if (named ? !(value >= row.parameters[i].low && value <= row.parameters[i].high) : value != 0) return false;
    if (named && !row.parameters[i].names.empty() && value != std::floor(value)) return false;
  }
  return true;
}

Element limited(Element element) {
  const ElementRow& row = base::row_of(element.kind);
  element.right = element.right && row.sided;
  for (std::size_t i = 0; i < element.values.size(); ++i) {
    const bool named = i < row.parameters.size();
    element.values[i] = named ? std::clamp(element.values[i], row.parameters[i].low, row.parameters[i].high) : 0.0;
    if (named && !row.parameters[i].names.empty()) element.values[i] = std::round(element.values[i]);
  }
  return element;
}

const base::NameRow& choice_of(const ElementParameter& parameter, double value) {
  const double last = static_cast<double>(parameter.names.size()) - 1;
  return parameter.names[value > 0 ? static_cast<std::size_t>(std::min(value, last)) : 0];  // NaN: the first
}

std::optional<double> found_value(const Element& element, std::string_view parameter) {
  const std::span<const ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == parameter) return element.values[i];
  return std::nullopt;
}

void set_value(Element& element, std::string_view parameter, double value) {
  const std::span<const ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == parameter) element.values[i] = std::clamp(value, parameters[i].low, parameters[i].high);
}

double value_of(const Element& element, std::string_view parameter) {
  const std::optional<double> found = found_value(element, parameter);
  COASTER_CHECK(found, "the element has this parameter");
  return *found;
}

bool counts(const Element& element, const ElementParameter& parameter) {
  const std::span<const ElementParameter> parameters = base::row_of(element.kind).parameters;
  const auto at = [&](std::string_view name) { return std::ranges::find(parameters, name, &ElementParameter::name); };
  const auto equipment = at(element_rows::kEquipment.name), asked = at(parameter.name);
  if (equipment == parameters.end() || asked <= equipment) return true;  // values of the equipment follow its choice
  return element.values[static_cast<std::size_t>(equipment - parameters.begin())] > 0;
}

}  // namespace coaster::world
