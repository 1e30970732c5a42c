// Rows and parameters of elements by name.
#include "world/element.h"

#include <algorithm>

#include "base/check.h"

namespace coaster::world {

Element usual_element(ElementKind kind) {
  Element element{kind, false, {}};
  const std::span<const ElementParameter> parameters = base::row_of(kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) element.values[i] = parameters[i].usual;
  return element;
}

bool within_limits(const Element& element) {
  if (!base::has_row(element.kind)) return false;
  const ElementRow& row = base::row_of(element.kind);
  if (element.right && !row.sided) return false;
  for (std::size_t i = 0; i < element.values.size(); ++i) {
    const double value = element.values[i];
    const bool named = i < row.parameters.size();
    if (named ? !(value >= row.parameters[i].low && value <= row.parameters[i].high) : value != 0) return false;
  }
  return true;
}

Element limited(Element element) {
  const ElementRow& row = base::row_of(element.kind);
  element.right = element.right && row.sided;
  for (std::size_t i = 0; i < element.values.size(); ++i) {
    const bool named = i < row.parameters.size();
    element.values[i] = named ? std::clamp(element.values[i], row.parameters[i].low, row.parameters[i].high) : 0.0;
  }
  return element;
}

double value_of(const Element& element, std::string_view parameter) {
  const std::span<const ElementParameter> parameters = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == parameter) return element.values[i];
  COASTER_CHECK(false, "the element has this parameter");
  return 0;
}

}  // namespace coaster::world
