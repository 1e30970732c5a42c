// The parameters of an element, as rows of a panel: of the palette's and of a section's.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "ui/context/ui.h"
#include "world/element.h"

namespace coaster::ui {

// Which of the rows show, and what is drawn below each; by the parameter's name, "side" for left and right.
struct ElementRows {
  std::function<bool(std::string_view name)> shown = nullptr;  // null: all
  std::function<void(std::string_view name)> below = nullptr;  // null: nothing
};

// A parameter with its unit and limits, as fields show it.
Number parameter_number(const world::ElementParameter& parameter, double value);

// Changes a value of `element` as the user does. Returns the name of what was changed.
std::optional<std::string_view> element_fields(Ui& ui, world::Element& element, const ElementRows& rows = {});

}  // namespace coaster::ui
