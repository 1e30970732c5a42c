// Commands of settings: how things are shown and measured. They change neither document nor motion.
#include <algorithm>
#include <cmath>
#include <utility>

#include "edit/commands/commands_lab.h"
#include "edit/commands/commands_settings.h"
#include "edit/perform/apply_setting.h"
#include "edit/perform/knot_runs.h"
#include "edit/session/findings.h"
#include "sim/ground/ground.h"
#include "world/laboratory_settings.h"

namespace coaster::edit {
namespace {

using base::Status;

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
  const Status known = known_row(command.what);
  if (!known) return known;
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

}  // namespace coaster::edit
