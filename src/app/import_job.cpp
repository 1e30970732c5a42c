#include "app/import_job.h"

#include <chrono>
#include <variant>

#include "app/program.h"
#include "exchange/formats.h"

namespace coaster::app {

bool begin_import(Program& program, const edit::Command& command) {
  const auto* const load = command.as<edit::Load>();
  if (!load || !program.by_hand || !program.surface->is_window() || program.import) return false;
  const exchange::Format* const format = exchange::format_of(load->path);
  if (!format || !format->parse_watched) return false;
  program.import = std::make_unique<ImportJob>();
  ImportJob& job = *program.import;
  job.path = load->path, job.since = program.seconds;
  job.result = std::async(std::launch::async, [path = load->path, progress = &job.progress] {
    base::Files files;
    return exchange::load_track(files, path, progress);
  });
  return true;
}

void finish_import(Program& program) {
  if (!program.import || program.import->result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const std::unique_ptr<ImportJob> job = std::move(program.import);
  base::Result<exchange::LoadedTrack> read = job->result.get();
  if (!read) {
    const bool cancelled = job->progress.cancelled;
    edit::notify(program.session, cancelled ? edit::NoticeKind::info : edit::NoticeKind::error, read.status().message);
    return;
  }
  program.session.read_ahead = edit::ReadAhead{job->path, std::move(*read)};
  (void)apply(program, edit::Load{job->path});
}

}  // namespace coaster::app
