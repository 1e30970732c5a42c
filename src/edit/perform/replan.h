// Plans sections again and moves the track that follows along. Private to this room.
#pragma once

#include "edit/perform/perform_context.h"
#include "sim/plan/element_plan.h"
#include "sim/plan/force_plan.h"
#include "sim/plan/upright_move.h"
#include "world/sections.h"

namespace coaster::edit {

// True if track follows a run: other sections, or those before it on a closed track.
inline bool is_followed(const world::Document& document, const world::SectionRun& run) {
  return document.track.closed || run.end() < document.track.segments.size();
}

// Plans a section of `document` as an element from its start and gives its knots that shape. The knot that follows
// moves to its new end, and everything after it with carry_after(). Knots and segments keep their names if their number
// stays the same. Changes nothing on failure, except that `document` is unusable then. Adds the clamped values to
// `change`.
enum class FollowingTrack : std::uint8_t { moves, planned };  // planned: as after a force section (put_and_follow)
base::Status replan_element(Session& session, Change& change, world::Document& document, world::Entity section,
                            const world::Element& as, FollowingTrack following = FollowingTrack::moves);

// Refused if a section of that many spans would exceed the limits.
base::Status room_for_spans(const Session& session, const world::Document& document, const world::SectionRun& run,
                            std::size_t spans);
// Gives a section the shape of a fit and moves the track that follows along. Refused if that does not fit its new end.
base::Status put_in_place(world::Document& document, const world::SectionRun& run, const sim::ElementFit& fit);

// Makes `next`, which was made from `former`, the session's document. On a closed track the section that completes the
// circuit adapts to what moved before it (keep_closed). Refused if it cannot, and if track would leave the limits of
// coordinates. Warns where knots go further below the ground, or on a land under its water, than before, unless the
// change has another warning.
base::Status adopt(Session& session, Change& change, const world::Document& former, world::Document&& next);

// Returns "The track goes 1.5 m below the ground.", or, on a land, under water; `depth` in m.
std::string depth_text(std::string_view what, double depth, const world::Document& document);

// Refused on a closed track if no section at or after that knot completes the circuit.
base::Status may_move(const world::Document& document, std::size_t knot);
// Moves all knots after that index along; on a closed track those up to the start of the section that completes the
// circuit. Refused as may_move() is.
base::Status carry_after(world::Document& document, std::size_t knot, const sim::UprightMove& carry);

// Returns consecutive segments as an open track, with their equipment; on a closed track also across its first knot.
world::Document stretch_of(const world::Document& document, std::size_t first, std::size_t count);

// The last knot of a reshaped section: nothing follows it; or it moves with the track that follows; or it stays exactly
// the same except for its incoming handle.
enum class SectionEnd : std::uint8_t { open, moves, stays };
// Gives a section the shape of a fit. Knots and segments keep their names if their number stays the same, and trains at
// their start positions their share of its length.
void reshape(world::Document& document, world::Entity section, const sim::ElementFit& fit, SectionEnd end);

// Plans a force section of `document` from its start by its program, and gives its knots that shape. Its end may point
// in any direction: a planned section that follows is planned again from there, and others move with it as after
// replan_element(). Changes nothing on failure, except that `document` is unusable then.
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

// Plans the last section of `next` that completes the circuit again, if its ends differ from those in `former`: as the
// way most similar to the former one; if that fails outside a gesture, as the best of all closing sections. It keeps
// the end exactly, and both joints are G2 with continuous spin. The speed is the former one, adjusted by the height
// that its start has gained or lost since, if no equipment lies between. Refused with the reason if there is no such
// way, and until it is found if the change has a ClosingSearch that leaves it to another thread.
base::Status keep_closed(Session& session, Change& change, const world::Document& former, world::Document& next);

// Starts track with that first knot at the open end: the end keeps its position, direction and roll, and its outgoing
// handle becomes the knot's. An empty track gets the knot.
void open_out(world::Document& document, const world::Knot& start);
// Adds knots at the open end, the first of which is there, as a section, and returns it.
world::Entity append_section(world::Document& document, const std::vector<world::Knot>& knots, world::Section section);
// Adds a plan at the open end as a section, and returns the section.
world::Entity place(world::Document& document, const sim::ElementPlan& plan);
// Puts the plan's equipment, if it has any, on its segments, from that index of the track.
void equip(world::Document& document, const sim::ElementPlan& plan, std::size_t first);
// Does the same for a force section.
world::Entity place_force(world::Document& document, const sim::ForcePlan& plan);
// Reports what was placed, or else its warnings.
void report_forces(const sim::ForcePlan& plan, Change& change);
// Plans a program at the open end for the speed there and adds it.
base::Status add_force(Session& session, Change& change, world::ForceProgram program);
// Adds a train at the start of a track without one, so that there is something to watch.
void add_first_train(world::Document& document);

}  // namespace coaster::edit
