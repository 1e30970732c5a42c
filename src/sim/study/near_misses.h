// Near misses: where riders pass close by other track or by a support that does not hold the track under them.
#pragma once

#include "sim/ride/ghost.h"
#include "sim/solids/supports.h"

namespace coaster::sim {

struct NearMisses {
  int track = 0, supports = 0;
  int count() const { return track + supports; }
};

// Height of a rider's head above the rails, and the distance of a near miss from it, m: to the middle of other track,
// and to the surface of a support's bar.
inline constexpr double kHead = 1.5, kNearTrack = 3.0, kNearBar = 2.2;
inline constexpr double kSlowestMiss = 5;  // m/s: slower passes do not count
inline constexpr double kMissApart =
    12;  // m along the rails: closer parts are one stretch, and closer near misses are one

// Counts the near misses of the first lap, for the first car's riders; without `supports` only those of track. About a
// microsecond per metre of track and of ride.
NearMisses near_misses(const Ghost& ghost, const Derived& derived, const Supports* supports);

}  // namespace coaster::sim
