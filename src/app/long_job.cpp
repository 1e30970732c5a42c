#include "app/long_job.h"

#include <utility>
#include <variant>

#include "app/program.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_seek.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/seek.h"
#include "exchange/formats.h"

namespace coaster::app {
namespace {

constexpr double kBarAfter = 0.15;  // s: shorter jobs show no bar

Beside::Work reading(const std::string& path) {
  return [path](base::Progress* progress) -> base::Result<Found> {
    base::Files files;
    base::Result<exchange::LoadedTrack> read = exchange::load_track(files, path, progress);
    return read ? base::Result<Found>(std::move(*read)) : read.status();
  };
}

Beside::Work searching(const edit::Session& session, const edit::Seek& command) {
  return [search = edit::search_for(session, command)](base::Progress* progress) -> base::Result<Found> {
    base::Result<edit::Sought> sought = search(progress);
    return sought ? base::Result<Found>(std::move(*sought)) : sought.status();
  };
}

// Begins what can be done beside the frames for a command; false for most commands.
bool begin_work(const Program& program, const edit::Command& command, LongJob& job) {
  if (const auto* const load = command.as<edit::Load>()) {
    const exchange::Format* const format = exchange::format_of(load->path);
    if (!format || !format->parse_watched) return false;
    job.panel = "Import", job.title = "Fitting a track to the imported points";
    job.cancelled = "Cancelled the import of " + load->path;
    job.work = std::make_unique<Beside>(reading(load->path), load->path);
    return true;
  }
  if (const auto* const seek = command.as<edit::Seek>()) {
    job.panel = "Search", job.title = "Searching for " + seek->goal.text;
    job.cancelled = "Cancelled the search";
    job.work = std::make_unique<Beside>(searching(program.session, *seek), "");
    return true;
  }
  return false;
}

// Hands what was found to the session, for the command.
void hand_over(edit::Session& session, const LongJob& job, Found found) {
  if (auto* const track = std::get_if<exchange::LoadedTrack>(&found))
    session.file.read_ahead = edit::ReadAhead{job.command.as<edit::Load>()->path, std::move(*track)};
  else
    session.sought = edit::SoughtAhead{edit::print(job.command), job.edits, std::get<edit::Sought>(std::move(found))};
}

}  // namespace

bool begin_job(Program& program, const edit::Command& command) {
  const bool slow = program.job_delay > 0;
  if (!program.by_hand || (!program.surface->is_window() && !slow) || program.job) return false;
  auto job = std::make_unique<LongJob>();
  if (!begin_work(program, command, *job)) return false;
  job->command = command, job->since = program.time.seconds, job->edits = program.session.edits;
  job->slow = slow, job->frames_left = std::exchange(program.job_delay, 0);
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
  // A slow job counts frames only, however fast the work is.
  if (running.slow && !running.work->progress.cancelled && running.frames_left-- > 0) return;
  if (!running.slow && !running.work->done()) return;
  const std::unique_ptr<LongJob> job = std::move(program.job);
  base::Result<Found> found = job->work->take();
  // A cancelled job is dropped, even if the work was faster.
  if (job->work->progress.cancelled) return edit::notify(program.session, edit::NoticeKind::info, job->cancelled);
  if (!found) return edit::notify(program.session, found.status());
  hand_over(program.session, *job, std::move(*found));
  (void)apply(program, job->command);
}

}  // namespace coaster::app
