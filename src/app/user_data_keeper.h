// Data that is kept besides the document: settings, autosaves, the lock on the document's file. Null in a Program that
// keeps nothing: pictures without a window, and scripts unless they request it.
#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <vector>

#include "app/process.h"
#include "base/file_lock.h"
#include "base/folders.h"
#include "exchange/own/autosave.h"
#include "ui/context/state.h"

namespace coaster::app {

struct Program;

// A copy of unsaved changes that is ready for a crash (base/crash_guard.h): printed in a thread, at most half a second
// and one print older than the document.
struct CrashCopy {
  std::future<void> printing;
  std::optional<std::uint64_t> edits;  // Session::edits of the newest copy, or of the newest try; nothing: no copy
  double since = 0;                    // of it, s by the surface's clock
};

struct UserDataKeeper {
  base::Files files;               // for the kept data, not for the document
  base::UserFolders folders;       // settings.json is in config, autosaves in state/recovery
  ui::UserState state;             // shown by panels; its settings are the current ones
  exchange::UserSettings written;  // settings in the file
  exchange::UserSettings seen;     // settings in the previous frame
  double seen_since = 0;           // s
  bool may_write = true;           // false: the existing file could be neither read nor renamed
  base::FileLock lock;             // on the document's file
  base::FileLock next_lock;        // on the target file of a save in progress
  bool unasked = false;            // the user did not name the document that is being opened
  exchange::Autosave autosave;
  CrashCopy crash_copy;
  std::uint64_t autosaved = 0;                            // hash of the document in the autosave
  double unsaved_since = -1;                              // s; -1: no changes since the file or the autosave
  bool autosave_failed = false, settings_failed = false;  // already reported
  std::vector<exchange::FoundAutosave> found;             // in the order of state.recoveries
  exchange::PlayerProgress progress_written;              // progress in the file
  bool may_write_progress = true, progress_failed = false;
  SystemDialogProcess dialog;
};

// Reads the settings, applies them to session and panels, and looks for autosaves left by other runs. Reports errors in
// the settings in one notice; a file that is not a settings file is renamed to settings.json.bad. Writes below `root`,
// with the program's injected faults. `default_layout`: discards the state of panels, the scale and the position of the
// window.
void start_keeping(Program& program, const base::UserFolders& folders, const base::FileRoot& root, bool default_layout);

// Writes what has changed. `clean`: the user quit, so the autosave is removed; otherwise it is kept for the next start.
void stop_keeping(Program& program, bool clean);

// Carries out the requests of the panels: new settings, a new folder, the answer about an autosave, the desktop's file
// dialog.
void answer_keeping(Program& program, const ui::Output& output);
// Writes changed settings and medals, and the autosave when it is due. Call it at the end of each frame.
void keep(Program& program);

// Update the lock on the document's file. Before a command: refuses to save to a file that another
// program has open. After it: moves the lock to the document's file, and updates recent files.
base::Status before_command(Program& program, const edit::Command& command);
void after_command(Program& program, const edit::Command& command, const base::Status& applied);

// Autosaves unsaved changes now. Ok if there are none, or if the program keeps no data.
base::Status autosave_now(Program& program);

}  // namespace coaster::app
