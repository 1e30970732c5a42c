// Finds numbers of the track for which a query has a value.
#pragma once

#include <functional>

#include "base/progress.h"
#include "edit/commands/commands_seek.h"
#include "edit/session/session.h"

namespace coaster::edit {

using Search = std::function<base::Result<Sought>(base::Progress* progress)>;  // `progress` may be null

// Prepares a search on a copy of the session; calling the result once, in any thread, runs it. Then refused where the
// goal cannot be read or measured, where nothing is named that could change, or where the goal is not reached. The same
// bits everywhere. A trial costs a ride, some milliseconds; at most 400, and ten for each number.
Search search_for(const Session& session, const Seek& command);

}  // namespace coaster::edit
