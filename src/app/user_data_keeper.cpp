// A copy of unsaved changes for a crash, the lock on the document's file, settings and autosaves.
#include "app/user_data_keeper.h"

#include <chrono>
#include <ctime>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/program.h"
#include "app/script_host.h"
#include "base/parallel.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "exchange/formats.h"
#include "world/panel_settings.h"

namespace coaster::app {
namespace {

using edit::NoticeKind;
using Outcome = base::LockAttempt::Outcome;

bool holds_everything(const std::filesystem::path& path) {
  const exchange::TrackFormat* const format = exchange::format_of(path);
  return format != nullptr && format->whole;
}

// Returns a file below one of the user's folders; empty without that folder.
std::filesystem::path below(const std::filesystem::path& folder, const char* name) {
  return folder.empty() ? folder : folder / name;
}
std::filesystem::path settings_file(const UserDataKeeper& keeper) {
  return below(keeper.folders.config, "settings.json");
}
std::filesystem::path progress_file(const UserDataKeeper& keeper) {
  return below(keeper.folders.state, "progress.json");
}

// Of autosaves; empty: there is none.
std::filesystem::path recovery_folder(const UserDataKeeper& keeper) { return below(keeper.folders.state, "recovery"); }

// The document's own file, absolute; empty: none.
std::string original_of(const edit::Session& session) {
  return session.file.path.empty() ? std::string() : base::canonical_path(session.file.path).string();
}

// Once per frame with unsaved changes. A frame without a change costs a comparison. Scripts print at once.
void follow_crash_copy(Program& program) {
  constexpr double kGap = 0.5;  // s
  UserDataKeeper& keeper = *program.keeper;
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

// Drops the copy: there is nothing unsaved any more.
void forget_crash_copy(CrashCopy& copy) {
  if (!copy.edits) return;
  if (copy.printing.valid()) copy.printing.get();
  base::keep_for_crash({});
  copy.edits.reset();
}

// Removes autosave and copy: there is nothing unsaved any more.
void forget_unsaved(UserDataKeeper& keeper) {
  forget_crash_copy(keeper.crash_copy);
  keeper.autosave.remove();
  keeper.unsaved_since = -1;
}

// Called when the session has another file, or none.
void follow_file(Program& program, UserDataKeeper& keeper) {
  const std::filesystem::path& path = program.session.file.path;
  const base::FileRoot& root = program.files.root();
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

constexpr std::size_t kMaxKeptBytes = 1u << 20;  // limit of each of the user's files

// Returns the first free one of "NAME.bad", "NAME.bad2" and so on: nothing set aside is ever replaced. "" without any.
std::string free_bad_name(const std::filesystem::path& file) {
  std::error_code ignored;
  for (int i = 1; i < 100; ++i) {
    const std::string name = fmt::format("{}.bad{}", file.filename().string(), i == 1 ? "" : std::to_string(i));
    const auto status = std::filesystem::symlink_status(file.parent_path() / name, ignored);
    if (status.type() == std::filesystem::file_type::not_found) return name;
  }
  return {};
}

// Reads one of the user's files; nothing if it is missing, empty or invalid, or of a newer version. Renames an invalid
// one to free_bad_name(). Adds errors to `problems`. `what`: what is not saved if the file could be neither read nor
// renamed.
template <class Parse>
auto read_kept(UserDataKeeper& keeper, const std::filesystem::path& file, Parse parse, const char* what,
               bool& may_write, std::vector<std::string>& problems)
    -> std::optional<std::remove_cvref_t<decltype(*parse("", ""))>> {
  std::error_code ignored;
  if (!file.empty()) (void)keeper.files.remove_leftovers(file);
  if (file.empty() || !std::filesystem::exists(file, ignored)) return std::nullopt;
  const base::Result<std::string> text = keeper.files.read(file, kMaxKeptBytes);
  if (text && text->empty()) return std::nullopt;
  const std::string name = file.filename().string(), bad = free_bad_name(file);
  base::Status problem = text.status();
  if (text) {
    auto parsed = parse(*text, name);
    if (parsed) return std::move(*parsed);
    problem = parsed.status();
  }
  may_write = text && !bad.empty() && keeper.files.rename(file, bad);
  problems.push_back(may_write ? fmt::format("{}; set aside as {}", problem.message, bad)
                               : fmt::format("{}; it stays as it is, and {} are not kept", problem.message, what));
  return std::nullopt;
}

// Writes one of the user's files. Reports the first of several errors.
bool write_kept(Program& program, const std::filesystem::path& file, const std::string& text, const char* what,
                bool& failed) {
  base::Files& files = program.keeper->files;
  base::Status status = files.root().make_folders(file.parent_path(), 0700);
  if (status) status = files.write_atomic(file, text);
  if (!status && !failed)
    edit::notify(program.session, NoticeKind::warning, fmt::format("{} are not kept: {}", what, status.message));
  failed = !status;
  return status.ok();
}

exchange::UserSettings load_settings(UserDataKeeper& keeper, std::vector<std::string>& problems) {
  auto loaded = read_kept(keeper, settings_file(keeper), exchange::parse_settings, "this run's settings",
                          keeper.may_write, problems);
  if (!loaded) return {};
  problems = std::move(loaded->warnings);
  return std::move(loaded->settings);
}

void load_progress(Program& program, UserDataKeeper& keeper, std::vector<std::string>& problems) {
  if (!keeper.folders.config.empty()) keeper.state.challenges = keeper.folders.config / "challenges";
  program.session.game.earned = {};
  if (auto loaded = read_kept(keeper, progress_file(keeper), exchange::parse_progress, "medals of this run",
                              keeper.may_write_progress, problems))
    keeper.state.progress = keeper.progress_written = std::move(*loaded);
}

// Writes new progress. After an error the next success tries again.
void watch_progress(Program& program, UserDataKeeper& keeper) {
  for (const exchange::ChallengeProgress& success : program.session.game.earned.challenges)
    (void)exchange::merge(keeper.state.progress, success);
  if (!keeper.may_write_progress || keeper.folders.state.empty() || keeper.state.progress == keeper.progress_written)
    return;
  (void)write_kept(program, progress_file(keeper), exchange::print_progress(keeper.state.progress), "Medals",
                   keeper.progress_failed);
  keeper.progress_written = keeper.state.progress;
}

// Calls visit.template operator()<&Group::member>() for each setting that is kept.
template <class Visit>
void for_each_kept(Visit visit) {
  world::for_each_setting([&]<auto Setting>() {
    if constexpr (!world::setting_row<Setting>().kept_as.empty()) visit.template operator()<Setting>();
  });
}

void show(Program& program, const exchange::UserSettings& settings) {
  for_each_kept([&]<auto Setting>() { take_settings<Setting>(program, settings.session); });
}

// Copies the state of session and window that belongs to the settings.
void follow_session(const Program& program, exchange::UserSettings& settings) {
  for_each_kept([&]<auto Setting>() {
    if (program.tutorial.run && kLentToTutorial<Setting>) return;
    world::value_in<Setting>(settings.session) = world::value_in<Setting>(program.session.settings);
  });
  const auto at = program.surface->placement();
  if (at && at->maximised && settings.window) settings.window->maximised = true;  // keeps the position it restores to
  else if (at) settings.window = exchange::WindowPlace{at->x, at->y, at->width, at->height, at->maximised};
}

void write_settings(Program& program, UserDataKeeper& keeper) {
  if (!keeper.may_write || keeper.folders.config.empty() || keeper.state.settings == keeper.written) return;
  if (write_kept(program, settings_file(keeper), exchange::print_settings(keeper.state.settings), "Settings",
                 keeper.settings_failed))
    keeper.written = keeper.state.settings;
}

// Writes a second after the last change, so that dragging a slider writes once.
void watch_settings(Program& program, UserDataKeeper& keeper) {
  constexpr double kQuiet = 1, kAgain = 30;  // s
  follow_session(program, keeper.state.settings);
  if (!(keeper.state.settings == keeper.seen)) {
    keeper.seen = keeper.state.settings;
    keeper.seen_since = program.time.seconds;
  } else if (program.time.seconds - keeper.seen_since >= (keeper.settings_failed ? kAgain : kQuiet)) {
    keeper.seen_since = program.time.seconds;
    write_settings(program, keeper);
  }
}

// True if there are changes that neither the file nor the autosave has.
bool needs_autosave(Program& program, const UserDataKeeper& keeper) {
  if (!edit::dirty(program.session)) return false;
  return !keeper.autosave.exists() || keeper.autosaved != edit::SessionFindings(program.session).document_hash();
}

void watch_document(Program& program, UserDataKeeper& keeper) {
  if (!edit::dirty(program.session)) return forget_unsaved(keeper);
  follow_crash_copy(program);
  if (keeper.unsaved_since < 0) {
    if (needs_autosave(program, keeper)) keeper.unsaved_since = program.time.seconds;
    return;
  }
  if (program.time.seconds - keeper.unsaved_since < keeper.state.settings.autosave_seconds ||
      program.session.history.in_gesture)
    return;
  (void)autosave_now(program);
  keeper.unsaved_since = -1;
}

void offer(UserDataKeeper& keeper) {
  keeper.state.recoveries.clear();
  for (const exchange::FoundAutosave& f : keeper.found)
    keeper.state.recoveries.push_back({f.info.original, f.info.name, f.file_time, f.info.time});
}

void answer(Program& program, UserDataKeeper& keeper, ui::RecoveryAnswer what) {
  if (keeper.found.empty()) return;
  if (what == ui::RecoveryAnswer::later) {
    keeper.found.clear();  // the files stay
  } else if (what == ui::RecoveryAnswer::discard) {
    exchange::discard(keeper.files, keeper.found.front());
    keeper.found.erase(keeper.found.begin());
  } else {
    exchange::FoundAutosave found = std::move(keeper.found.front());
    keeper.found.erase(keeper.found.begin());
    // Autosaves again before the old autosave is removed, so there is always one. If it cannot be read or written, it
    // stays for the next start.
    const bool recovered = apply(program, edit::RecoverTrack{found.info.track.string(), found.info.original}).ok();
    if (recovered && autosave_now(program)) exchange::discard(keeper.files, found);
  }
  offer(keeper);
}

void set_keys(Program& program, const std::vector<exchange::KeyBinding>& keys) {
  if (const auto problems = program.ui->set_keys(keys); !problems.empty())
    edit::notify(program.session, NoticeKind::warning, fmt::format("{}", fmt::join(problems, " ")));
}

void take_output(Program& program, UserDataKeeper& keeper, const ui::Output& output) {
  if (output.settings) {
    const bool keys = keeper.state.settings.keys != output.settings->keys;
    keeper.state.settings = *output.settings;
    if (keys) set_keys(program, keeper.state.settings.keys);
  }
  if (output.recovery) answer(program, keeper, *output.recovery);
  ui::SystemDialog& system = keeper.state.system;
  system.answer = keeper.dialog.poll();
  if (output.system_dialog && !keeper.dialog.start(*output.system_dialog)) system.answer = "";
  system.running = keeper.dialog.running();
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
  UserDataKeeper& keeper = *program.keeper;
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
    const auto* const load = command.as<edit::LoadTrack>();
    if (load && !keeper.unasked && !edit::opens_link(command) && !exchange::is_pasted(load->path))
      exchange::remember(recent, base::canonical_path(load->path).string());
  }
}

void start_keeping(Program& program, const base::UserFolders& folders, const base::FileRoot& root,
                   bool default_layout) {
  auto made = std::make_unique<UserDataKeeper>();
  UserDataKeeper& keeper = *made;
  keeper.files = program.files.with(root), keeper.folders = folders;
  std::vector<std::string> problems;
  exchange::UserSettings settings = load_settings(keeper, problems);
  keeper.written = settings;
  if (default_layout) {
    settings.session.look->ui_scale = world::Appearance().ui_scale;
    const world::Panels at_first;
    settings.session.panels->show_panels = at_first.show_panels;
    settings.session.panels->laboratory_height = at_first.laboratory_height;
    settings.session.panels->show_laboratory = at_first.show_laboratory;
    settings.session.panels->workspace = at_first.workspace;
    settings.session.panels->graph_height = at_first.graph_height;
    settings.window.reset();
    program.ui->reset_layout();
  }
  std::optional<exchange::WindowPlace>& at = settings.window;  // of the last window; --size selects another size
  if (at && program.options.width > 0) *at = {at->x, at->y, program.options.width, program.options.height, false};
  if (at) program.surface->place({at->x, at->y, at->width, at->height, at->maximised});
  keeper.state.settings = keeper.seen = settings;
  keeper.state.system.available = keeper.dialog.available();
  load_progress(program, keeper, problems);
  keeper.found = exchange::find_autosaves(keeper.files, recovery_folder(keeper));
  offer(keeper);
  program.keeper = std::move(made);
  show(program, settings);
  if (!problems.empty())
    edit::notify(program.session, NoticeKind::warning, fmt::format("Settings: {}", fmt::join(problems, "; ")));
  set_keys(program, settings.keys);
}

void stop_keeping(Program& program, bool clean) {
  if (!program.keeper) return;
  UserDataKeeper& keeper = *program.keeper;
  follow_session(program, keeper.state.settings);
  write_settings(program, keeper);
  watch_progress(program, keeper);
  if (clean) forget_unsaved(keeper);
  forget_crash_copy(keeper.crash_copy);
  program.keeper.reset();
}

base::Status autosave_now(Program& program) {
  if (!program.keeper || !needs_autosave(program, *program.keeper)) return {};
  UserDataKeeper& keeper = *program.keeper;
  const base::Status wrote =
      keeper.autosave.write(keeper.files, recovery_folder(keeper), program.session.document,
                            original_of(program.session), static_cast<std::int64_t>(std::time(nullptr)));
  if (wrote) {
    keeper.autosaved = edit::SessionFindings(program.session).document_hash();
    keeper.autosave_failed = false;
    ++program.stats.keeping.autosaves;
  } else if (!std::exchange(keeper.autosave_failed, true)) {
    edit::notify(program.session, NoticeKind::error,
                 fmt::format("The autosave failed: {}. Save by hand (Save, in the menu File).", wrote.message));
  }
  return wrote;
}

void answer_keeping(Program& program, const ui::Output& output) {
  if (output.new_folder)
    if (const base::Status made = program.files.root().make_folders(*output.new_folder, 0700); !made)
      edit::notify(program.session, NoticeKind::error, made.message);
  if (program.keeper) take_output(program, *program.keeper, output);
}

void keep(Program& program) {
  program.stats.keeping.quits = program.quit;
  if (!program.keeper) return;
  UserDataKeeper& keeper = *program.keeper;
  watch_document(program, keeper);
  watch_settings(program, keeper);
  watch_progress(program, keeper);
  program.stats.keeping.recoverable = static_cast<int>(keeper.found.size());
  program.stats.keeping.holder = keeper.state.holder;
}

}  // namespace coaster::app
