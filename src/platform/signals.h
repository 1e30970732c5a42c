// Requests by the system to end: SIGTERM, SIGINT (Ctrl+C) and SIGHUP (the terminal closed).
#pragma once

namespace coaster::platform {

// Makes these signals only set a flag from now on; a second signal of the same kind ends the program at once, with the
// default action.
void watch_signals();

// Returns the signal received, 0 if none. The flag stays set.
int pending_signal();

}  // namespace coaster::platform
