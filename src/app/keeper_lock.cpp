// The lock on the document's file: taken when a file is opened, moved when it is saved under another name.
#include <utility>

#include <fmt/format.h>

#include "app/program.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_session.h"
#include "exchange/formats.h"

namespace coaster::app {
namespace {

using edit::NoticeKind;
using Outcome = base::LockAttempt::Outcome;

bool holds_everything(const std::filesystem::path& path) {
  const exchange::Format* const format = exchange::format_of(path);
  return format != nullptr && format->whole;
}

// Called when the session has another file, or none.
void follow_file(Program& program, Keeper& keeper) {
  const std::filesystem::path& path = program.session.file.path;
  const base::Root& root = program.files.root();
  const bool locked = !path.empty() && root.contains(path);  // a script leaves no files outside its folder
  keeper.state.holder.clear();
  if (!locked) keeper.lock.release();
  if (!locked || keeper.lock.covers(path)) return;
  base::LockAttempt attempt = base::try_lock(path, root);
  keeper.lock = std::move(attempt.lock);
  if (attempt.outcome == Outcome::held) {
    keeper.state.holder = fmt::format("another coaster ({})", attempt.holder);
    edit::notify(program.session, NoticeKind::warning,
                 fmt::format("{} is open in {}. Save your changes under another name.", path.filename().string(),
                             keeper.state.holder));
  } else if (attempt.outcome == Outcome::impossible && !keeper.unasked) {
    edit::notify(program.session, NoticeKind::info,
                 fmt::format("{} is opened without a lock ({}). Other programs can change it.",
                             path.filename().string(), attempt.reason));
  }
}

}  // namespace

base::Status before_command(Program& program, const edit::Command& command) {
  const auto* const save = command.as<edit::Save>();
  if (!program.keeper || save == nullptr || !holds_everything(save->path) || program.keeper->lock.covers(save->path))
    return {};
  base::LockAttempt attempt = base::try_lock(save->path, program.files.root());
  if (attempt.outcome == Outcome::held)
    return {base::Code::refused,
            fmt::format("{} is open in another coaster ({}). Save under another name.", save->path, attempt.holder)};
  program.keeper->next_lock = std::move(attempt.lock);
  return {};
}

void after_command(Program& program, const edit::Command& command, const base::Status& applied) {
  if (!program.keeper) return;
  Keeper& keeper = *program.keeper;
  base::FileLock next = std::move(keeper.next_lock);
  if (!applied) return;
  if (!edit::dirty(program.session))
    forget_unsaved(keeper);  // at once, so that a crash before the next frame does not offer it
  std::vector<std::string>& recent = keeper.state.settings.recent;
  if (const auto* const save = command.as<edit::Save>(); save != nullptr && holds_everything(save->path)) {
    if (next.held() || !keeper.lock.covers(save->path)) keeper.lock = std::move(next);
    keeper.state.holder.clear();
    exchange::remember(recent, base::canonical_path(save->path).string());
  } else if (edit::info(command).traits.replaces) {
    follow_file(program, keeper);
    const auto* const load = command.as<edit::Load>();
    if (load && !keeper.unasked && !edit::opens_link(command) && !exchange::is_pasted(load->path))
      exchange::remember(recent, base::canonical_path(load->path).string());
  }
}

}  // namespace coaster::app
