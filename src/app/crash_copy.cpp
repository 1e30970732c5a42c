#include "app/crash_copy.h"

#include <chrono>
#include <ctime>
#include <memory>

#include "app/program.h"
#include "base/parallel.h"

namespace coaster::app {

void follow_crash_copy(Program& program) {
  constexpr double kGap = 0.5;  // s
  Keeper& keeper = *program.keeper;
  CrashCopy& copy = keeper.crash_copy;
  const edit::Session& session = program.session;
  if (!base::has_threads() || copy.edits == session.edits) return;
  const bool at_once = !program.surface->is_window() || !program.options.script.empty();
  const double now = program.surface->clock();
  if (!at_once && copy.edits && now - copy.since < kGap) return;
  if (copy.printing.valid() && copy.printing.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return;
  copy.edits = session.edits, copy.since = now;
  base::Files files(keeper.files.root());  // without injected faults, which are meant for documents
  if (!keeper.autosave.reserve(files, recovery_folder(keeper))) return;  // the next autosave reports it
  // Where the system refuses a thread, std::async needs the function again: it may not be moved.
  const auto print = [files, info = keeper.autosave.info(), original = original_of(session),
                      document = std::make_shared<const world::Document>(session.document)]() mutable {
    const base::HandlerStack stack;
    std::vector<base::CrashFile> made =
        exchange::crash_files(files, info, *document, original, static_cast<std::int64_t>(std::time(nullptr)));
    if (!made.empty()) base::keep_for_crash(std::move(made));
  };
  copy.printing = std::async(std::launch::async | std::launch::deferred, print);
  if (at_once || copy.printing.wait_for(std::chrono::seconds(0)) == std::future_status::deferred) copy.printing.get();
}

std::string original_of(const edit::Session& session) {
  return session.file.path.empty() ? std::string() : base::canonical_path(session.file.path).string();
}

void forget_unsaved(Keeper& keeper) {
  forget_crash_copy(keeper.crash_copy);
  keeper.autosave.remove();
  keeper.unsaved_since = -1;
}

void forget_crash_copy(CrashCopy& copy) {
  if (!copy.edits) return;
  if (copy.printing.valid()) copy.printing.get();
  base::keep_for_crash({});
  copy.edits.reset();
}

}  // namespace coaster::app
