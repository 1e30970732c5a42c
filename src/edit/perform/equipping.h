// The equipment that a command describes. Private to this room.
#pragma once

#include <cmath>

#include "edit/perform/perform.h"

namespace coaster::edit {

// Returns it with its numbers within their limits; refused where one is not finite.
template <class Command>
base::Result<world::Equipment> equipment_of(const Command& command, Change& change) {
  for (const float value : {command.speed, command.acceleration, command.hysteresis, command.seconds})
    if (!std::isfinite(value)) return refused("expected finite numbers");
  world::Equipment equipment{command.to};
  const auto fastest = static_cast<float>(world::kMaxSpeed);
  equipment.speed = change.clamp("speed", command.speed, 0.0f, fastest, "m/s");
  equipment.acceleration =
      change.clamp("acceleration", command.acceleration, world::kMinAcceleration, world::kMaxAcceleration, "m/s^2");
  equipment.hysteresis = change.clamp("hysteresis", command.hysteresis, 0.0f, fastest, "m/s");
  equipment.seconds = change.clamp("seconds", command.seconds, 0.0f, world::kMaxDwell, "s");
  return equipment;
}

}  // namespace coaster::edit
