// Equipment as rows of a panel: of segments and of sections.
#pragma once

#include <optional>
#include <vector>

#include "ui/context/ui.h"
#include "world/components.h"

namespace coaster::ui {

// The equipment of several segments; nothing where they differ.
struct Equipped {
  bool mixed = false;
  const world::Equipment* equipment = nullptr;  // null: plain track, or mixed
};
Equipped equipped(const world::Document& document, const std::vector<world::Entity>& segments);

// A button for each kind and one for none, "Equipment/Lift"; the present one has a frame.
struct EquipmentChoice {
  std::optional<world::EquipmentKind> kind;  // nothing: plain track
};
std::optional<EquipmentChoice> equipment_buttons(Ui& ui, const Equipped& now, bool enabled);

// Shows the numbers that the kind has; calls emit(set) with a changed one. The command has the members of
// world::Equipment.
template <class Command, class Emit>
void equipment_rows(Ui& ui, Command set, const Emit& emit) {
  const auto field = [&](const char* label, float& value, const char* unit, double low, double high,
                         const char* tooltip) {
    const auto to = number(ui, label, {.value = value, .unit = unit, .low = low, .high = high}, tooltip);
    if (!to) return;
    value = static_cast<float>(*to);
    emit(set);
  };
  field("Speed", set.speed, "m/s", 0, world::kMaxSpeed,
        "Target speed of a lift, launch or brake, and exit speed of a station.");
  field("Acceleration", set.acceleration, "m/s\u00B2", world::kMinAcceleration, world::kMaxAcceleration,
        "Largest acceleration or deceleration.");
  if (set.to == world::EquipmentKind::brake || set.to == world::EquipmentKind::block)
    field("Hysteresis", set.hysteresis, "m/s", 0, world::kMaxSpeed,
          "The brake switches on above speed + hysteresis and off below speed - hysteresis.");
  if (set.to == world::EquipmentKind::station)
    field("Wait", set.seconds, "s", 0, world::kMaxDwell, "Time that a train waits in the station.");
}

}  // namespace coaster::ui
