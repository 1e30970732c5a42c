// The equipment that a command describes, and its notice. Private to this room.
#pragma once

#include <span>

#include <fmt/format.h>

#include "edit/perform/perform_context.h"
#include "world/equipment_rows.h"

namespace coaster::edit {

// Returns it with its numbers clamped to their limits.
inline world::Equipment equipment_of(world::Equipment equipment, Change& change) {
  const auto fastest = static_cast<float>(world::kMaxSpeed);
  equipment.speed = change.clamp("speed", equipment.speed, 0.0f, fastest, "m/s");
  equipment.acceleration =
      change.clamp("acceleration", equipment.acceleration, world::kMinAcceleration, world::kMaxAcceleration, "m/s^2");
  equipment.hysteresis = change.clamp("hysteresis", equipment.hysteresis, 0.0f, fastest, "m/s");
  equipment.seconds = change.clamp("seconds", equipment.seconds, 0.0f, world::kMaxDwell, "s");
  return equipment;
}

// Puts equipment on segments. A notice names what they became, unless all of them were that already or another notice
// names a limit.
inline void equip(world::Document& document, Change& change, std::span<const world::Entity> segments,
                  const world::Equipment& equipment, const std::string& title) {
  bool new_kind = false;
  for (const world::Entity segment : segments) {
    const auto* const before = document.entities.find<world::Equipment>(segment);
    new_kind = new_kind || before == nullptr || before->kind != equipment.kind;
    document.entities.put(segment, equipment);
  }
  if (new_kind && change.clamped.empty())
    change.note = fmt::format("Made {} a {}.", title, base::name_of(equipment.kind));
}

}  // namespace coaster::edit
