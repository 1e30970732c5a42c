// The shape that clicked points get, so that clicking along the ground makes a flowing curve and shaping by hand stays.
#pragma once

#include "world/document.h"

namespace coaster::edit {

// A new last knot: along the chord from the last knot (level and along its tangent when that is too short), lengths a
// third of the chord, smooth. The first knot of a track: along +X, 5 m.
world::Knot appended_knot(const world::Document& document, glm::vec3 position);

// Turns an end knot between its new neighbours, as Catmull-Rom, if it still has the shape that appending gave it: both
// direction and lengths equal those of the chord beside it to the bit (or of a lone first knot). Otherwise leaves it.
// Call it for the last knot before appending, with the coming position, and for both ends before closing.
void reshape_end(world::Document& document, bool last, glm::vec3 beyond);

// Closes an open track of two knots or more by a segment from its last knot to its first. Their handles on it that are
// longer than `longest` times the gap become a third of it, which frees them from the other ones; those of both ends
// that were never touched bend towards each other first.
void close_by_segment(world::Document& document, double longest);
// Handles longer than this share of the gap make a segment that folds back, or nearly so; a half circle has 2/3.
inline constexpr double kLongestClosing = 0.7;

}  // namespace coaster::edit
