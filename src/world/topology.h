// The only functions that add, remove or reorder knots, segments, sections and trains. They keep every invariant of
// Document: a new segment at the track's end extends the last section if that is free, else it begins a new one; both
// halves of a segment stay in its section; a section without segments is removed. They do no undo and no checks of user
// input (edit/perform/apply.cpp does).
#pragma once

#include <string_view>

#include "world/document.h"

namespace coaster::world {

// Why nothing can be added at the end of a closed track.
inline constexpr std::string_view kClosedTrack = "the track is closed: open it first (Closed in the Track panel)";

// New entities get the next number of their kind.
Entity add_cart(Document& document, Entity segment, double fraction);

// Appends a knot to an open track, and a segment to it if there is a knot before it.
Entity append_knot(Document& document, const Knot& knot);

struct SplitResult {
  Entity knot;           // the new knot, joint aligned
  Entity first, second;  // `first` is the split segment; `second` is new and follows it
};
// Splits at t in (0,1) by de Casteljau without changing the shape (to float rounding): the knots at both ends become
// aligned and get the scaled handle lengths (Paper erratum: the split scales the parametric speed, so uniform C1
// becomes G1). The caller passes `up` and `spin` (rad/m) of the segment's frame at t. Trains keep their start
// positions. If a handle would leave kMinHandle..kMaxHandle, or a knot kMaxCoordinate, nothing changes and knot is
// kNone. `turns` stay with the first segment: sim, which knows the twist, distributes them.
SplitResult split_segment(Document& document, Entity segment, double t, glm::vec3 up, float spin = 0);

// Removes a knot; its two segments become one (the earlier one survives); trains of the later one move to the survivor.
// At the end of an open track its segment and the trains on it are removed. A closed track of 2 knots becomes open,
// without segments and trains. Whole turns add up, within kMaxTurns.
void remove_knot(Document& document, Entity knot);

// Closing adds a segment from the last knot to the first (needs 2 knots, else no effect). Opening removes that segment;
// trains that start on it start at the beginning of the track instead.
void set_closed(Document& document, bool closed);

// Reverses the direction of travel; the shape of every segment stays exactly the same, and so do names. A closed track
// still begins at its first knot. Trains keep segment and fraction; the caller must reposition them.
void reverse(Document& document);

// Closes an open track of 3 knots or more by merging its last knot into the first: the last segment ends there, no
// segment is added. Returns false and changes nothing for other tracks.
bool weld_ends(Document& document);

// Makes `count` segments from index `first` one section. It keeps the name of the first section that is entirely among
// them. If parts of a section remain on both sides, they become two: the part after them is a new free one.
Entity make_section(Document& document, std::size_t first, std::size_t count, Section value);

// Changes the number of a section's segments. Knots and segments are added and removed before its last knot; new ones
// have that knot's values and the fittings of the segment before them. The caller shapes the knots, and sets turns and
// the places of trains.
void resize_section(Document& document, Entity section, std::size_t count);

// Removes a section, the trains on it, and its knots except the first; for the track's first section its knots except
// the last. Swaps a section with the next. The caller moves the knots that follow. Neither accepts the last section of
// a closed track.
void remove_section(Document& document, Entity section);
void swap_sections(Document& document, Entity section);

// Recomputes knots with automatic joints, and equalises handle lengths of smooth joints (the outgoing one wins: an edit
// of the incoming one must set both). Exactly idempotent. Linear in the track's length, 20 ns per knot.
void settle_joints(Document& document);

// Computes the automatic shape between the positions of the neighbours (null if there is none): as Catmull-Rom along
// the chord between them (or to the only one), a third of each side's chord, within kMinHandle..kMaxHandle. A chord of
// zero length keeps the direction.
void shape_between(Knot& knot, const glm::vec3* before, const glm::vec3* after);

// Sets the tangent (normalised here; ignored if shorter than 1e-9 m or not finite) and turns `up` with it by the least
// rotation.
void set_tangent(Knot& knot, glm::vec3 direction);
// Roll about the tangent in degrees from the horizon: at 0 `up` is as near to +Y as possible (for a vertical tangent:
// to a fixed horizontal reference). Positive rolls to the rider's right.
double roll_deg(const Knot& knot);
void set_roll(Knot& knot, double roll_deg);

// Makes the axes unit and perpendicular, in double, rounded once; keeps the bits of axes that already are, to 1e-6.
void orthonormalise(Knot& knot);

}  // namespace coaster::world
