// Finds a start speed for tracks that do not specify one.
#pragma once

#include <optional>

#include "world/document.h"

namespace coaster::sim {

// Returns a start speed (m/s) with which the first train completes its lap, or reaches the end of an open track: the
// smallest whole number that does, plus 1 so that no top is passed too slowly; at most world::kMaxSpeed. Nothing if
// none does, or without a train. Bisects, because higher speeds also complete the ride. Takes about 9 simulations.
std::optional<double> completing_speed(world::Document document);

}  // namespace coaster::sim
