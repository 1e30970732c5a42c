// The tools that a challenge locks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edit/session/session.h"

namespace coaster::edit {

// True if the session's challenge refuses commands of that name.
bool is_locked(const Session& session, std::string_view command);

// Returns "Locked in this challenge: Equipment, Losses.": the commands by the labels of their buttons, each once.
std::string locked_text(const std::vector<std::string>& commands);

}  // namespace coaster::edit
