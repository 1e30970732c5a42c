// The only functions that change which knots, segments and carts there are and in which order. They keep every
// invariant of Document; they do no undo and no checking of user input (edit/apply.cpp does).
#pragma once

#include "world/document.h"

namespace coaster::world {

// New entities get the next number of their kind.
Entity add_cart(Document& document, Entity segment, double fraction);

// Appends behind the last knot of an open track, with a segment to it when there is a knot before it.
Entity append_knot(Document& document, const Knot& knot);

struct SplitResult {
  Entity knot;            // the new knot, joint aligned
  Entity first, second;   // `first` is the segment that was split; `second` is new and follows it
};
// Splits at t in (0,1) by de Casteljau without changing the shape (to float rounding): the knots at both ends become
// aligned and get the scaled handle lengths (Paper erratum: the split scales the parametric speed, so uniform C1 becomes G1).
// `up` is that of the segment's own frame at t, passed by the caller. Carts as designed keep their place.
// Handles that would get shorter than kMinHandle: nothing is changed and knot is kNone.
SplitResult split_segment(Document& document, Entity segment, double t, glm::vec3 up);

// Removes a knot; the two segments at it become one (the earlier one survives); carts of the later one move to the survivor.
// At the end of an open track its segment and carts on it go too. A closed track of 2 knots becomes open.
void remove_knot(Document& document, Entity knot);

// Closing adds a segment from the last knot to the first (needs 2 knots, else no effect); opening removes that segment.
void set_closed(Document& document, bool closed);

// Recomputes the knots whose joint is automatic, and makes lengths of smooth joints equal. Idempotent to the bit.
void settle_joints(Document& document);

// Sets the tangent (normalised here; too short: ignored) and turns `up` with it by the least rotation.
void set_tangent(Knot& knot, glm::vec3 direction);
// Roll about the tangent in degrees from the horizon: 0 has `up` as near to +Y as can be (for a vertical tangent: to a
// fixed horizontal reference). Positive rolls to the right as seen by the rider.
double roll_deg(const Knot& knot);
void set_roll(Knot& knot, double roll_deg);

// Unit and perpendicular again, in double, rounded once; keeps the bits of what already is, to 1e-6.
void orthonormalise(Knot& knot);

}  // namespace coaster::world
