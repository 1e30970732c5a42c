// The shape of appended knots: clicking along the ground makes a smooth curve, and knots edited by hand keep their
// shape.
#pragma once

#include "world/document.h"

namespace coaster::edit {

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
