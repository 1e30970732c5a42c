// The user's data besides the document: settings, autosaves, the lock on the document's file. Null in a Program that
// keeps nothing: pictures without a window, and scripts unless they request it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/system_dialog.h"
#include "base/file_lock.h"
#include "base/folders.h"
#include "exchange/own/autosave.h"
#include "ui/context/output.h"
#include "ui/context/state.h"

namespace coaster::app {

struct Program;

struct Keeper {
  base::Files files;               // of what it keeps, not of the document
  base::UserFolders folders;       // settings.json is in config, autosaves in state/recovery
  ui::UserState state;             // shown by panels; its settings are the present ones
  exchange::UserSettings written;  // as in the file
  exchange::UserSettings seen;     // in the previous frame
  double seen_since = 0;           // s
  bool may_write = true;           // false: there is a file that could be neither read nor renamed
  base::FileLock lock;             // on the document's file
  base::FileLock next_lock;        // on the target file of a save in progress
  bool unasked = false;            // the document being opened was not named by the user
  exchange::Autosave autosave;
  std::uint64_t autosaved = 0;                            // hash of the document in it
  double unsaved_since = -1;                              // s; -1: no changes since the file or the autosave
  bool autosave_failed = false, settings_failed = false;  // already reported
  std::vector<exchange::FoundAutosave> found;             // of state.recoveries, in its order
  exchange::Progress progress_written;                    // as in the file
  bool may_write_progress = true, progress_failed = false;
  SystemDialogProcess dialog;
};

// Reads the settings and makes them those of the session and the panels, and looks for autosaves that other runs left.
// What is wrong with the settings is told in one notice; a file that is none is renamed to settings.json.bad. It writes
// below `root`, with the program's faults. `default_layout`: forgets panels, scale and the window's place.
void start_keeping(Program& program, const base::UserFolders& folders, const base::Root& root, bool default_layout);

// Writes what has changed. `clean`: the user quit, so the autosave is removed; otherwise it stays for the next start.
void stop_keeping(Program& program, bool clean);

// What the panels asked for: other settings, a new folder, the answer about an autosave, the desktop's file dialog.
void answer_keeping(Program& program, const ui::Output& output);
// At the end of each frame: settings and medals that changed, the autosave when it is time.
void keep(Program& program);

// The lock on the document's file (keeper_lock.cpp). Before a command: refuses to save to a file that another program
// has open. After it: moves the lock to the document's file, and updates recent files.
base::Status before_command(Program& program, const edit::Command& command);
void after_command(Program& program, const edit::Command& command, const base::Status& applied);

// Autosaves unsaved changes now. Ok if there are none, or nothing is kept.
base::Status autosave_now(Program& program);

}  // namespace coaster::app
