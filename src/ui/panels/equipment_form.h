// Equipment as a form, for segments and sections.
#pragma once

#include <functional>
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

// Shows the equipment of segments: a button for each kind and one for none, "Equipment/Lift", and the numbers of the
// kind unless the segments differ. Calls `equip` with what the user chooses; nothing: plain track. A challenge may lock
// `command`, which equips.
void equipment_form(Ui& ui, const std::vector<world::Entity>& segments, std::string_view command,
                    const std::function<void(const std::optional<world::Equipment>& to)>& equip);

}  // namespace coaster::ui
