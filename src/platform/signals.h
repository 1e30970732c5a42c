// Requests by the system to end: SIGTERM, SIGINT (Ctrl+C), SIGHUP (the terminal closed), SIGQUIT (Ctrl+\), SIGUSR1 and
// SIGUSR2 (batch systems, before the end), SIGPWR (the power fails), SIGPIPE (the reader of the output has exited) and
// SIGXCPU (over the limit of processor time).
#pragma once

namespace coaster::platform {

// Makes these signals only set a flag from now on; a second signal of the same kind ends the program at once, with the
// default action, but any number of SIGPIPE and SIGXCPU only sets the flag. Signals that the program was started to
// ignore, as nohup does with SIGHUP, stay ignored. If nothing asks for the flag within 0.7 s, or the program has not
// ended 0.7 s after that, it is in one long step: it ends as by a crash, with exit code 128 + the signal
// (base/crash_guard.h).
void watch_signals();

// Returns the signal received, 0 if none. The flag stays set. Who asks ends the program.
int pending_signal();

}  // namespace coaster::platform
