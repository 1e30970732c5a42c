// Plans sections again and carries what follows along. Private to this room.
#pragma once

#include "edit/perform/perform.h"
#include "sim/plan/carry.h"
#include "sim/plan/elements.h"
#include "world/sections.h"

namespace coaster::edit {

// Returns the knot with that index; behind the last one of a closed track comes the first.
inline const world::Knot& nth_knot(const world::Document& document, std::size_t index) {
  const auto& knots = document.track.knots;
  return world::knot(document, knots[index % knots.size()]);
}

// Plans a section of `document` as an element from where it begins and shapes its knots so. The knot that follows moves
// to its new end, and everything behind it with carry_after(). Knots and segments keep their names where their number
// stays. Changes nothing on failure, or else `document` is unusable. Adds what was clamped to `change`.
enum class Following : std::uint8_t { moves, planned };  // planned: as behind a force section (force_replan.h)
base::Status replan(Session& session, Change& change, world::Document& document, world::Entity section,
                    const world::Element& as, Following following = Following::moves);

// Refused if there is no room for a section of that many spans.
base::Status room_for_spans(const Session& session, const world::Document& document, const world::SectionRun& run,
                            std::size_t spans);
// Gives a section the shape of a fit and carries what follows along. Refused where that does not fit its new end.
base::Status put_in_place(world::Document& document, const world::SectionRun& run, const sim::ElementFit& fit);

// Makes `next`, which was made from `former`, the session's document. On a closed track the section that completes the
// circuit takes up what moved before it (take_up.h). Refused where it cannot, and where track would leave the world.
base::Status adopt(Session& session, Change& change, const world::Document& former, world::Document&& next);

// Refused on a closed track where no section that begins at that knot or behind it completes the circuit.
base::Status may_move(const world::Document& document, std::size_t knot);
// Carries all knots behind that index along; on a closed track those up to the start of the section that completes the
// circuit. Refused as may_move() is.
base::Status carry_after(world::Document& document, std::size_t knot, const sim::Carry& carry);

// Returns neighbouring segments as an open track of their own, with their equipment; on a closed track also beyond its
// first knot.
world::Document stretch_of(const world::Document& document, std::size_t first, std::size_t count);

// What the last knot of a section that is shaped again does: nothing follows it, it moves with what follows, or it
// stays to the bit but for its incoming handle.
enum class SectionEnd : std::uint8_t { open, moves, stays };
// Gives a section the shape of a fit. Knots and segments keep their names where their number stays, and trains as
// designed their share of its length.
void reshape(world::Document& document, world::Entity section, const sim::ElementFit& fit, SectionEnd end);

}  // namespace coaster::edit
