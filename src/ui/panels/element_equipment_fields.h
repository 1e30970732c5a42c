// Elements and equipment as rows of a panel, for the palette, segments and sections.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "ui/context/ui.h"
#include "world/components.h"
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

// The equipment of several segments; nothing if they differ.
struct CommonEquipment {
  bool mixed = false;
  const world::Equipment* equipment = nullptr;  // null: plain track, or mixed
};
CommonEquipment equipped(const world::Document& document, const std::vector<world::Entity>& segments);

// Shows the equipment of segments: a button for each kind and one for none, "Equipment/Lift", and the numbers of the
// kind unless the segments differ. Calls `equip` with what the user chooses; nothing: plain track. A challenge may lock
// `command`, which equips.
void equipment_form(Ui& ui, const std::vector<world::Entity>& segments, std::string_view command,
                    const std::function<void(const std::optional<world::Equipment>& to)>& equip);

}  // namespace coaster::ui
