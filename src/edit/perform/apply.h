// Carrying out a command: the only way to change a session.
#pragma once

#include "edit/session/session.h"

namespace coaster::edit {

// Checks first, changes nothing on error. On success document, settings, motion, derived and history are consistent
// again (derive and reconcile have run). Numbers beyond the limits are clamped with a warning notice that contains the
// word "limit"; what cannot be done (unknown names, over the vertex budget, too short handles) is refused with
// Code::refused, file errors pass through, and either way an error notice is shown. A document command outside a
// gesture is one step of undo; a command that leaves the document equal adds none. undo inside a gesture cancels it.
base::Status apply(Session& session, base::Files& files, const Command& command);

}  // namespace coaster::edit
