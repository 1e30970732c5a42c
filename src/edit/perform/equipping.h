// The equipment that a command describes. Private to this room.
#pragma once

#include <cmath>

#include "edit/perform/perform.h"

namespace coaster::edit {

// Returns it with its numbers clamped to their limits; refused if one is not finite.
inline base::Result<world::Equipment> equipment_of(world::Equipment equipment, Change& change) {
  for (const float value : {equipment.speed, equipment.acceleration, equipment.hysteresis, equipment.seconds})
    if (!std::isfinite(value)) return refused("expected finite numbers");
  const auto fastest = static_cast<float>(world::kMaxSpeed);
  equipment.speed = change.clamp("speed", equipment.speed, 0.0f, fastest, "m/s");
  equipment.acceleration =
      change.clamp("acceleration", equipment.acceleration, world::kMinAcceleration, world::kMaxAcceleration, "m/s^2");
  equipment.hysteresis = change.clamp("hysteresis", equipment.hysteresis, 0.0f, fastest, "m/s");
  equipment.seconds = change.clamp("seconds", equipment.seconds, 0.0f, world::kMaxDwell, "s");
  return equipment;
}

}  // namespace coaster::edit
