#include "app/long_job.h"

#include <chrono>
#include <utility>

#include "app/program.h"
#include "base/parallel.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_seek.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/seek.h"
#include "exchange/formats.h"

namespace coaster::app {
namespace {

constexpr double kBarAfter = 0.15;  // s: shorter jobs show no bar

using Work = std::function<base::Result<HandOver>(base::Progress*)>;

Work reading(const std::string& path) {
  return [path](base::Progress* progress) -> base::Result<HandOver> {
    base::Files files;
    base::Result<exchange::LoadedTrack> read = exchange::load_track(files, path, progress);
    if (!read) return read.status();
    return HandOver([path, track = std::move(*read)](edit::Session& to) {
      to.file.read_ahead = edit::ReadAhead{path, track};
    });
  };
}

Work searching(const edit::Session& session, const edit::Seek& command) {
  return [search = edit::search_for(session, command), text = edit::print(command),
          edits = session.edits](base::Progress* progress) -> base::Result<HandOver> {
    const base::Result<edit::Sought> found = search(progress);
    if (!found) return found.status();
    return HandOver([ahead = edit::SoughtAhead{text, edits, *found}](edit::Session& to) { to.sought = ahead; });
  };
}

// Returns what a thread can do for a command; nothing for most commands.
Work work_for(const Program& program, const edit::Command& command, LongJob& job) {
  if (const auto* const load = command.as<edit::Load>()) {
    const exchange::Format* const format = exchange::format_of(load->path);
    if (!format || !format->parse_watched) return {};
    job.panel = "Import", job.title = "Fitting a track to the imported points";
    job.cancelled = "Cancelled the import of " + load->path;
    return reading(load->path);
  }
  if (const auto* const seek = command.as<edit::Seek>()) {
    job.panel = "Search", job.title = "Searching for " + seek->goal.text;
    job.cancelled = "Cancelled the search";
    return searching(program.session, *seek);
  }
  return {};
}

}  // namespace

bool begin_job(Program& program, const edit::Command& command) {
  const bool slow = program.job_delay > 0;
  if (!program.by_hand || (!program.surface->is_window() && !slow) || program.job) return false;
  auto job = std::make_unique<LongJob>();
  Work work = work_for(program, command, *job);
  if (!work) return false;
  job->command = command, job->since = program.time.seconds;
  job->slow = slow, job->frames_left = std::exchange(program.job_delay, 0);
  job->result = std::async(base::beside(), std::move(work), &job->progress);
  program.job = std::move(job);
  return true;
}

const LongJob* shown_job(const Program& program) {
  const LongJob* const job = program.job.get();
  return job && (job->slow || program.time.seconds - job->since > kBarAfter) ? job : nullptr;
}

void finish_job(Program& program) {
  if (!program.job) return;
  LongJob& running = *program.job;
  if (running.slow) {
    // Counts frames only, however fast the thread is.
    if (!running.progress.cancelled && running.frames_left-- > 0) return;
    running.result.wait();
  }
  const std::future_status now = running.result.wait_for(std::chrono::seconds(0));
  if (now == std::future_status::timeout) return;
  // Without threads it is done here, once its bar has been seen.
  if (now == std::future_status::deferred && program.time.seconds - running.since < 2 * kBarAfter) return;
  const std::unique_ptr<LongJob> job = std::move(program.job);
  const base::Result<HandOver> found = job->result.get();
  // A cancelled job is dropped, even if the thread was faster.
  if (job->progress.cancelled) return edit::notify(program.session, edit::NoticeKind::info, job->cancelled);
  if (!found) return edit::notify(program.session, found.status());
  (*found)(program.session);
  (void)apply(program, job->command);
}

}  // namespace coaster::app
