// Adds planned track at the open end. Private to this room.
#pragma once

#include "edit/perform/perform.h"
#include "sim/plan/elements.h"
#include "sim/plan/force_plan.h"

namespace coaster::edit {

// Starts track with that first knot at the open end: the end keeps its position, direction and roll, and its outgoing
// handle becomes the knot's. An empty track gets the knot.
void open_out(world::Document& document, const world::Knot& start);
// Adds a plan at the open end as a section, and returns the section.
world::Entity place(world::Document& document, const sim::ElementPlan& plan);
// Puts the plan's equipment, if it has any, on its segments, from that index of the track.
void equip(world::Document& document, const sim::ElementPlan& plan, std::size_t first);
// Does the same for a force section.
world::Entity place_force(world::Document& document, const sim::ForcePlan& plan);
// Warns of the largest difference from the keys if it is over the tolerance.
void report_missed(const sim::ForcePlan& plan, Change& change);
// Reports what was placed, or else its warnings.
void report_forces(const sim::ForcePlan& plan, Change& change);
// Plans a program at the open end for the speed there and adds it.
base::Status add_force(Session& session, Change& change, world::ForceProgram program);
// Adds a train at the start of a track without one, so that there is something to watch.
void add_first_train(world::Document& document);

}  // namespace coaster::edit
