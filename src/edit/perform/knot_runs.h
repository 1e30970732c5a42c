// The knots or sections of a command, and runs of neighbours among knots. Private to this room.
#pragma once

#include <vector>

#include "edit/perform/perform_context.h"
#include "world/document.h"

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

// --- The shape of appended knots: clicking along the ground makes a smooth curve, and knots edited by hand keep their
// shape

// Makes both handles of a knot as long as they are on average.
void equalise(world::Knot& knot);

// Returns a new last knot: along the chord from the last knot (level and along its tangent if that is too short),
// lengths a third of the chord, smooth. The first knot of a track: along +X, 5 m.
world::Knot appended_knot(const world::Document& document, glm::vec3 position);

// Turns an end knot between its new neighbours, as Catmull-Rom, if it still has exactly the shape from appending:
// direction and lengths of the chord next to it (or of a single first knot). Otherwise it does nothing. Call it for the
// last knot before appending, with the new position, and for both ends before closing.
void reshape_end(world::Document& document, bool last, glm::vec3 beyond);

// Closes an open track of two knots or more by a segment from its last knot to its first. First, ends that were never
// edited bend towards each other. Handles on the segment that are longer than `longest` times the gap become a third of
// it and independent of the handles on the other side.
void close_by_segment(world::Document& document, double longest);
// Handles longer than this fraction of the gap make a segment that folds back, or nearly does; a half circle has 2/3.
inline constexpr double kLongestClosing = 0.7;

}  // namespace coaster::edit
