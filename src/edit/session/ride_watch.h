// Watches rides for their end, and has challenges judged then. Private to this room but for what session.h declares.
#pragma once

#include "edit/session/session.h"

namespace coaster::edit {

// The train sets off: from its start, or from where it was held.
void watch_start(Session& session, bool from_start);
// It was put elsewhere by hand: the ride is not one from the start any more.
void watch_disturbed(Session& session);
// It was put back to its start: nothing is under way.
void watch_reset(Session& session);
// Ticks have passed. Their number may be any: without a challenge a lap is noticed after the last of them.
void watch_ticks(Session& session, int ticks);
// The document or its settings have changed: challenges that are judged by what is built are judged.
void watch_built(Session& session);

}  // namespace coaster::edit
