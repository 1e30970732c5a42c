// Watches the live ride: detects its end, and has challenges judged then or while building.
#pragma once

#include "edit/session/session.h"

namespace coaster::edit {

// Call when the train starts: from its start, or from where it was held.
void watch_start(Session& session, bool from_start);
// Call when the train was moved by hand: the ride no longer counts as one from the start.
void watch_disturbed(Session& session);
// Call when the train was reset: no ride is in progress.
void watch_reset(Session& session);
// Call after any number of ticks. Without a challenge a lap is detected after the last of them.
void watch_ticks(Session& session, int ticks);
// Call when the document or its settings have changed: judges challenges that are judged while building.
void watch_built(Session& session);

}  // namespace coaster::edit
