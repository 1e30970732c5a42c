// What follows a change of the document: everything that must hold again afterwards. Private to this room.
#pragma once

#include <vector>

#include "edit/perform/perform_context.h"
#include "world/sections.h"

namespace coaster::edit {

// The planned sections of a document: all but the free ones.
struct PlannedSection {
  world::SectionRun run;
  world::Section value;
};
std::vector<PlannedSection> planned_sections(const world::Document& document);

// Makes joints, free sections, turns, spins, derived data, trains, force sections and selection consistent with a
// document that a command has just changed; change_propagation.cpp says in which order, and why. `before` are the
// planned sections before the command; session.derived must still belong to the document of that time. A planned
// section that the command shaped by hand becomes free, with a sentence in the command's note. One that moved as a
// whole, by a translation and a rotation about the vertical, keeps its plan; so does one whose first and last knot
// changed only on the neighbour's side or in their spin, which belong to both.
void follow_change(Session& session, Change& change, const std::vector<PlannedSection>& before);

// Call before the whole document is replaced by `next` (undo, redo, cancel): trains on segments that differ keep their
// distance from the start, by `derived` of the present document.
void follow_by_distance(const world::Document& present, const world::Document& next, const sim::DerivedTrack& derived,
                        world::Motion& motion);

// Puts trains on the track as derived, and drops from the selection what no longer exists.
void settle_trains(Session& session);

}  // namespace coaster::edit
