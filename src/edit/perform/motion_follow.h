// Keeps moving trains at their positions on the rails while segments are added and removed. Only positions:
// sim::reconcile, which runs afterwards, handles energies and the rest.
#pragma once

#include "edit/perform/perform.h"

namespace coaster::edit {

// Call after a split, a merge or a reversal, once the new shapes are derived.
void follow(const MotionFollowUp& change, const world::Document& document, const sim::Derived& derived,
            world::Motion& motion);

// Call before the whole document is replaced by `next` (undo, redo, cancel): trains on segments that differ keep their
// distance from the start, by `derived` of the present document.
void follow_by_distance(const world::Document& present, const world::Document& next, const sim::Derived& derived,
                        world::Motion& motion);

}  // namespace coaster::edit
