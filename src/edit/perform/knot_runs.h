// The knots that a command speaks of, and the neighbours among them. Private to this room.
#pragma once

#include <vector>

#include "edit/perform/perform.h"

namespace coaster::edit {

// The living knots that a command names, each once, in the order of the track; refused when there is none.
base::Result<std::vector<world::Entity>> knots_of(const Session& session, const Knots& knots);

// Knots that follow each other on the track, as places in track.knots.
struct KnotRun {
  std::vector<std::size_t> places;  // in the order of travel; may lead over the closed track's joint
  bool whole = false;               // all of a closed track: the last leads back to the first
};
std::vector<KnotRun> runs_of(const world::Document& document, const std::vector<world::Entity>& in_track_order);

}  // namespace coaster::edit
