// When a ride is over by itself; the same for the ride and for the ghost.
#pragma once

#include "world/motion.h"

namespace coaster::sim {

inline constexpr double kRollback = 2.0;     // m that a train may lose of its way before it counts as rolling back
inline constexpr double kStillSpeed = 0.01;  // m/s, slower is standing
inline constexpr int kStillTicks =
    2 * world::kTicksPerSecond;  // that a train may stand where nothing holds it, until it counts as stalled

}  // namespace coaster::sim
