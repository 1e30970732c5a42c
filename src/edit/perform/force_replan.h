// Plans force sections again, after a change of their keys or of the train's speed. Private to this room.
#pragma once

#include "edit/perform/perform.h"
#include "sim/plan/force_plan.h"

namespace coaster::edit {

// Plans a force section of `document` from where it begins, by its program, and shapes its knots so. Its end may turn
// any way: a planned section that follows is planned again from there, and others move with it as after replan().
// Changes nothing on failure, or else `document` is unusable.
base::Status replan_force(Session& session, Change& change, world::Document& document, world::Entity section);

// Gives a section the shape of a fit. A planned section that follows is planned again where the new end turns or bends
// otherwise, and so on; other track moves along where it fits the end (put_in_place).
base::Status put_and_follow(Session& session, Change& change, world::Document& document, const world::SectionRun& run,
                            const sim::ElementFit& fit);

// Plans each force section of the session's document again that would be another one now: because its train is faster
// or slower, or the track begins it otherwise. One that cannot be planned keeps its shape, with a warning. Needs
// derived data that are the document's; returns whether it changed the document, and then they are no longer.
bool follow_speeds(Session& session, Change& change);

}  // namespace coaster::edit
