// Opens a file that takes longer than a frame in a thread, with a progress bar. Only in a window: scripts wait, unless
// they request a slow import to test the bar.
#pragma once

#include <future>
#include <memory>
#include <string>

#include "base/progress.h"
#include "edit/session/session.h"

namespace coaster::app {

struct Program;

struct ImportJob {
  std::string path;
  double since = 0;     // s, as Program::seconds
  int frames_left = 0;  // delay of a slow import before its result is used
  bool slow = false;
  base::Progress progress;
  std::future<base::Result<exchange::LoadedTrack>> result;
  ~ImportJob() { progress.cancelled = true; }  // the future waits for the thread
};

// Starts opening the file of a load by hand, if its format may take long; returns false for every other command.
bool begin_import(Program& program, const edit::Command& command);

// Returns the progress for the panels; null while the import has not taken long yet.
const base::Progress* shown_import(const Program& program);

// Once per frame: opens the track when the thread has read it, or reports the error.
void finish_import(Program& program);

}  // namespace coaster::app
