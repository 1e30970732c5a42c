// Commands that take longer than a frame. Imports, searches, and changes of a circuit, whose closing section is planned
// again, begin beside the frames, with a progress bar: in a thread; in a page in a worker, which has a copy of the
// page's memory. The frames wait for all others, and Cancel ends those that take long. Only in a window: scripts wait,
// unless they request a slow one to test the bar.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/cancellable_job.h"
#include "edit/commands/command.h"
#include "edit/perform/job_result.h"
#include "platform/events.h"

namespace coaster::edit {
struct ClosingSearch;
}

namespace coaster::app {

// What a long job finds for the command that follows it: a file's track, the values of a search, or a closing section.
// Also as text, in which a page's worker hands it over.
using edit::JobResult;

// parse_job_result(print_job_result(f)) equals f: documents by hash, numbers exactly. Of a closing section only what a
// command needs: not the figures of its fit. Tracks have no SharedView: links are read at once.
std::string print_job_result(const base::Result<JobResult>& found);

// Code::io for a text that print_job_result() does not print.
base::Result<JobResult> parse_job_result(std::string_view text);

// Work beside the frames: in a thread; in a page in a worker.
class BackgroundWork {
 public:
  using Work = std::function<base::Result<JobResult>()>;

  // Begins. `file` is what the work reads; empty: nothing. Where a page has no worker, take() does the work.
  BackgroundWork(Work work, const std::string& file);
  ~BackgroundWork();  // cancels; waits for a thread
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  // True if beginning takes less than a millisecond: a worker gets a copy of the page's memory first.
  static bool is_quick();
  bool done();                     // without waiting: take() returns at once, or does the work
  base::Result<JobResult> take();  // once; waits for a thread

  base::JobProgress progress;

 private:
  std::unique_ptr<Work> work_;  // of a page
  bool in_worker_ = false;      // of a page
  std::future<base::Result<JobResult>> result_;
};

// Does the work, which `progress` can cancel, and returns. It works in a thread, and after `patience` seconds calls
// `meanwhile` some times a second until it is done. A page has no threads: there it only does the work.
void watch_work(const std::function<void()>& work, base::JobProgress& progress, double patience,
                const std::function<void()>& meanwhile);

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
  std::optional<sim::ClosingReplanTask> closing;  // what is searched for
  std::unique_ptr<sim::OpenedTrack> opened;       // taken from the session's findings meanwhile
  bool in_gesture = false;                        // a drag: has no bar, and takes some ms a move
  std::vector<edit::Command> rest;                // later commands of the same frame

  std::unique_ptr<BackgroundWork> work;  // declared last: it ends before what it reads
};

// Applies commands of the user in their order. While a job goes on, those that would lose its result are left out.
void apply_by_hand(Program& program, const std::vector<edit::Command>& commands);

// Applies a command to the session. One of the user in a window may be cancelled: when it takes longer than a moment, a
// card shows over the last picture, and nothing else happens until it ends, neither ticks nor other input. A cancelled
// one changes nothing.
base::Status apply_watched(Program& program, const edit::Command& command, edit::ClosingSearch* search);

// Starts an import or a search of the user in a thread; returns false for every other command.
bool begin_job(Program& program, const edit::Command& command);

// Returns the input for the panels. While a changed circuit's closing section is planned and no bar shows, input is
// held back: it is for the track as it will be.
platform::Events take_input(Program& program, const platform::Events& events);

// Returns the job for the panels; null until it has taken long enough to show.
const LongJob* shown_job(const Program& program);

// Once per frame: carries out the command when what it needs is found, or reports the error.
void finish_job(Program& program);

}  // namespace coaster::app
