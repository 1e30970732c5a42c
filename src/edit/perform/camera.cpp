// Commands of the cameras. They touch neither document nor motion.
#include <cmath>

#include "edit/perform/perform.h"

namespace coaster::edit {
namespace {

using base::Status;

constexpr float kMaxWidening = 20, kMaxRollDamping = 2;  // degrees, s

// One number of the settings, cut to its limits.
Status set(Change& change, std::string_view what, float to, float low, float high, std::string_view unit,
           float& value) {
  if (!std::isfinite(to)) return refused("expected a finite number");
  value = change.clamp(what, to, low, high, unit);
  return {};
}

}  // namespace

Status perform(Session& session, Change&, const SetCameraMode& command) {
  if (!base::has_row(command.to)) return refused("there is no such camera");
  session.settings.camera_mode = command.to;
  return {};
}

Status perform(Session& session, Change& change, const SetFly& command) {
  world::FlyCamera fly = command.to;
  if (!finite(fly.eye) || !std::isfinite(fly.yaw_deg) || !std::isfinite(fly.pitch_deg))
    return refused("expected finite numbers");
  fly.eye = change.clamp_position("eye", fly.eye);
  fly.eye.y = change.clamp("height", fly.eye.y, world::kLowestFlight, world::kMaxCoordinate, "m");
  fly.yaw_deg = std::remainder(fly.yaw_deg, 360.0f);
  fly.pitch_deg = change.clamp("pitch", fly.pitch_deg, -world::kMaxPitch, world::kMaxPitch, "degrees");
  session.settings.fly = fly;
  return {};
}

Status perform(Session& session, Change& change, const SetFieldOfView& command) {
  float& degrees = session.settings.camera.field_of_view_deg;
  return set(change, "field of view", command.to, world::kMinFieldOfView, world::kMaxFieldOfView, "degrees", degrees);
}
Status perform(Session& session, Change& change, const SetRideView& command) {
  float& degrees = session.settings.feel.ride_view_deg;
  return set(change, "field of view", command.to, world::kMinFieldOfView, world::kMaxFieldOfView, "degrees", degrees);
}
Status perform(Session& session, Change& change, const SetWidening& command) {
  return set(change, "widening", command.to, 0, kMaxWidening, "degrees", session.settings.feel.widening_deg);
}
Status perform(Session& session, Change& change, const SetRollDamping& command) {
  return set(change, "roll damping", command.to, 0, kMaxRollDamping, "s", session.settings.feel.roll_damping);
}
Status perform(Session& session, Change& change, const SetChaseDistance& command) {
  return set(change, "chase distance", command.to, world::kMinChase, world::kMaxChase, "m",
             session.settings.feel.chase_distance);
}

Status perform(Session& session, Change&, const SetHeadBob& command) {
  session.settings.feel.head_bob = command.to;
  return {};
}
Status perform(Session& session, Change&, const SetReducedMotion& command) {
  session.settings.feel.reduced_motion = command.to;
  return {};
}

}  // namespace coaster::edit
