#include "app/keeper_progress.h"

#include <system_error>
#include <utility>

#include "app/keeper.h"
#include "app/program.h"

namespace coaster::app {
namespace {

std::filesystem::path progress_file(const Keeper& keeper) {
  return keeper.folders.state.empty() ? std::filesystem::path() : keeper.folders.state / "progress.json";
}

}  // namespace

void load_progress(Program& program, Keeper& keeper, std::vector<std::string>& problems) {
  if (!keeper.folders.config.empty()) keeper.state.challenges = keeper.folders.config / "challenges";
  program.session.game.earned = {};
  const std::filesystem::path file = progress_file(keeper);
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error)) return;
  (void)keeper.files.remove_leftovers(file);
  const base::Result<std::string> text = keeper.files.read(file);
  if (!text) {
    problems.push_back(text.status().message + "; it stays as it is, and medals of this run are not kept");
    keeper.may_write_progress = false;
    return;
  }
  auto loaded = exchange::parse_progress(*text, file.filename().string());
  if (loaded) {
    keeper.state.progress = keeper.progress_written = std::move(*loaded);
    return;
  }
  keeper.may_write_progress = keeper.files.rename(file, file.filename().string() + ".bad");
  problems.push_back(loaded.status().message + (!keeper.may_write_progress
                                                    ? "; it stays as it is, and medals of this run are not kept"
                                                    : "; set aside as progress.json.bad"));
}

void watch_progress(Program& program, Keeper& keeper) {
  for (const exchange::ChallengeProgress& success : program.session.game.earned.challenges)
    (void)exchange::merge(keeper.state.progress, success);
  if (!keeper.may_write_progress || keeper.folders.state.empty() || keeper.state.progress == keeper.progress_written)
    return;
  base::Status status = keeper.files.root().make_folders(keeper.folders.state, 0700);
  if (status)
    status = keeper.files.write_atomic(progress_file(keeper), exchange::print_progress(keeper.state.progress));
  // A write error is reported once; the next success tries again.
  keeper.progress_written = keeper.state.progress;
  if (!status && !std::exchange(keeper.progress_failed, true))
    edit::notify(program.session, edit::NoticeKind::warning, "medals are not kept: " + status.message);
}

}  // namespace coaster::app
