// Commands that do not change the document: of settings, how things are shown and measured, and of the ride.
#include <algorithm>
#include <cmath>
#include <utility>

#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_settings.h"
#include "edit/perform/apply_setting.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/perform_context.h"
#include "edit/session/findings.h"
#include "edit/session/ride_report.h"
#include "exchange/challenge_file.h"
#include "sim/ground/ground.h"
#include "world/laboratory_settings.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::RideState;

constexpr float kMinDistance = 0.5f, kMaxDistance = 20'000;

// Selects the items that a command names. The last named one becomes active; for all or selected, the active one stays
// if it is among them.
template <class Several>
Status select_several(Session& session, base::Result<std::vector<world::Entity>> chosen, const Several& named) {
  if (!chosen) return chosen.status();
  world::Settings& settings = session.settings;
  world::Entity active =
      named.which == Knots::Which::named ? world::find(session.document, named.names.back()) : settings.selected;
  if (std::find(chosen->begin(), chosen->end(), active) == chosen->end()) active = chosen->back();
  std::erase(*chosen, active);
  settings.selected = active, settings.also = std::move(*chosen);
  return {};
}

// --- Commands of the ride

constexpr int kMaxStepTicks = 100'000;

Status rideable(const Session& session) {
  if (session.document.track.segments.empty()) return refused("the track has no segments: append knots first");
  if (session.document.entities.pool<world::Train>().size() == 0) return refused("there is no train: add one first");
  return {};
}

}  // namespace

std::string noun_of(std::string_view word) {
  std::string noun(word.substr(word.rfind('.') + 1));  // npos + 1 is 0
  std::replace(noun.begin(), noun.end(), '_', ' ');
  return noun;
}

Status perform(Session& session, Change& change, const SetCamera& command) {
  world::Camera camera = changed(session.settings.camera, command);
  camera.target = change.clamp_position("target", camera.target);
  camera.yaw_deg = std::remainder(camera.yaw_deg, 360.0f);
  camera.pitch_deg = change.clamp("pitch", camera.pitch_deg, -world::kMaxPitch, world::kMaxPitch, "degrees");
  camera.distance = change.clamp("distance", camera.distance, kMinDistance, kMaxDistance, "m");
  session.settings.camera = camera;
  return {};
}

Status perform(Session& session, Change& change, const SetFlyCamera& command) {
  world::FlyCamera fly = command.to;
  fly.eye = change.clamp_position("eye", fly.eye);
  const sim::Ground& ground = SessionFindings(session).ground();
  const double surface = ground.surface(static_cast<double>(fly.eye.x), static_cast<double>(fly.eye.z));
  fly.eye.y =
      change.clamp("height", fly.eye.y, world::kLowestFlight + static_cast<float>(surface), world::kMaxCoordinate, "m");
  fly.yaw_deg = std::remainder(fly.yaw_deg, 360.0f);
  fly.pitch_deg = change.clamp("pitch", fly.pitch_deg, -world::kMaxPitch, world::kMaxPitch, "degrees");
  session.settings.fly = fly;
  return {};
}

Status perform(Session& session, Change&, const SetPolyline& command) {
  session.settings.lab->layers.set(world::Layer::polyline, command.to);
  return {};
}
Status perform(Session& session, Change&, const ShowLayer& command) {
  if (const Status known = known_row(command.what); !known) return known;
  session.settings.lab->layers.set(command.what, command.to);
  return {};
}

Status perform(Session& session, Change&, const StartMeasuring&) {
  sim::Measurement started = sim::start_measurement(session.derived);
  if (!started.running) return refused("there is no segment to measure on");
  session.measuring.measurement = std::move(started);
  return {};
}
Status perform(Session& session, Change&, const StopMeasuring&) {
  session.measuring.measurement.running = false;
  return {};
}

Status perform(Session& session, Change&, const Select& command) {
  world::Settings& settings = session.settings;
  if (const Status on = within("a parameter t", command.at, 0, 1); !on) return on;
  if (command.what.name.number == 0) {
    settings.selected = world::kNone, settings.also.clear();
    return {};
  }
  const auto e = require(session, command.what, command.what.name.kind);
  if (!e) return e.status();
  if (command.what.name.kind == world::EntityKind::segment) settings.selected_t = command.at;
  settings.selected = *e, settings.also.clear();
  return {};
}

Status perform(Session& session, Change&, const SelectKnots& command) {
  return select_several(session, knots_of(session, command.knots), command.knots);
}
Status perform(Session& session, Change&, const SelectSections& command) {
  return select_several(session, chosen_sections(session, command.sections), command.sections);
}

Status perform(Session& session, Change& change, const SetSnapping& command) {
  session.settings.snapping = {command.to, change.clamp("step", command.step, 0.001, 1000.0, "m"),
                               change.clamp("angle", command.angle, 0.1, 180.0, "degrees")};
  return {};
}

Status perform(Session& session, Change&, const RideStart&) {
  if (const Status status = rideable(session); !status) return status;
  const bool over = session.motion.state == RideState::ended || session.motion.state == RideState::failed;
  const bool from_start = over || session.motion.state == RideState::stopped;
  watch_start(session, from_start);
  if (from_start) warn_of_deadlock(session);
  if (over) sim::reset(session.document, session.derived, session.motion);
  session.motion.state = RideState::running;
  return {};
}

Status perform(Session& session, Change&, const RidePause&) {
  if (const Status status = rideable(session); !status) return status;
  if (session.motion.state != RideState::running && session.motion.state != RideState::paused)
    return refused("the ride is not running");
  session.motion.state = RideState::paused;
  return {};
}

Status perform(Session& session, Change&, const RideStop&) {
  if (const Status status = rideable(session); !status) return status;
  sim::reset(session.document, session.derived, session.motion);
  watch_reset(session);
  return {};
}

Status perform(Session& session, Change& change, const RideStep& command) {
  if (const Status status = rideable(session); !status) return status;
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
  if (const Status status = rideable(session); !status) return status;
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
