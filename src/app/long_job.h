// Commands that take longer than a frame. Imports, searches, and changes of a circuit, whose way home is planned again,
// begin beside the frames, with a progress bar; the frames wait for all others, and Cancel ends those that take long.
// Only in a window: scripts wait, unless they request a slow one to test the bar.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/beside.h"
#include "edit/commands/command.h"
#include "platform/events.h"
#include "sim/study/way_change.h"

namespace coaster::edit {
struct Search;
}

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

  // Only of a change of a circuit.
  std::optional<sim::WayChange> way;         // what is searched for
  std::unique_ptr<sim::OpenedTrack> opened;  // taken from the session's findings meanwhile
  bool in_gesture = false;                   // a drag: has no bar, and takes some ms a move
  std::vector<edit::Command> rest;           // later commands of the same frame

  std::unique_ptr<Beside> work;  // declared last: it ends before what it reads
};

// Applies commands of the user in their order. While a job goes on, those that would lose its result are left out.
void apply_by_hand(Program& program, const std::vector<edit::Command>& commands);

// Applies a command to the session. One of the user in a window may be cancelled: when it takes longer than a moment, a
// card shows over the last picture, and nothing else happens until it ends, neither ticks nor other input. A cancelled
// one changes nothing.
base::Status apply_watched(Program& program, const edit::Command& command, edit::Search* search);

// Starts an import or a search of the user in a thread; returns false for every other command.
bool begin_job(Program& program, const edit::Command& command);

// Returns the input for the panels. While a changed circuit's way home is planned and no bar shows, input is held back:
// it is for the track as it will be.
platform::Events take_input(Program& program, const platform::Events& events);

// Returns the job for the panels; null until it has taken long enough to show.
const LongJob* shown_job(const Program& program);

// Once per frame: carries out the command when what it needs is found, or reports the error.
void finish_job(Program& program);

}  // namespace coaster::app
