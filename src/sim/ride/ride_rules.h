// Rules shared by the ride and the ghost: losses, and when a ride ends by itself.
#pragma once

#include <cmath>

#include "world/motion.h"

namespace coaster::sim {

inline constexpr double kRollback = 2.0;     // m that a train may lose before it counts as rolling back
inline constexpr double kStillSpeed = 0.01;  // m/s, slower is at rest
inline constexpr int kStillTicks = 2 * world::kTicksPerSecond;  // at rest, not held, until a train is stalled

// Returns the deceleration by friction and drag, m/s^2.
inline double loss(const world::Resistance& resistance, double speed) {
  return world::kGravity * resistance.rolling + resistance.drag * speed * speed;
}

// Returns the sign of the motion that losses oppose. At rest friction opposes pull(), the acceleration by gravity and
// equipment, up to its limit.
template <class Pull>
double direction_of(double speed, const world::Resistance& resistance, const Pull& pull) {
  if (speed != 0) return speed > 0 ? 1.0 : -1.0;
  const double acceleration = pull();
  if (std::abs(acceleration) <= world::kGravity * resistance.rolling) return 0.0;
  return acceleration > 0 ? 1.0 : -1.0;
}

// Returns true if a train has rolled back too far from the farthest point that it reached.
inline bool rolls_back(const world::Document& document, double speed, double travelled, double furthest) {
  return document.rollback_fails && furthest > kRollback && speed < 0 && travelled < furthest - kRollback;
}

}  // namespace coaster::sim
