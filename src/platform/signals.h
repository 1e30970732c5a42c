// Being told to end by the system: SIGTERM, SIGINT (Ctrl+C) and SIGHUP (its terminal is gone).
#pragma once

namespace coaster::platform {

// From now on these set a flag and nothing else; the second one of a kind ends the program at once, as it would without
// this.
void watch_signals();

// The signal that came, 0 when none did. The flag stays.
int pending_signal();

}  // namespace coaster::platform
