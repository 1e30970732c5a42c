// Rows and parameters of elements by name.
#include "world/element.h"

#include "base/check.h"

namespace coaster::world {

Element usual_element(ElementKind kind) {
  Element element{kind, false, {}};
  const std::span<const ElementParameter> parameters = base::row_of(kind).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) element.values[i] = parameters[i].usual;
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
