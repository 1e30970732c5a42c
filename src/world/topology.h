// The only functions that change which knots, segments and carts there are and in which order. They keep every
// invariant of Document; they do no undo and no checking of user input (edit/perform/apply.cpp does).
#pragma once

#include "world/document.h"

namespace coaster::world {

// New entities get the next number of their kind.
Entity add_cart(Document& document, Entity segment, double fraction);

// Appends behind the last knot of an open track, with a segment to it when there is a knot before it.
Entity append_knot(Document& document, const Knot& knot);

struct SplitResult {
  Entity knot;           // the new knot, joint aligned
  Entity first, second;  // `first` is the segment that was split; `second` is new and follows it
};
// Splits at t in (0,1) by de Casteljau without changing the shape (to float rounding): the knots at both ends become
// aligned and get the scaled handle lengths (Paper erratum: the split scales the parametric speed, so uniform C1
// becomes G1). `up` is that of the segment's own frame at t, passed by the caller. Carts as designed keep their place.
// Handles that would leave kMinHandle..kMaxHandle, or a knot beyond kMaxCoordinate: nothing is changed and knot is
// kNone. `turns` stay with the first segment: who knows the twist (sim) shares them out.
SplitResult split_segment(Document& document, Entity segment, double t, glm::vec3 up);

// Removes a knot; the two segments at it become one (the earlier one survives); carts of the later one move to the
// survivor. At the end of an open track its segment and carts on it go too. A closed track of 2 knots becomes open,
// without segments and carts. Whole turns add up, within kMaxTurns.
void remove_knot(Document& document, Entity knot);

// Closing adds a segment from the last knot to the first (needs 2 knots, else no effect); opening removes that segment,
// and carts that start on it start at the beginning of the track instead.
void set_closed(Document& document, bool closed);

// Turns the direction of travel round; the shape of every segment stays to the bit, and so do names. A closed track
// goes on beginning at its first knot. Carts keep segment and fraction: where they are then is the caller's to say.
void reverse(Document& document);

// Closes an open track of 3 knots or more by making its last knot the first: the last segment ends there, no segment is
// added. False, and nothing changed, for others.
bool weld_ends(Document& document);

// Recomputes the knots whose joint is automatic, and makes lengths of smooth joints equal (the outgoing one wins: who
// edits the incoming one sets both). Idempotent to the bit. Linear in the track's length, 20 ns a knot.
void settle_joints(Document& document);

// The automatic shape between the positions of the neighbours (null where there is none): as Catmull-Rom along the
// chord between them (or to the only one), a third of each side's chord, within kMinHandle..kMaxHandle. A chord of no
// length keeps the direction.
void shape_between(Knot& knot, const glm::vec3* before, const glm::vec3* after);

// Sets the tangent (normalised here; shorter than 1e-9 m or not finite: ignored) and turns `up` with it by the least
// rotation.
void set_tangent(Knot& knot, glm::vec3 direction);
// Roll about the tangent in degrees from the horizon: 0 has `up` as near to +Y as can be (for a vertical tangent: to a
// fixed horizontal reference). Positive rolls to the right as seen by the rider.
double roll_deg(const Knot& knot);
void set_roll(Knot& knot, double roll_deg);

// Unit and perpendicular again, in double, rounded once; keeps the bits of what already is, to 1e-6.
void orthonormalise(Knot& knot);

}  // namespace coaster::world
