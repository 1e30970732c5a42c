// Plans sections again and moves the track that follows along. Private to this room.
#pragma once

#include "edit/perform/perform.h"
#include "sim/plan/carry.h"
#include "sim/plan/elements.h"
#include "world/sections.h"

namespace coaster::edit {

// Returns the knot with that index; after the last one of a closed track comes the first.
inline const world::Knot& nth_knot(const world::Document& document, std::size_t index) {
  const auto& knots = document.track.knots;
  return world::knot(document, knots[index % knots.size()]);
}

// Plans a section of `document` as an element from its start and gives its knots that shape. The knot that follows
// moves to its new end, and everything after it with carry_after(). Knots and segments keep their names if their number
// stays the same. Changes nothing on failure, except that `document` is unusable then. Adds the clamped values to
// `change`.
enum class Following : std::uint8_t { moves, planned };  // planned: as after a force section (force_replan.h)
base::Status replan(Session& session, Change& change, world::Document& document, world::Entity section,
                    const world::Element& as, Following following = Following::moves);

// Refused if a section of that many spans would exceed the limits.
base::Status room_for_spans(const Session& session, const world::Document& document, const world::SectionRun& run,
                            std::size_t spans);
// Gives a section the shape of a fit and moves the track that follows along. Refused if that does not fit its new end.
base::Status put_in_place(world::Document& document, const world::SectionRun& run, const sim::ElementFit& fit);

// Makes `next`, which was made from `former`, the session's document. On a closed track the section that completes the
// circuit adapts to what moved before it (take_up.h). Refused if it cannot, and if track would leave the limits of
// coordinates. Warns where knots go further below the ground than before, unless the change has another warning.
base::Status adopt(Session& session, Change& change, const world::Document& former, world::Document&& next);

// Refused on a closed track if no section at or after that knot completes the circuit.
base::Status may_move(const world::Document& document, std::size_t knot);
// Moves all knots after that index along; on a closed track those up to the start of the section that completes the
// circuit. Refused as may_move() is.
base::Status carry_after(world::Document& document, std::size_t knot, const sim::Carry& carry);

// Returns consecutive segments as an open track, with their equipment; on a closed track also across its first knot.
world::Document stretch_of(const world::Document& document, std::size_t first, std::size_t count);

// The last knot of a reshaped section: nothing follows it; or it moves with the track that follows; or it stays exactly
// the same except for its incoming handle.
enum class SectionEnd : std::uint8_t { open, moves, stays };
// Gives a section the shape of a fit. Knots and segments keep their names if their number stays the same, and trains at
// their start positions their share of its length.
void reshape(world::Document& document, world::Entity section, const sim::ElementFit& fit, SectionEnd end);

}  // namespace coaster::edit
