// The session's small functions: notices, ticks, a new session. apply.cpp changes it.
#include "edit/session/session.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file_lock.h"
#include "base/hash.h"
#include "base/text.h"
#include "edit/session/ride_report.h"
#include "exchange/own/share_link.h"
#include "sim/plan/force_plan.h"
#include "sim/shape/folds.h"
#include "world/evaluation_settings.h"
#include "world/sections.h"

namespace coaster::edit {
namespace {

// --- Undo and redo by the differences between documents, bit by bit: exact by construction, with memory proportional
// to the changes

// Applies the newest step of one stack and moves it to the other. Its size may change: the other side may be larger.
template <class From, class To>
bool step_over(History& history, From& from, To& to, world::Document& document) {
  if (from.empty()) return false;
  HistoryStep step = std::move(from.back());
  from.pop_back();
  history.bytes -= bytes_of(step);
  world::exchange(step.change, document);
  history.bytes += bytes_of(step);
  to.push_back(std::move(step));
  return true;
}

// The labels of buttons that differ from their command's name.
constexpr std::pair<std::string_view, std::string_view> kLabels[] = {
    {"auto_bank", "Auto-bank"},    {"complete", "Complete circuit"}, {"equalise", "Equalise handles"},
    {"equip", "Equipment"},        {"losses.set", "Losses"},         {"seek", "Goal"},
    {"section.equip", "Equipment"}};

std::string label_of(std::string_view command) {
  const auto* const row = std::ranges::find(kLabels, command, &std::pair<std::string_view, std::string_view>::first);
  if (row != std::end(kLabels)) return std::string(row->second);
  std::string words(command);
  for (char& c : words)
    if (c == '_' || c == '.') c = ' ';
  words = base::sentence(std::move(words));
  words.pop_back();
  return words;
}

}  // namespace

void notify(Session& session, NoticeKind kind, std::string text) {
  constexpr std::size_t kMost = 32;
  std::vector<Notice>& notices = session.notices.list;
  const std::uint64_t serial = ++session.notices.serial;
  // A drag along a limit gives the same notice at every move, so it is renewed instead of repeated.
  if (!notices.empty() && notices.back().kind == kind && notices.back().text == text) {
    notices.back().serial = serial;
    return;
  }
  if (notices.size() == kMost) notices.erase(notices.begin());
  notices.push_back({kind, std::move(text), serial});
}

void notify(Session& session, const base::Status& error) {
  const bool refused = error.code == base::Code::refused;
  notify(session, NoticeKind::error, refused ? base::sentence(error.message) : error.message);
}

bool dirty(const SessionFindings& find) {
  const History& history = find.session().history;
  if (history.in_gesture && !history.gesture_text.command.empty()) return true;
  return find.document_hash() != find.session().file.saved_hash;
}

std::string link_of(const Session& session) {
  const world::Settings& s = session.settings;
  return exchange::print_link(session.document,
                              {s.camera_mode, s.camera, s.fly, s.evaluation->evaluator, s.evaluation->steps});
}

bool is_own_file(const Session& session, const std::filesystem::path& path) {
  const std::filesystem::path& own = session.file.path;
  return !own.empty() && base::canonical_path(path) == base::canonical_path(own);
}

std::optional<std::uint64_t> content_of(const std::filesystem::path& path) {
  const auto bytes = base::Files().read(path);  // without the faults that a script injects
  if (!bytes) return std::nullopt;
  return base::content_hash(*bytes);
}

bool changed_outside(const Session& session) {
  const std::filesystem::path& own = session.file.path;
  std::error_code failed;
  if (own.empty() || !std::filesystem::exists(own, failed)) return false;
  const std::optional<std::uint64_t> now = content_of(own);
  return !now || now != session.file.content;
}

void advance_measurement(Session& session) {
  sim::measure_next(session.measuring.measurement, session.measuring.clock);
}

world::Entity chosen_cart(const Session& session) {
  const bool selected = session.document.entities.find<world::Train>(session.settings.selected) != nullptr;
  return selected ? session.settings.selected : world::first_cart(session.document);
}

const sim::ForceLimitCurves& force_limits(const Session& session) {
  return session.limits.loaded ? *session.limits.loaded : sim::default_envelope(session.document.kind);
}

std::string failure_text(const Session& session) {
  const world::RideFailure& failure = session.motion.failure;
  if (failure.kind == world::FailureKind::none) return {};
  const std::optional<RideResult>& result = session.game.result;
  if (result && result->end == RideEnd::failed && !session.game.run.under_way)
    return fmt::format("Train {} {}.", world::label_of(session.document, failure.cart), result->reason);
  return fmt::format("Train {} {} at {:.1f} m ({:.1f} m/s).", world::label_of(session.document, failure.cart),
                     base::name_of(failure.kind), failure.distance, failure.speed);
}

void warn_of_deadlock(Session& session) {
  const std::string text = sim::deadlock_text(session.document, session.derived);
  if (!text.empty()) notify(session, NoticeKind::warning, text + ". All will wait for a free block.");
}

void advance(Session& session, int ticks) {
  if (ticks <= 0) return;
  const world::FailureKind before = session.motion.failure.kind;
  const bool timed = session.measuring.clock && session.motion.state == world::RideState::running;
  const double start = timed ? session.measuring.clock() : 0.0;
  // A challenge's ride is checked tick by tick, so that its verdict does not depend on how many ticks are requested at
  // once.
  const bool watched =
      session.game.challenge && session.game.run.under_way && session.motion.state == world::RideState::running;
  for (int done = 0; done < ticks;) {
    const int some = watched && session.game.run.under_way ? 1 : ticks - done;
    const bool running = session.motion.state == world::RideState::running;
    sim::step(session.document, session.derived, session.settings.integrator, some, rides_of(session), session.motion);
    if (running) watch_ticks(session, some);
    done += some;
  }
  if (timed) {
    constexpr double kNewest = 0.1;
    const double ns = (session.measuring.clock() - start) * 1e9 / ticks;
    double& mean = session.measuring.ride_cost.ns_per_tick;
    mean = mean > 0 ? mean + kNewest * (ns - mean) : ns;
  }
  if (session.motion.failure.kind != before) notify(session, NoticeKind::warning, failure_text(session));
  session.tick += static_cast<std::uint64_t>(ticks);
}

Session make_session(sim::Clock clock) {
  Session session;
  session.measuring.clock = std::move(clock);
  session.file.saved_hash = world::hash(session.document);
  sim::derive(session.document, session.settings, session.measuring.clock, session.derived);
  return session;
}

bool is_locked(const Session& session, std::string_view command) {
  if (!session.game.challenge) return false;
  const std::vector<std::string>& locks = session.game.challenge->file.locks;
  return std::ranges::find(locks, command) != locks.end();
}

std::string locked_text(const std::vector<std::string>& commands) {
  std::vector<std::string> labels;
  for (const std::string& command : commands)
    if (std::string label = label_of(command); std::ranges::find(labels, label) == labels.end())
      labels.push_back(std::move(label));
  return fmt::format("Locked in this challenge: {}.", fmt::join(labels, ", "));
}

std::size_t bytes_of(const HistoryStep& step) {
  return sizeof(HistoryStep) - sizeof(world::DocumentDifference) + step.text.command.capacity() +
         step.text.sentence.capacity() + world::bytes_of(step.change);
}

void record(History& history, StepText text, world::Document before, const world::Document& after) {
  for (const HistoryStep& step : history.redo) history.bytes -= bytes_of(step);
  history.redo.clear();
  history.undo.push_back({std::move(text), world::difference_of(std::move(before), after)});
  history.bytes += bytes_of(history.undo.back());
  while (history.undo.size() > 1 && history.bytes > history.limit) {
    history.bytes -= bytes_of(history.undo.front());
    history.undo.pop_front();
    ++history.dropped;
  }
}

bool undo(History& history, world::Document& document) {
  return step_over(history, history.undo, history.redo, document);
}

bool redo(History& history, world::Document& document) {
  return step_over(history, history.redo, history.undo, document);
}

void begin_gesture(History& history, const world::Document& document) {
  history.in_gesture = true;
  history.gesture_start = document;
  history.gesture_text = {};
}

void end_gesture(History& history, const world::Document& document) {
  history.in_gesture = false;
  world::Document start = std::exchange(history.gesture_start, {});
  if (!(start == document)) record(history, history.gesture_text, std::move(start), document);
}

void cancel_gesture(History& history, world::Document& document) {
  history.in_gesture = false;
  document = std::exchange(history.gesture_start, {});
}

}  // namespace coaster::edit
