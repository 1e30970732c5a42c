// A circuit stays closed while track before its last Complete circuit section moves. Private to this room.
#pragma once

#include "edit/perform/perform.h"

namespace coaster::edit {

// Plans the last section of `next` that completes the circuit again, if its ends are others than in `former`: as the
// way most like the former one; outside a gesture, where that fails, as the best of all ways home. It keeps the end to
// the bit, and both joints are G2 with continuous spin. The speed is the former one; what its start has gained or lost
// in height since counts where no equipment lies between. Refused with the reason where there is no such way.
base::Status take_up(Session& session, Change& change, const world::Document& former, world::Document& next);

}  // namespace coaster::edit
