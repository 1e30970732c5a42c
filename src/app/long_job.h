// Commands that take longer than a frame, an import and a search, begin in a thread, with a progress bar; where there
// are no threads the bar stands still. Only in a window: scripts wait, unless they request a slow one to test the bar.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "base/progress.h"
#include "edit/session/session.h"

namespace coaster::app {

struct Program;

// Hands what a thread has found to the session, for the command that follows.
using HandOver = std::function<void(edit::Session&)>;

struct LongJob {
  edit::Command command;
  std::string panel, title;  // of its card: "Import", "Fitting a track to the imported points"
  std::string cancelled;     // the notice after Cancel
  double since = 0;          // s, as Program::seconds
  int frames_left = 0;       // delay of a slow job before its result is used
  bool slow = false;
  base::Progress progress;
  std::future<base::Result<HandOver>> result;
  ~LongJob() { progress.cancelled = true; }  // the future waits for the thread
};

// Starts a command given by hand, if it may take long; returns false for every other command.
bool begin_job(Program& program, const edit::Command& command);

// Returns the job for the panels; null while it has not taken long yet.
const LongJob* shown_job(const Program& program);

// Once per frame: carries out the command when the thread has found what it needs, or reports the error.
void finish_job(Program& program);

}  // namespace coaster::app
