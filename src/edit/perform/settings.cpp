// Commands on how things are shown and measured. They touch neither document nor motion.
#include <algorithm>
#include <cmath>
#include <utility>

#include "edit/perform/perform.h"
#include "sim/shape/frame_methods.h"

namespace coaster::edit {
namespace {

using base::Status;

constexpr std::int64_t kMinBudget = 1'000, kMaxBudget = 1'000'000'000;
constexpr float kMinDistance = 0.5f, kMaxDistance = 20'000;
constexpr double kMinMagnification = 1, kMaxMagnification = 1e7, kMinCombScale = 0.001, kMaxCombScale = 1e6;
constexpr float kMinScale = 0.75f, kMaxScale = 3;

// Commands read from text name rows; others may come from anywhere.
template <base::Named E>
Status known_row(E value) {
  if (base::has_row(value)) return {};
  return refused("there is no row " + std::to_string(static_cast<int>(value)) + " in the table of " +
                 std::to_string(base::count_of<E>()));
}

}  // namespace

Status perform(Session& session, Change& change, const SetEvaluator& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.evaluator = command.to;
  change.remeasure = true;
  return {};
}

Status perform(Session& session, Change& change, const SetResolution& command) {
  const int steps = change.clamp("resolution", command.to, curve::kMinSteps, curve::kMaxSteps);
  const Status room = within_budget(session.document.track.segments.size(), steps, session.settings.vertex_budget);
  if (!room) return room;
  session.settings.steps = steps;
  change.remeasure = true;
  return {};
}

Status perform(Session& session, Change& change, const SetVertexBudget& command) {
  const std::int64_t budget = change.clamp("vertex budget", command.to, kMinBudget, kMaxBudget);
  const Status room = within_budget(session.document.track.segments.size(), session.settings.steps, budget);
  if (!room) return room;
  session.settings.vertex_budget = budget;
  return {};
}

Status perform(Session& session, Change& change, const SetArcLength& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.arc_length = command.to;
  change.remeasure = true;
  return {};
}

Status perform(Session& session, Change&, const SetFrames& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.frames = command.to;
  return {};
}

Status perform(Session& session, Change&, const SetIntegrator& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.integrator = command.to;
  return {};
}

Status perform(Session& session, Change& change, const SetCamera& command) {
  world::Camera camera = command.to;
  if (!finite(camera.target) || !std::isfinite(camera.yaw_deg) || !std::isfinite(camera.pitch_deg) ||
      !std::isfinite(camera.distance))
    return refused("expected finite numbers");
  camera.target = change.clamp_position("target", camera.target);
  camera.yaw_deg = std::remainder(camera.yaw_deg, 360.0f);
  camera.pitch_deg = change.clamp("pitch", camera.pitch_deg, -world::kMaxPitch, world::kMaxPitch, "degrees");
  camera.distance = change.clamp("distance", camera.distance, kMinDistance, kMaxDistance, "m");
  camera.field_of_view_deg = session.settings.camera.field_of_view_deg;  // has a command of its own
  session.settings.camera = camera;
  return {};
}

Status perform(Session& session, Change&, const SetPanels& command) {
  session.settings.show_panels = command.to;
  return {};
}
Status perform(Session& session, Change&, const SetPolyline& command) {
  session.settings.layers.set(world::Layer::polyline, command.to);
  return {};
}
Status perform(Session& session, Change&, const SetAppendMode& command) {
  session.settings.append_mode = command.to;
  return {};
}

Status perform(Session& session, Change&, const ShowLayer& command) {
  const Status known = known_row(command.what);
  if (!known) return known;
  session.settings.layers.set(command.what, command.to);
  return {};
}
Status perform(Session& session, Change&, const SetColouring& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.colouring = command.to;
  return {};
}
Status perform(Session& session, Change& change, const SetMagnification& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite magnification");
  session.settings.magnification = change.clamp("magnification", command.to, kMinMagnification, kMaxMagnification);
  return {};
}
Status perform(Session& session, Change& change, const SetCombScale& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite scale");
  session.settings.comb_scale = change.clamp("comb scale", command.to, kMinCombScale, kMaxCombScale);
  return {};
}
Status perform(Session& session, Change&, const ShowLaboratory& command) {
  session.settings.show_laboratory = command.to;
  return {};
}
Status perform(Session& session, Change&, const OpenPage& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.lab_page = command.to;
  return {};
}

Status perform(Session& session, Change&, const Measure&) {
  sim::Measurement started = sim::start_measurement(session.derived);
  if (!started.running) return refused("there is no segment to measure on");
  session.measuring.measurement = std::move(started);
  return {};
}
Status perform(Session& session, Change&, const StopMeasuring&) {
  session.measuring.measurement.running = false;
  return {};
}

Status perform(Session& session, Change&, const SetTheme& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.theme = command.to;
  return {};
}

Status perform(Session& session, Change&, const SetStyle& command) {
  const Status known = known_row(command.to);
  if (!known) return known;
  session.settings.style = command.to;
  return {};
}

Status perform(Session& session, Change&, const SetShadows& command) {
  session.settings.shadows = command.on;
  return {};
}

Status perform(Session& session, Change& change, const SetSound& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite number");
  session.settings.sound = change.clamp("sound", command.to, 0.0f, 1.0f);
  return {};
}

Status perform(Session& session, Change& change, const SetScale& command) {
  if (!std::isfinite(command.to)) return refused("expected a finite scale");
  session.settings.ui_scale = change.clamp("scale", command.to, kMinScale, kMaxScale);
  return {};
}

}  // namespace coaster::edit
