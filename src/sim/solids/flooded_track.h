// Track under water: a warning, as track that is too close to other track is.
#pragma once

#include <vector>

#include "sim/ground/ground.h"
#include "sim/solids/conflict_types.h"

namespace coaster::sim {

// Returns the stretches of track under the water of a land, in the track's order. Track in a tunnel below a lake is
// dry, and so is all without a land; an open cut below the water's level is flooded.
std::vector<FloodedTrack> flooded_track(const Ground& ground);

}  // namespace coaster::sim
