// Commands of the ride.
#include <algorithm>

#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_ride.h"
#include "edit/perform/perform_context.h"
#include "edit/session/ride_watch.h"
#include "exchange/challenge_file.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::RideState;

constexpr int kMaxStepTicks = 100'000;

Status rideable(const Session& session) {
  if (session.document.track.segments.empty()) return refused("the track has no segments: append knots first");
  if (session.document.entities.pool<world::Train>().size() == 0) return refused("there is no train: add one first");
  return {};
}

}  // namespace

Status perform(Session& session, Change&, const RideStart&) {
  const Status status = rideable(session);
  if (!status) return status;
  const bool over = session.motion.state == RideState::ended || session.motion.state == RideState::failed;
  const bool from_start = over || session.motion.state == RideState::stopped;
  watch_start(session, from_start);
  if (from_start) warn_of_deadlock(session);
  if (over) sim::reset(session.document, session.derived, session.motion);
  session.motion.state = RideState::running;
  return {};
}

Status perform(Session& session, Change&, const RidePause&) {
  const Status status = rideable(session);
  if (!status) return status;
  if (session.motion.state != RideState::running && session.motion.state != RideState::paused)
    return refused("the ride is not running");
  session.motion.state = RideState::paused;
  return {};
}

Status perform(Session& session, Change&, const RideStop&) {
  const Status status = rideable(session);
  if (!status) return status;
  sim::reset(session.document, session.derived, session.motion);
  watch_reset(session);
  return {};
}

Status perform(Session& session, Change& change, const RideStep& command) {
  const Status status = rideable(session);
  if (!status) return status;
  if (session.motion.state == RideState::running) return refused("the ride is running: pause it first");
  if (session.motion.state == RideState::ended || session.motion.state == RideState::failed)
    return refused("the ride has ended: stop or start it first");
  const int ticks = change.clamp("ticks", command.ticks, 1, kMaxStepTicks);
  if (session.motion.state == RideState::stopped) watch_start(session, true);
  session.motion.state = RideState::running;
  sim::step(session.document, session.derived, session.settings.integrator, ticks, rides_of(session), session.motion);
  watch_ticks(session, ticks);
  if (session.motion.state == RideState::running) session.motion.state = RideState::paused;
  return {};
}

Status perform(Session& session, Change&, const RideSeek& command) {
  const Status status = rideable(session);
  if (!status) return status;
  const double length = session.derived.length, end = std::max(length, double{static_cast<float>(length)});
  if (const Status on = within("a distance along the track", command.to, 0, end, "m"); !session.derived.closed && !on)
    return on;
  const double distance = session.derived.closed ? command.to : std::min(command.to, length);
  sim::seek(session.document, session.derived, chosen_cart(session), distance, session.motion);
  // Stopped means at the start, ended and failed at an end: a moved train is in none of these states.
  session.motion.failure = {};
  watch_disturbed(session);
  if (session.motion.state != RideState::running) session.motion.state = RideState::paused;
  return {};
}

// The referee must be able to parse its rules.
Status perform(Session& session, Change& change, const StartChallenge& command) {
  base::Result<exchange::LoadedChallenge> loaded = exchange::load_challenge(change.files, command.path);
  if (!loaded) return loaded.status();
  if (session.game.referee.check)
    if (const Status readable = session.game.referee.check(loaded->challenge, command.path); !readable) return readable;
  start_over(session, loaded->challenge.start, {});
  session.limits.loaded.reset(), session.limits.name = "default";
  ++session.limits.serial;
  session.game.challenge.emplace();
  session.game.challenge->shape = sim::trace_of(session.document);
  session.game.challenge->file = std::move(loaded->challenge);
  session.game.challenge->path = command.path;
  warn(session, loaded->warnings);
  return {};
}

Status perform(Session& session, Change&, const LeaveChallenge&) {
  if (!session.game.challenge) return refused("there is no challenge to leave");
  session.game.challenge.reset();
  if (session.game.result) session.game.result->verdict.reset();
  return {};
}

Status perform(Session& session, Change&, const ShowHint&) {
  if (!session.game.challenge) return refused("there is no challenge");
  ActiveChallenge& challenge = *session.game.challenge;
  if (challenge.hints >= static_cast<int>(challenge.file.hints.size())) return refused("there is no further hint");
  ++challenge.hints;
  return {};
}

Status perform(Session& session, Change&, const CloseCard&) {
  session.game.show_result = false;
  return {};
}

}  // namespace coaster::edit
