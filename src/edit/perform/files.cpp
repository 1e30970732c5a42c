// Commands that open, save and export.
#include <utility>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/text.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/perform/job_result.h"
#include "edit/perform/perform_context.h"
#include "edit/session/ride_report.h"
#include "exchange/formats.h"
#include "exchange/own/force_limits_file.h"
#include "exchange/own/share_link.h"
#include "exchange/own/track_file.h"
#include "world/aid_settings.h"
#include "world/evaluation_settings.h"

namespace coaster::edit {

using base::Status;

namespace {

Status write(Change& change, const std::string& path, std::string_view text) {
  if (path.empty()) return refused("expected a file to write to");
  const Status status = change.files.write_atomic(path, base::visible_text(text));
  if (status) change.note = "Saved " + path;
  return status;
}

// Restores the view of a shared track.
Status show_shared(Session& session, Change& change, const exchange::SharedView& view) {
  world::Settings& settings = session.settings;
  settings.camera_mode = view.mode;
  settings.camera = view.camera, settings.fly = view.fly;
  settings.evaluation->evaluator = view.evaluator, settings.evaluation->steps = view.steps;
  fit_budget(session);
  derive(session);
  if (const Status looks = perform(session, change, set_camera(view.camera)); !looks) return looks;
  return perform(session, change, SetFlyCamera{view.fly});
}

}  // namespace

void start_over(Session& session, world::Document document, std::filesystem::path path) {
  const base::JobScope whole(nullptr);  // the old track is gone: Cancel comes too late
  if (!session.document.track.knots.empty()) session.notices.list.clear();  // they are about that track
  session.notices.tight = 0;
  session.document = std::move(document);
  session.history = {};
  session.motion = {};
  session.settings.selected = world::kNone, session.settings.also.clear();
  session.settings.aids->append_mode = false;
  session.file.path = std::move(path);
  session.file.version = exchange::version_of(session.document);
  session.file.import.reset();
  session.file.content.reset();
  session.game.challenge.reset();
  session.game.run = {};
  session.game.result.reset();
  session.game.show_result = false;
  session.file.saved_hash = world::hash(session.document);
  fit_budget(session);
  derive(session);
  if (!base::interrupted()) sim::reset(session.document, session.derived, session.motion);
}

Status perform(Session& session, Change& change, const LoadTrack& command) {
  auto* const read =
      change.search && change.search->found ? std::get_if<exchange::LoadedTrack>(&*change.search->found) : nullptr;
  base::Result<exchange::LoadedTrack> loaded =
      read ? std::move(*read) : exchange::load_track(change.files, command.path, command.import);
  if (!loaded) return loaded.status();
  // A format that does not hold everything is an import: the next save needs a file name, and until then the track
  // counts as unsaved. A link holds everything.
  const exchange::TrackFormat* const format = loaded->view ? nullptr : exchange::format_of(command.path);
  start_over(session, std::move(loaded->document), format && format->whole ? command.path : std::string());
  if (format != nullptr && !format->whole) session.file.saved_hash = ~session.file.saved_hash;
  session.file.import = loaded->import;
  session.file.content = loaded->content;
  session.file.version = loaded->version;
  warn(session, loaded->warnings);
  change.note = std::move(loaded->note);
  return loaded->view ? show_shared(session, change, *loaded->view) : Status();
}
Status perform(Session& session, Change& change, const CopyLink&) {
  std::string link = link_of(session);
  if (link.size() > exchange::kMaxLinkBytes)
    return refused(
        fmt::format("the link would have {} characters, and {} is the limit. Save the track and send the file",
                    link.size(), exchange::kMaxLinkBytes));
  session.shared = std::move(link);
  change.note = fmt::format("Copied a link of {} characters.", session.shared.size());
  return {};
}
Status perform(Session& session, Change& change, const Save& command) {
  if (command.path.empty()) return refused("expected a file to save to");
  const bool own = is_own_file(session, command.path);
  if (own && !command.overwrite && changed_outside(session))
    return {base::Code::io, fmt::format("{} was changed by another program since it was opened. Save under another "
                                        "name, or replace the changes with: save {} overwrite",
                                        command.path, base::quoted_start(command.path))};
  std::uint64_t content = 0;
  const Status status =
      exchange::save_track(change.files, command.path, session.document, &content,
                           own ? base::ReplaceableFiles::any : base::ReplaceableFiles::made, command.park.set);
  if (!status) {
    // If only the last flush failed, the new contents are this program's own.
    if (own && content_of(session.file.path) == content) session.file.content = content;
    return status;
  }
  // Saving in a format that does not hold everything is an export: the document stays unsaved.
  const bool whole = exchange::format_of(command.path)->whole;
  if (whole) {
    session.file.path = command.path;
    session.file.saved_hash = world::hash(session.document);
    session.file.content = content;
  }
  change.note = fmt::format("{} {}", whole ? "Saved" : "Exported", command.path);
  const int version = exchange::version_of(session.document);
  if (whole && std::exchange(session.file.version, version) < version)
    change.note += fmt::format(" in version {} of the format, which older versions of this program refuse.", version);
  return {};
}
Status perform(Session& session, Change& change, const SaveMeasurements& command) {
  if (session.measuring.measurement.next == 0) return refused("there are no measurements yet");
  return write(change, command.path, sim::to_csv(session.measuring.measurement, session.measuring.machine));
}
Status perform(Session& session, Change& change, const SaveReport& command) {
  const auto report = command.path.ends_with(".csv") ? ride_csv(session) : ride_report(session);
  if (!report) return refused("a report needs a track with a train");
  return write(change, command.path, *report);
}
Status perform(Session& session, Change& change, const LoadForceLimits& command) {
  base::Result<exchange::LoadedForceLimits> loaded = exchange::load_envelope(change.files, command.path);
  if (!loaded) return loaded.status();
  session.limits.loaded = std::move(loaded->envelope), session.limits.name = std::move(loaded->name);
  ++session.limits.serial;
  warn(session, loaded->warnings);
  change.note = fmt::format("Force limits: {}. Not a compliance check.", session.limits.name);
  return {};
}
Status perform(Session& session, Change& change, const RecoverTrack& command) {
  base::Result<exchange::LoadedTrack> loaded = exchange::load_track(change.files, command.path);
  if (!loaded) return loaded.status();
  // The document is compared with the present contents of the original file; if they differ, or there is no file, it
  // counts as unsaved.
  const exchange::TrackFormat* const format =
      command.original.empty() ? nullptr : exchange::format_of(command.original);
  std::uint64_t saved = ~world::hash(loaded->document);
  std::optional<std::uint64_t> content;
  if (format != nullptr && format->whole)
    if (const base::Result<exchange::LoadedTrack> old = exchange::load_track(change.files, command.original))
      saved = world::hash(old->document), content = old->content;
  start_over(session, std::move(loaded->document),
             format != nullptr && format->whole ? command.original : std::string());
  session.file.saved_hash = saved;
  session.file.content = content;
  warn(session, loaded->warnings);
  change.note = fmt::format("Recovered {}: {} knots, {:.0f} m. It is not saved yet.",
                            command.original.empty() ? base::quoted_start(session.document.name) : command.original,
                            session.document.track.knots.size(), session.derived.length);
  return {};
}
Status perform(Session& session, Change&, const NewTrack&) {
  start_over(session, {}, {});
  return {};
}

}  // namespace coaster::edit
