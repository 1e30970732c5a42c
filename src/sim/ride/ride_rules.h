// When a ride ends by itself; the same for the ride and the ghost.
#pragma once

#include "world/motion.h"

namespace coaster::sim {

inline constexpr double kRollback = 2.0;     // m of distance that a train may lose before it counts as rolling back
inline constexpr double kStillSpeed = 0.01;  // m/s, slower is at rest
inline constexpr int kStillTicks =
    2 * world::kTicksPerSecond;  // ticks at rest, held by nothing, until a train counts as stalled

}  // namespace coaster::sim
