// Opening a file that takes longer than a frame, in a thread beside the frames, which show how far it is. In a window
// alone: scripts wait, unless they ask for a slow import to see that.
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
  int frames_left = 0;  // of a slow one, before it is looked at
  bool slow = false;
  base::Progress progress;
  std::future<base::Result<exchange::LoadedTrack>> result;
  ~ImportJob() { progress.cancelled = true; }  // the future waits for the thread
};

// Begins to open the file of a load by hand, where its format may take long; false for every other command.
bool begin_import(Program& program, const edit::Command& command);

// What panels show of it; null while it has not taken long yet.
const base::Progress* shown_import(const Program& program);

// Once a frame: opens the track when the thread has read it, or says why it could not.
void finish_import(Program& program);

}  // namespace coaster::app
