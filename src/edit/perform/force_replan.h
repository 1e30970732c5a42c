// Plans force sections again after a change of their keys or of the train's speed. Private to this room.
#pragma once

#include "edit/perform/perform.h"
#include "sim/plan/force_plan.h"

namespace coaster::edit {

// Plans a force section of `document` from its start by its program, and gives its knots that shape. Its end may point
// in any direction: a planned section that follows is planned again from there, and others move with it as after
// replan(). Changes nothing on failure, except that `document` is unusable then.
base::Status replan_force(Session& session, Change& change, world::Document& document, world::Entity section);

// Gives a section the shape of a fit. A planned section that follows is planned again if the new end has another
// direction or curvature, and so on; other track moves along if it fits the end (put_in_place). What the train gains at
// a force section it still has at the next one (Change::gained), so that follow_speeds() rarely plans that again.
base::Status put_and_follow(Session& session, Change& change, world::Document& document, const world::SectionRun& run,
                            const sim::ElementFit& fit);

// Gives a force section another program and plans it again, with what follows; refused if it cannot be planned.
base::Status change_forces(Session& session, Change& change, world::Entity section, const world::ForceProgram& to);

// Plans each force section of the session's document again whose plan would differ: because its train is faster or
// slower, or because its start changed. One that cannot be planned keeps its shape, with a warning. Needs up-to-date
// derived data; returns true if it changed the document, which makes them out of date.
bool follow_speeds(Session& session, Change& change);

}  // namespace coaster::edit
