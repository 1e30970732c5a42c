// What a ride passes on a land: tunnels, and earth, water and trees near the riders' heads.
#pragma once

#include "sim/ground/ground.h"
#include "sim/ground/plants.h"
#include "sim/ride/simulated_ride.h"

namespace coaster::sim {

struct Surroundings {
  int tunnels = 0;        // passed on the lap
  double in_tunnels = 0;  // m of track in them
  double close = 0;       // share of the lap, 0..1, within kCloseBy of earth, water or trees
  int near_misses = 0;    // of these, portals among them
};

// Earth counts where it rises beside a head or above it: in the half plane across the track that begins on both sides
// at the height of the head. The ground on which the track stands does not. Water counts by its depth below the head,
// a tree by the distance to its crown or trunk.
inline constexpr double kCloseBy = 6;  // m
// m from a head: a near miss. Trees are planted at least about 4.5 m off.
inline constexpr double kNearEarth = 1.2, kNearWater = 2.2, kNearTree = 5.0;

// Returns what the first car's riders pass on the first lap; nothing without a land. Near misses are as those of track:
// slower passes than kSlowestMiss do not count, and those within kMissApart along the rails are one. About ten
// microseconds per metre.
Surroundings surroundings_of(const SimulatedRide& simulated, const DerivedTrack& derived, const Ground& ground,
                             const Plants& plants);

}  // namespace coaster::sim
