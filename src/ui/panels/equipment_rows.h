// Equipment as rows of a panel, for segments and sections.
#pragma once

#include <optional>
#include <vector>

#include "ui/context/ui.h"
#include "world/components.h"

namespace coaster::ui {

// The equipment of several segments; nothing if they differ.
struct Equipped {
  bool mixed = false;
  const world::Equipment* equipment = nullptr;  // null: plain track, or mixed
};
Equipped equipped(const world::Document& document, const std::vector<world::Entity>& segments);

// A button for each kind and one for none, "Equipment/Lift"; the current one has a frame. A challenge may lock
// `command`, which equips.
struct EquipmentChoice {
  std::optional<world::EquipmentKind> kind;  // nothing: plain track
};
std::optional<EquipmentChoice> equipment_buttons(Ui& ui, const Equipped& now, bool enabled, std::string_view command);

// Shows the numbers of the kind. Returns the equipment with the number that the user changed.
std::optional<world::Equipment> equipment_rows(Ui& ui, world::Equipment now, std::string_view command);

}  // namespace coaster::ui
