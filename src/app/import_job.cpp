#include "app/import_job.h"

#include <chrono>
#include <utility>

#include "app/program.h"
#include "edit/commands/commands_session.h"
#include "exchange/formats.h"

namespace coaster::app {

bool begin_import(Program& program, const edit::Command& command) {
  const auto* const load = command.as<edit::Load>();
  const bool slow = program.import_delay > 0;
  if (!load || !program.by_hand || (!program.surface->is_window() && !slow) || program.import) return false;
  const exchange::Format* const format = exchange::format_of(load->path);
  if (!format || !format->parse_watched) return false;
  program.import = std::make_unique<ImportJob>();
  ImportJob& job = *program.import;
  job.path = load->path, job.since = program.time.seconds;
  job.slow = slow, job.frames_left = std::exchange(program.import_delay, 0);
  job.result = std::async(std::launch::async, [path = load->path, progress = &job.progress] {
    base::Files files;
    return exchange::load_track(files, path, progress);
  });
  return true;
}

const base::Progress* shown_import(const Program& program) {
  constexpr double kBarAfter = 0.15;  // s: shorter imports show no bar
  const ImportJob* const job = program.import.get();
  return job && (job->slow || program.time.seconds - job->since > kBarAfter) ? &job->progress : nullptr;
}

void finish_import(Program& program) {
  if (!program.import) return;
  ImportJob& running = *program.import;
  if (running.slow) {
    // Counts frames only, however fast the reader is.
    if (!running.progress.cancelled && running.frames_left-- > 0) return;
    running.result.wait();
  }
  if (running.result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const std::unique_ptr<ImportJob> job = std::move(program.import);
  base::Result<exchange::LoadedTrack> read = job->result.get();
  // A cancelled import is dropped, even if the reader was faster.
  if (job->progress.cancelled)
    return edit::notify(program.session, edit::NoticeKind::info, "Cancelled the import of " + job->path);
  if (!read) return edit::notify(program.session, edit::NoticeKind::error, read.status().message);
  program.session.file.read_ahead = edit::ReadAhead{job->path, std::move(*read)};
  (void)apply(program, edit::Load{job->path});
}

}  // namespace coaster::app
