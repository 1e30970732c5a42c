// Searches for numbers of the track for which a query has a given value.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "edit/commands/commands_seek.h"
#include "edit/session/session.h"

namespace coaster::edit {

// Returns why the command's `by` names no number of what `of` names, with the nearest word; nothing if it may. Whether
// a section of that name has the number depends on the track.
std::optional<std::string> wrong_by(const Seek& command);

using Search = std::function<base::Result<Sought>()>;

// Prepares a search on a copy of the session; calling the result once, in any thread, runs it. Refused then if the goal
// cannot be parsed or measured, if nothing that could change is named, or if the goal is not reached. The same bits
// everywhere. A trial costs a ride, some milliseconds; at most 400, and ten for each number.
Search search_for(const Session& session, const Seek& command);

}  // namespace coaster::edit
