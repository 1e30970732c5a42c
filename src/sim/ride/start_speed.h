// A start speed for tracks that come without one.
#pragma once

#include <optional>

#include "world/document.h"

namespace coaster::sim {

// Returns a start speed (m/s) with which the first train completes its lap, or reaches the end of an open track: the
// least whole number that does, plus 1 so that no top is passed at a crawl; at most world::kMaxSpeed. Nothing if none
// does, or without a train. Bisects: where a speed completes the ride, higher ones do. Takes about 9 simulations.
std::optional<double> completing_speed(world::Document document);

}  // namespace coaster::sim
