// The commands of the cameras but for the orbit camera's own place, which is SetCamera in commands.h.
#pragma once

#include "edit/commands/command_fields.h"
#include "world/settings.h"

namespace coaster::edit {

struct SetCameraMode {
  world::CameraMode to{};
  COASTER_COMMAND("camera_mode",
                  "Look by orbit, from the first cart (ride), from behind its train (chase), or freely (fly).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetFly {
  world::FlyCamera to;
  COASTER_COMMAND("camera.fly",
                  "Put the free camera at a place (m), looking at yaw and pitch (degrees; yaw 0 is -Z, pitch up).",
                  Effect::settings);
  COASTER_FIELDS(visit("eye", self.to.eye), visit("yaw", self.to.yaw_deg), visit("pitch", self.to.pitch_deg))
};
struct SetFieldOfView {
  float to = world::Camera{}.field_of_view_deg;
  COASTER_COMMAND("camera.field_of_view",
                  "Set the vertical field of view of all cameras but the rider's (30..110 degrees).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetRideView {
  float to = world::CameraFeel{}.ride_view_deg;
  COASTER_COMMAND("camera.ride_view", "Set the rider's vertical field of view (30..110 degrees).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetWidening {
  float to = world::CameraFeel{}.widening_deg;
  COASTER_COMMAND("camera.widening", "Set by how much the rider's view has widened at 30 m/s (0..20 degrees).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetRollDamping {
  float to = world::CameraFeel{}.roll_damping;
  COASTER_COMMAND("camera.roll_damping", "Set how late the rider's roll follows the track's (0..2 s; 0 is at once).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetChaseDistance {
  float to = world::CameraFeel{}.chase_distance;
  COASTER_COMMAND("camera.chase_distance", "Set how far the chase camera is from a lone car (5..60 m).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetHeadBob {
  bool to = true;
  COASTER_COMMAND("camera.head_bob", "Let the rider's head give way to g (on, off).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetReducedMotion {
  bool to = true;
  COASTER_COMMAND("camera.reduced_motion",
                  "Keep the rider's horizon level, cut between cameras, no bobbing, no widening (on, off).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};

}  // namespace coaster::edit
