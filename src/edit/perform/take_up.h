// Keeps a circuit closed while track before its last Complete circuit section moves. Private to this room.
#pragma once

#include "edit/perform/perform.h"

namespace coaster::edit {

// Plans the last section of `next` that completes the circuit again, if its ends differ from those in `former`: as the
// way most similar to the former one; if that fails outside a gesture, as the best of all ways home. It keeps the end
// exactly, and both joints are G2 with continuous spin. The speed is the former one, adjusted by the height that its
// start has gained or lost since, if no equipment lies between. Refused with the reason if there is no such way, and
// until it is found if WaySearch::beside is set.
base::Status take_up(Session& session, Change& change, const world::Document& former, world::Document& next);

}  // namespace coaster::edit
