// The knots or sections of a command, and runs of neighbours among knots. Private to this room.
#pragma once

#include <vector>

#include "edit/perform/perform_context.h"

namespace coaster::edit {

// Returns the existing knots that a command names, each once, in track order; refused if there are none.
base::Result<std::vector<world::Entity>> knots_of(const Session& session, const Knots& knots);
// The same for sections.
base::Result<std::vector<world::Entity>> chosen_sections(const Session& session, const Sections& sections);

// Calls edit(knot) for each knot that a command names, in track order; refused if there are none.
template <class Edit>
base::Status each_knot(Session& session, const Knots& knots, const Edit& edit) {
  const auto chosen = knots_of(session, knots);
  if (!chosen) return chosen.status();
  for (const world::Entity e : *chosen) edit(session.document.entities.get<world::Knot>(e));
  return {};
}

// Returns the knots (in track order) and their neighbours on the track.
std::vector<world::Entity> with_neighbours(const world::Document& document,
                                           const std::vector<world::Entity>& in_track_order);

// Consecutive knots of the track, as indices into track.knots.
struct KnotRun {
  std::vector<std::size_t> places;  // in the order of travel; may cross the closed track's joint
  bool whole = false;               // all knots of a closed track: the last leads back to the first
};
std::vector<KnotRun> runs_of(const world::Document& document, const std::vector<world::Entity>& in_track_order);

}  // namespace coaster::edit
