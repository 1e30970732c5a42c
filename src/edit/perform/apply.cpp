// Every command's way into the session, and what follows from it: joints, derived data, carts, history, notices.
#include "edit/perform/apply.h"

#include <cmath>
#include <type_traits>
#include <utility>

#include "base/portable_math.h"
#include "edit/commands/codec.h"
#include "edit/commands/command_list.h"
#include "edit/perform/motion_follow.h"
#include "edit/perform/perform.h"
#include "edit/perform/set.h"
#include "edit/session/history.h"
#include "edit/session/ride_watch.h"
#include "exchange/formats.h"
#include "exchange/own/envelope_file.h"
#include "exchange/own/track_file.h"
#include "world/aids.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;

void derive(Session& session) {
  sim::derive(session.document, session.settings, session.measuring.clock, session.derived);
}

// A ride that has not started (or has no trains) shows the trains as designed; any other keeps their positions.
void settle_motion(Session& session) {
  if (session.motion.state == world::RideState::stopped || session.document.entities.pool<world::Cart>().size() == 0)
    sim::reset(session.document, session.derived, session.motion);
  else sim::reconcile(session.document, session.derived, session.motion);
}

// A split only knows `up` at the new knot, which fixes the twist of both halves up to whole turns: those follow from
// the segment's twist, divided by length.
void share_turns(Session& session, const MotionFollowUp& split, double twist) {
  const double left = session.derived.shape(split.first).arc.length(),
               right = session.derived.shape(split.second).arc.length();
  bool changed = false;
  for (const auto& [e, share] : {std::pair{split.first, left}, std::pair{split.second, right}}) {
    if (!(left + right > 0)) continue;
    const double missing = twist * (share / (left + right)) - session.derived.shape(e).twist;
    const auto turns = static_cast<std::int32_t>(std::lround(missing / (2 * base::kPi)));
    if (turns == 0) continue;
    session.document.entities.get<world::Segment>(e).turns += turns;
    changed = true;
  }
  if (changed) derive(session);
}

// Restores everything that must hold after a change of the document.
void follow_document(Session& session, const Change& change, double twist_before) {
  world::settle_joints(session.document);
  derive(session);
  if (change.motion.kind == MotionFollowUp::Kind::split) share_turns(session, change.motion, twist_before);
  follow(change.motion, session.document, session.derived, session.motion);
  settle_motion(session);
  if (change.select) session.settings.selected = *change.select, session.settings.also = change.also;
  world::drop_dead(session.document, session.settings);
}

template <class C>
Status document_command(Session& session, const C& command, Change& change) {
  History& history = session.history;
  std::optional<world::Document> before;  // inside a gesture, the gesture's start is the snapshot
  if (!history.in_gesture) before = session.document;
  const Status status = perform(session, change, command);
  if (!status) return status;
  // The derived data are still those of the previous document.
  const sim::SegmentShape* const split = session.derived.segments.find(change.motion.first);
  follow_document(session, change, split ? split->twist : 0.0);
  if (history.in_gesture) history.gesture_label = print(command);
  else if (!(*before == session.document)) record(history, print(command), std::move(*before));
  return {};
}

template <class C>
Status settings_command(Session& session, const C& command, Change& change) {
  const Status status = perform(session, change, command);
  if (status && change.remeasure) derive(session);
  return status;
}

// Replaces the whole document by `exchange` (which returns false if there is nothing to exchange) and updates the rest.
template <class Exchange>
bool exchange_document(Session& session, Exchange exchange) {
  world::Document next = session.document;
  if (!exchange(next)) return false;
  follow_by_distance(session.document, next, session.derived, session.motion);
  session.document = std::move(next);
  fit_budget(session);
  derive(session);
  settle_motion(session);
  world::drop_dead(session.document, session.settings);
  return true;
}

Status cancel(Session& session) {
  exchange_document(session, [&](world::Document& d) { return cancel_gesture(session.history, d), true; });
  return {};
}

Status steps(Session& session, const Undo&) {
  if (session.history.in_gesture) return cancel(session);
  if (exchange_document(session, [&](world::Document& d) { return undo(session.history, d); })) return {};
  return refused("there is nothing to undo");
}
Status steps(Session& session, const Redo&) {
  if (session.history.in_gesture) return refused("a gesture is open");
  if (exchange_document(session, [&](world::Document& d) { return redo(session.history, d); })) return {};
  return refused("there is nothing to redo");
}
Status steps(Session& session, const BeginGesture&) {
  if (session.history.in_gesture) return refused("a gesture is open already");
  begin_gesture(session.history, session.document);
  return {};
}
Status steps(Session& session, const EndGesture&) {
  if (!session.history.in_gesture) return refused("no gesture is open");
  end_gesture(session.history, session.document);
  return {};
}
Status steps(Session& session, const CancelGesture&) {
  if (!session.history.in_gesture) return refused("no gesture is open");
  return cancel(session);
}

// Starts with another document: discards everything of the old one except settings.
void start_over(Session& session, world::Document document, std::filesystem::path path) {
  session.document = std::move(document);
  session.history = {};
  session.motion = {};
  session.settings.selected = world::kNone, session.settings.also.clear();
  session.settings.aids->append_mode = false;
  session.file.path = std::move(path);
  session.file.import.reset();
  session.game.challenge.reset();
  session.game.run = {};
  session.game.result.reset();
  session.game.show_result = false;
  session.file.saved_hash = world::hash(session.document);
  fit_budget(session);
  derive(session);
  sim::reset(session.document, session.derived, session.motion);
}

Status files_command(Session& session, base::Files& files, const Load& command) {
  std::optional<ReadAhead> ahead = std::exchange(session.file.read_ahead, std::nullopt);
  const bool read = ahead && ahead->path == command.path;
  base::Result<exchange::LoadedTrack> loaded =
      read ? std::move(ahead->track) : exchange::load_track(files, command.path);
  if (!loaded) return loaded.status();
  // A format that does not hold everything is an import: the next save needs a file name.
  start_over(session, std::move(loaded->document),
             exchange::format_of(command.path)->whole ? command.path : std::string());
  session.file.import = loaded->import;
  for (std::string& warning : loaded->warnings) notify(session, NoticeKind::warning, std::move(warning));
  return {};
}
Status files_command(Session& session, base::Files& files, const Save& command) {
  if (command.path.empty()) return refused("expected a file to save to");
  const Status status = exchange::save_track(files, command.path, session.document);
  if (!status) return status;
  // Saving in a format that does not hold everything is an export: the document stays unsaved.
  if (!exchange::format_of(command.path)->whole) {
    notify(session, NoticeKind::info, "exported " + command.path);
    return {};
  }
  session.file.path = command.path;
  session.file.saved_hash = world::hash(session.document);
  notify(session, NoticeKind::info, "saved " + command.path);
  return {};
}
Status files_command(Session& session, base::Files& files, const SaveMeasurements& command) {
  if (command.path.empty()) return refused("expected a file to write to");
  if (session.measuring.measurement.next == 0) return refused("nothing is measured yet");
  const Status status =
      files.write_atomic(command.path, sim::to_csv(session.measuring.measurement, session.measuring.machine));
  if (!status) return status;
  notify(session, NoticeKind::info, "saved " + command.path);
  return {};
}
Status files_command(Session& session, base::Files& files, const SaveReport& command) {
  if (command.path.empty()) return refused("expected a file to write to");
  const auto report = command.path.ends_with(".csv") ? ride_csv(session) : ride_report(session);
  if (!report) return refused("a report needs a track with a cart");
  const Status status = files.write_atomic(command.path, *report);
  if (!status) return status;
  notify(session, NoticeKind::info, "saved " + command.path);
  return {};
}
Status files_command(Session& session, base::Files& files, const LoadEnvelope& command) {
  base::Result<exchange::LoadedEnvelope> loaded = exchange::load_envelope(files, command.path);
  if (!loaded) return loaded.status();
  session.limits.envelope = std::move(loaded->envelope), session.limits.name = std::move(loaded->name);
  ++session.limits.serial;
  for (std::string& warning : loaded->warnings) notify(session, NoticeKind::warning, std::move(warning));
  notify(session, NoticeKind::info, "forces are held against " + session.limits.name + " (not a compliance check)");
  return {};
}
// The referee must be able to parse its rules.
Status files_command(Session& session, base::Files& files, const StartChallenge& command) {
  base::Result<exchange::LoadedChallenge> loaded = exchange::load_challenge(files, command.path);
  if (!loaded) return loaded.status();
  if (session.game.referee.check)
    if (const Status readable = session.game.referee.check(loaded->challenge, command.path); !readable) return readable;
  start_over(session, loaded->challenge.start, {});
  session.limits.envelope = sim::default_envelope(), session.limits.name = "default";
  ++session.limits.serial;
  session.game.challenge.emplace();
  session.game.challenge->shape = sim::trace_of(session.document);
  session.game.challenge->file = std::move(loaded->challenge);
  session.game.challenge->path = command.path;
  for (std::string& warning : loaded->warnings) notify(session, NoticeKind::warning, std::move(warning));
  return {};
}
Status files_command(Session& session, base::Files& files, const RecoverTrack& command) {
  base::Result<exchange::LoadedTrack> loaded = exchange::load_track(files, command.path);
  if (!loaded) return loaded.status();
  // It is compared with what the original file holds now; if that is another document, or there is none, it counts as
  // unsaved.
  const exchange::Format* const format = command.original.empty() ? nullptr : exchange::format_of(command.original);
  std::uint64_t saved = ~world::hash(loaded->document);
  if (format != nullptr && format->whole)
    if (const base::Result<exchange::LoadedTrack> old = exchange::load_track(files, command.original))
      saved = world::hash(old->document);
  start_over(session, std::move(loaded->document),
             format != nullptr && format->whole ? command.original : std::string());
  session.file.saved_hash = saved;
  for (std::string& warning : loaded->warnings) notify(session, NoticeKind::warning, std::move(warning));
  notify(session, NoticeKind::info,
         "recovered " + (command.original.empty() ? std::string("a track that had no file") : command.original));
  return {};
}
Status files_command(Session& session, base::Files&, const NewTrack&) {
  start_over(session, {}, {});
  return {};
}

using Perform = Status (*)(Session&, base::Files&, Change&, const Command&);
constexpr auto kPerform = Commands::table([]<class C>() -> Perform {
  return [](Session& session, [[maybe_unused]] base::Files& files, [[maybe_unused]] Change& change,
            const Command& command) -> Status {
    const C& c = *command.as<C>();
    if constexpr (C::kInfo.effect == Effect::document) return document_command(session, c, change);
    else if constexpr (C::kInfo.effect == Effect::settings) return settings_command(session, c, change);
    else if constexpr (C::kInfo.effect == Effect::motion) return perform(session, change, c);
    else if constexpr (C::kInfo.effect == Effect::history) return steps(session, c);
    else return files_command(session, files, c);
  };
});

}  // namespace

Status apply(Session& session, base::Files& files, const Command& command) {
  Change change;
  const Effect effect = info(command).effect;
  Status status = kPerform[index_of(command)](session, files, change, command);
  if (effect != Effect::settings && effect != Effect::motion) ++session.edits;
  if (status && (effect == Effect::document || effect == Effect::history)) watch_built(session);
  const std::string name(info(command).name);
  if (status.code == base::Code::refused) status.message = name + ": " + status.message;
  if (!status) notify(session, NoticeKind::error, status.message);
  else
    for (const std::string& line : change.clamped) notify(session, NoticeKind::warning, name + ": " + line);
  if (status && !change.note.empty()) notify(session, NoticeKind::info, name + ": " + change.note);
  return status;
}

}  // namespace coaster::edit
