// The parameters of an element as rows of a panel, for the palette and for sections.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "ui/context/ui.h"
#include "world/element.h"

namespace coaster::ui {

// The rows to show and the content below each, by the parameter's name; "side" is left or right.
struct ElementRows {
  std::function<bool(std::string_view name)> shown = nullptr;  // null: all
  std::function<void(std::string_view name)> below = nullptr;  // null: nothing
};

// Returns a parameter with its unit and limits, for a field.
Number parameter_number(const world::ElementParameter& parameter, double value);

// Shows the rows and applies the user's changes to `element`. Returns the name of the changed parameter.
std::optional<std::string_view> element_fields(Ui& ui, world::Element& element, const ElementRows& rows = {});

}  // namespace coaster::ui
