// Applies every command to the session and updates what depends on it: joints, derived data, carts, history, notices.
#include "edit/perform/apply.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "edit/commands/codec.h"
#include "edit/commands/command_list.h"
#include "edit/perform/apply_setting.h"
#include "edit/perform/change_propagation.h"
#include "edit/perform/job_result.h"
#include "edit/perform/perform_context.h"
#include "edit/session/ride_report.h"
#include "edit/session/session.h"
#include "sim/shape/folds.h"

namespace coaster::edit {
namespace {

using base::Status;

template <class T>
bool finite(const T& value) {
  if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
  else if constexpr (std::is_same_v<T, glm::vec3>) return finite(value.x) && finite(value.y) && finite(value.z);
  else if constexpr (std::is_same_v<T, glm::vec2>) return finite(value.x) && finite(value.y);
  else if constexpr (requires { value.level; }) return finite(value.level);
  else if constexpr (std::is_same_v<T, world::Element>) return std::ranges::all_of(value.values, finite<double>);
  else if constexpr (requires { value.has_value(); }) return !value || finite(*value);
  else if constexpr (requires { T::fields(value, [](std::string_view, const auto&) {}); }) {
    bool all = true;
    T::fields(value, [&](std::string_view, const auto& part) { all = all && finite(part); });
    return all;
  } else return true;
}

// Refuses a command whose entity does not exist, or whose numbers are not finite.
template <class C>
Status checked(const Session& session, const C& command) {
  Status status;
  C::fields(command, [&]<class T>(std::string_view, const T& value) {
    if constexpr (std::is_same_v<T, Target>)
      if (const auto kind = named_kind<C>(); kind && status) status = require(session, value, *kind).status();
    if (status && !finite(value)) status = refused("expected finite numbers");
  });
  return status;
}

using Perform = Status (*)(Session&, Change&, const Command&);
constexpr auto kPerform = Commands::table([]<class C>() -> Perform {
  return [](Session& session, Change& change, const Command& command) -> Status {
    const C& one = *command.as<C>();
    const Status status = checked(session, one);
    return status ? perform(session, change, one) : status;
  };
});

// Performs the command alone, whatever its effect.
Status perform_one(Session& session, Change& change, const Command& command) {
  return kPerform[index_of(command)](session, change, command);
}

Status document_command(Session& session, Change& change, const Command& command) {
  History& history = session.history;
  std::optional<world::Document> before;  // inside a gesture, the gesture's start is the snapshot
  if (!history.in_gesture) before = session.document;
  // An interrupted command leaves the document as it was: for the autosave, or, after Cancel, for settle().
  const auto stopped = [&, motion = session.motion, settings = session.settings](const Status& status) {
    if (!base::interrupted()) return status;
    session.document = before ? std::move(*before) : history.gesture_start;
    session.motion = motion, session.settings = settings;
    return refused("stopped");
  };
  const std::vector<PlannedSection> planned = planned_sections(session.document);
  const Status status = perform_one(session, change, command);
  if (!status || base::interrupted()) return stopped(status);
  change.search = nullptr;  // the document has changed: the command can no longer be refused
  follow_change(session, change, planned);
  if (base::interrupted()) return stopped(status);
  const auto text = [&](const world::Document& from) { return StepText{print(command), done(command, from)}; };
  if (history.in_gesture) {
    history.gesture_text = text(history.gesture_start);
  } else if (!(*before == session.document)) {
    StepText step = text(*before);
    record(history, std::move(step), std::move(*before), session.document);
  }
  return {};
}

Status settings_command(Session& session, Change& change, const Command& command) {
  const Status status = perform_one(session, change, command);
  const base::JobScope whole(nullptr);
  if (status && change.remeasure) derive(session);
  return status;
}

// Replaces the whole document by `exchange` (which returns false if there is nothing to exchange) and updates the rest.
template <class Exchange>
bool exchange_document(Session& session, Exchange exchange) {
  world::Document next = session.document;
  if (!exchange(next)) return false;
  const base::JobScope whole(nullptr);
  follow_by_distance(session.document, next, session.derived, session.motion);
  session.document = std::move(next);
  fit_budget(session);
  derive(session);
  settle_trains(session);
  return true;
}

Status cancel(Session& session, Change& change) {
  // It also replaces a notice of what the gesture did.
  if (!(session.document == session.history.gesture_start))
    change.note = fmt::format("Cancelled: {}.", session.history.gesture_text.sentence);
  exchange_document(session, [&](world::Document& d) { return cancel_gesture(session.history, d), true; });
  return {};
}

// Refused for a command that the challenge locks.
Status allowed(const Session& session, const Command& command) {
  const std::string_view name = info(command).name;
  return is_locked(session, name) ? refused(locked_text({std::string(name)})) : Status{};
}

// Tells of tight bends when there are more than before, at the end of a gesture.
void warn_of_tight_bends(Session& session) {
  if (session.history.in_gesture) return;
  const std::span<const sim::TightBend> bends = SessionFindings(session).tight_bends();
  if (bends.size() > std::exchange(session.notices.tight, bends.size()))
    notify(session, NoticeKind::warning, sim::tight_text(bends) + ". No train can pass there.");
}

Status carry_out(Session& session, base::Files& files, const Command& command, ClosingSearch* search) {
  Change change{files, search};
  const Effect effect = info(command).effect;
  const bool complete = session.history.dropped == 0;
  const Status open = allowed(session, command);
  const Status status = !open                        ? open
                        : effect == Effect::document ? document_command(session, change, command)
                        : effect == Effect::settings ? settings_command(session, change, command)
                                                     : perform_one(session, change, command);
  if (search && search->wanted) return status;  // to be applied again: nothing has happened
  if (effect != Effect::settings && effect != Effect::motion) ++session.edits;
  if (!status && base::interrupted()) return status;
  const base::JobScope whole(nullptr);  // it is done: Cancel comes too late
  if (base::interrupted()) return refused("stopped");
  if (!status) {
    notify(session, status);
    return status;
  }
  if (effect == Effect::document || effect == Effect::history) watch_built(session);
  if (effect != Effect::settings && effect != Effect::motion) warn_of_tight_bends(session);
  for (const std::string& line : change.clamped) notify(session, NoticeKind::warning, line);
  if (complete && session.history.dropped > 0)
    notify(session, NoticeKind::warning, "The history is full: its oldest steps are dropped.");
  if (!change.note.empty()) notify(session, NoticeKind::info, change.note);
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const Undo&) {
  if (session.history.in_gesture) return cancel(session, change);
  if (!exchange_document(session, [&](world::Document& d) { return undo(session.history, d); }))
    return refused("there is nothing to undo");
  change.note = fmt::format("Undo: {}.", session.history.redo.back().text.sentence);
  return {};
}
Status perform(Session& session, Change& change, const Redo&) {
  if (session.history.in_gesture) return refused("a gesture is open");
  if (!exchange_document(session, [&](world::Document& d) { return redo(session.history, d); }))
    return refused("there is nothing to redo");
  change.note = fmt::format("Redo: {}.", session.history.undo.back().text.sentence);
  return {};
}
Status perform(Session& session, Change&, const BeginGesture&) {
  if (session.history.in_gesture) return refused("a gesture is open already");
  begin_gesture(session.history, session.document);
  return {};
}
Status perform(Session& session, Change&, const EndGesture&) {
  if (!session.history.in_gesture) return refused("no gesture is open");
  end_gesture(session.history, session.document);
  return {};
}
Status perform(Session& session, Change& change, const CancelGesture&) {
  if (!session.history.in_gesture) return refused("no gesture is open");
  return cancel(session, change);
}

void settle(Session& session) {
  derive(session);
  settle_trains(session);
}

Status apply(Session& session, base::Files& files, const Command& command, ClosingSearch* search) {
  const std::uint64_t serial = session.notices.serial;
  const Status status = carry_out(session, files, command, search);
  if (session.notices.serial != serial) session.notices.before = serial;
  return status;
}

}  // namespace coaster::edit
