// Carries out a command: the only way to change a session.
#pragma once

#include "edit/session/session.h"

namespace coaster::edit {

struct ClosingSearch;

// Checks first, changes nothing on error. On success document, settings, motion, derived and history are consistent
// again (derive and reconcile have run). Numbers beyond the limits are clamped with a warning notice that contains the
// word "limit"; impossible commands (unknown names, over the vertex budget, too short handles) are refused with
// Code::refused, file errors are passed on, and each error shows an error notice. A document command outside a gesture
// is one undo step; a command that does not change the document adds none. undo inside a gesture cancels it.
// If the job of this thread is cancelled meanwhile, it returns an error without a notice, and the session is as before
// once settle() is called; or the command is done, if the old state was gone already.
// `search` lets another thread search for it, before or after (edit/perform/job_result.h).
base::Status apply(Session& session, base::Files& files, const Command& command, ClosingSearch* search = nullptr);

// Restores what depends on the document after a cancelled apply().
void settle(Session& session);

}  // namespace coaster::edit
