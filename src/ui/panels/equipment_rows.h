// The numbers of equipment, as rows of a panel: of a segment's and of a section's.
#pragma once

#include "ui/context/ui.h"
#include "world/components.h"

namespace coaster::ui {

// Shows the numbers that the kind has; emits `set` with a changed one. The command has the members of world::Equipment.
template <class Command>
void equipment_rows(Ui& ui, Command set) {
  const auto field = [&](const char* label, float& value, const char* unit, double low, double high,
                         const char* tooltip) {
    const auto to = number(ui, label, {.value = value, .unit = unit, .low = low, .high = high}, tooltip);
    if (!to) return;
    value = static_cast<float>(*to);
    ui.emit(set);
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
