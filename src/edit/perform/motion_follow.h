// Keeps carts in motion at their place on the rails while segments come and go under them. Places alone: energies and
// everything else are sim::reconcile's, which runs afterwards.
#pragma once

#include "edit/perform/perform.h"

namespace coaster::edit {

// After a split, a merge or a reversal, once the new shapes are derived.
void follow(const MotionFollowUp& change, const world::Document& document, const sim::Derived& derived,
            world::Motion& motion);

// Before the whole document is exchanged for `next` (undo, redo, cancel): carts on segments that are not the same in
// both are left to their distance from the start, which `derived` (of the present document) tells.
void follow_by_distance(const world::Document& present, const world::Document& next, const sim::Derived& derived,
                        world::Motion& motion);

}  // namespace coaster::edit
