// Plans sections again and carries what follows along. Private to this room.
#pragma once

#include "edit/perform/perform.h"
#include "sim/plan/carry.h"
#include "sim/plan/elements.h"

namespace coaster::edit {

// Plans a section of `document` as an element from where it begins and shapes its knots so. The knot that follows moves
// to its new end, and everything behind it with carry_after(). Knots and segments keep their names where their number
// stays. Changes nothing on failure, or else `document` is unusable. Adds what was clamped to `change`.
base::Status replan(const Session& session, Change& change, world::Document& document, world::Entity section,
                    const world::Element& as);

// Makes `next` the session's document; refused where track would leave the world.
base::Status adopt(Session& session, world::Document&& next);

// Carries all knots behind that index along. On a closed track nothing may move.
base::Status carry_after(world::Document& document, std::size_t knot, const sim::Carry& carry);

}  // namespace coaster::edit
