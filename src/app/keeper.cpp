// Settings and autosaves, frame by frame.
#include "app/keeper.h"

#include <ctime>
#include <system_error>
#include <utility>

#include "app/keeper_progress.h"
#include "app/program.h"
#include "base/text.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "world/settings_groups.h"

namespace coaster::app {
namespace {

using edit::NoticeKind;

std::filesystem::path settings_file(const Keeper& keeper) {
  return keeper.folders.config.empty() ? std::filesystem::path() : keeper.folders.config / "settings.json";
}
std::filesystem::path recovery_folder(const Keeper& keeper) {
  return keeper.folders.state.empty() ? std::filesystem::path() : keeper.folders.state / "recovery";
}

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : "; ") + line;
  return all;
}

// A missing file reads as "".
base::Result<std::string> read_settings(Keeper& keeper, const std::filesystem::path& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return std::string();
  return keeper.files.read(file);
}

// Returns the settings; adds errors to `problems`.
exchange::UserSettings load_settings(Keeper& keeper, std::vector<std::string>& problems) {
  const std::filesystem::path file = settings_file(keeper);
  (void)keeper.files.remove_leftovers(file);
  const base::Result<std::string> text = read_settings(keeper, file);
  if (!text) {
    problems.push_back(text.status().message + "; it stays as it is, and this run's settings are not kept");
    keeper.may_write = false;
    return {};
  }
  if (text->empty()) return {};
  auto loaded = exchange::parse_settings(*text, file.filename().string());
  if (loaded) {
    problems = std::move(loaded->warnings);
    return std::move(loaded->settings);
  }
  keeper.may_write = keeper.files.rename(file, file.filename().string() + ".bad");
  problems.push_back(loaded.status().message + (!keeper.may_write
                                                    ? "; it stays as it is, and this run's settings are not kept"
                                                    : "; set aside as settings.json.bad"));
  return {};
}

// visit.template operator()<&Group::member>() for each setting that is kept.
template <class Visit>
void for_each_kept(Visit visit) {
  world::for_each_setting([&]<auto Setting>() {
    if constexpr (!world::setting_row<Setting>().kept_as.empty()) visit.template operator()<Setting>();
  });
}

void show(Program& program, const exchange::UserSettings& settings) {
  for_each_kept([&]<auto Setting>() {
    const auto kept = world::value_in<Setting>(settings.session);
    if (world::value_in<Setting>(program.session.settings) != kept) (void)apply(program, edit::Set<Setting>{kept});
  });
}

// Copies the state of session and window that belongs to the settings.
void follow_session(const Program& program, exchange::UserSettings& settings) {
  for_each_kept([&]<auto Setting>() {
    world::value_in<Setting>(settings.session) = world::value_in<Setting>(program.session.settings);
  });
  const auto at = program.surface->placement();
  if (!at) return;
  if (at->maximised && settings.window) settings.window->maximised = true;  // keeps the position it restores to
  else settings.window = exchange::WindowPlace{at->x, at->y, at->width, at->height, at->maximised};
}

void write_settings(Program& program, Keeper& keeper) {
  if (!keeper.may_write || keeper.folders.config.empty() || keeper.state.settings == keeper.written) return;
  base::Status status = keeper.files.root().make_folders(keeper.folders.config, 0700);
  if (status)
    status = keeper.files.write_atomic(settings_file(keeper), exchange::print_settings(keeper.state.settings));
  if (status) {
    keeper.written = keeper.state.settings;
    keeper.settings_failed = false;
  } else if (!std::exchange(keeper.settings_failed, true)) {
    edit::notify(program.session, NoticeKind::warning, "settings are not kept: " + status.message);
  }
}

// Writes a second after the last change: a dragged slider is written once.
void watch_settings(Program& program, Keeper& keeper) {
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
bool needs_autosave(Program& program, const Keeper& keeper) {
  if (!edit::dirty(program.session)) return false;
  return !keeper.autosave.exists() ||
         keeper.autosaved != edit::find(program.session, edit::Want::document_hash).document_hash;
}

void watch_document(Program& program, Keeper& keeper) {
  if (!edit::dirty(program.session)) {
    keeper.autosave.remove();
    keeper.unsaved_since = -1;
    return;
  }
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

void offer(Keeper& keeper) {
  keeper.state.recoveries.clear();
  for (const exchange::FoundAutosave& f : keeper.found)
    keeper.state.recoveries.push_back({f.info.original, f.info.name, f.file_time, f.info.time});
}

void answer(Program& program, Keeper& keeper, ui::Recovery what) {
  if (keeper.found.empty()) return;
  if (what == ui::Recovery::later) {
    keeper.found.clear();  // the files stay
  } else if (what == ui::Recovery::discard) {
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

void make_folder(Program& program, const std::string& folder) {
  const base::Status made = program.files.root().make_folders(folder, 0700);
  if (!made) edit::notify(program.session, NoticeKind::error, made.message);
}

void take_output(Program& program, Keeper& keeper, const ui::Output& output) {
  if (output.settings) {
    const bool keys = keeper.state.settings.keys != output.settings->keys;
    keeper.state.settings = *output.settings;
    if (keys)
      if (const auto problems = program.ui->set_keys(keeper.state.settings.keys); !problems.empty())
        edit::notify(program.session, NoticeKind::warning, "keys: " + joined(problems));
  }
  if (output.recovery) answer(program, keeper, *output.recovery);
  ui::SystemDialog& system = keeper.state.system;
  system.answer = keeper.dialog.poll();
  if (output.system_dialog && !keeper.dialog.start(*output.system_dialog)) system.answer = "";
  system.running = keeper.dialog.running();
}

}  // namespace

void start_keeping(Program& program, const base::UserFolders& folders, const base::Root& root, bool default_layout) {
  auto made = std::make_unique<Keeper>();
  Keeper& keeper = *made;
  keeper.files = program.files.with(root);
  keeper.folders = folders;
  std::vector<std::string> problems;
  exchange::UserSettings settings = load_settings(keeper, problems);
  keeper.written = settings;
  if (default_layout) {
    const world::Look at_first;
    settings.session.look->ui_scale = at_first.ui_scale;
    settings.session.look->show_panels = at_first.show_panels;
    settings.session.look->show_laboratory = at_first.show_laboratory;
    settings.window.reset();
    program.ui->reset_layout();
  }
  for (std::string& problem : program.ui->set_keys(settings.keys)) problems.push_back("keys: " + std::move(problem));
  if (settings.window)
    program.surface->place({settings.window->x, settings.window->y, settings.window->width, settings.window->height,
                            settings.window->maximised});
  keeper.state.settings = keeper.seen = settings;
  keeper.state.system.available = keeper.dialog.available();
  load_progress(program, keeper, problems);
  keeper.found = exchange::find_autosaves(keeper.files, recovery_folder(keeper));
  offer(keeper);
  program.keeper = std::move(made);
  show(program, settings);
  if (!problems.empty()) edit::notify(program.session, NoticeKind::warning, "settings: " + joined(problems));
}

void stop_keeping(Program& program, bool clean) {
  if (!program.keeper) return;
  Keeper& keeper = *program.keeper;
  follow_session(program, keeper.state.settings);
  write_settings(program, keeper);
  watch_progress(program, keeper);
  if (clean) keeper.autosave.remove();
  program.keeper.reset();
}

base::Status autosave_now(Program& program) {
  if (!program.keeper || !needs_autosave(program, *program.keeper)) return {};
  Keeper& keeper = *program.keeper;
  const std::filesystem::path& path = program.session.file.path;
  const std::string original = path.empty() ? std::string() : base::canonical_path(path).string();
  const base::Status wrote = keeper.autosave.write(keeper.files, recovery_folder(keeper), program.session.document,
                                                   original, static_cast<std::int64_t>(std::time(nullptr)));
  if (wrote) {
    keeper.autosaved = edit::find(program.session, edit::Want::document_hash).document_hash;
    keeper.autosave_failed = false;
    ++program.stats.keeping.autosaves;
  } else if (!std::exchange(keeper.autosave_failed, true)) {
    edit::notify(program.session, NoticeKind::error,
                 "autosave: " + wrote.message + "; save by hand (Save, in the menu File)");
  }
  return wrote;
}

void answer_keeping(Program& program, const ui::Output& output) {
  if (output.new_folder) make_folder(program, *output.new_folder);
  if (program.keeper) take_output(program, *program.keeper, output);
}

void keep(Program& program) {
  program.stats.keeping.quits = program.quit;
  if (!program.keeper) return;
  Keeper& keeper = *program.keeper;
  watch_document(program, keeper);
  watch_settings(program, keeper);
  watch_progress(program, keeper);
  program.stats.keeping.recoverable = static_cast<int>(keeper.found.size());
  program.stats.keeping.holder = keeper.state.holder;
}

}  // namespace coaster::app
