// Commands that take longer than a frame, an import and a search, begin beside the frames, with a progress bar. Only in
// a window: scripts wait, unless they request a slow one to test the bar.
#pragma once

#include <string>

#include "app/beside.h"
#include "edit/commands/command.h"

namespace coaster::app {

struct Program;

struct LongJob {
  edit::Command command;
  std::string panel, title;  // of its card: "Import", "Fitting a track to the imported points"
  std::string cancelled;     // the notice after Cancel
  double since = 0;          // s, as Program::seconds
  std::uint64_t edits = 0;   // Session::edits at its start
  int frames_left = 0;       // delay of a slow job before its result is used
  bool slow = false;
  std::unique_ptr<Beside> work;
};

// Starts a command of the user in a thread if it may take long; returns false for every other command.
bool begin_job(Program& program, const edit::Command& command);

// Returns the job for the panels; null until it has taken long enough to show.
const LongJob* shown_job(const Program& program);

// Once per frame: carries out the command when what it needs is found, or reports the error.
void finish_job(Program& program);

}  // namespace coaster::app
