// Commands for settings with several values; those with one value use edit::Set (edit/commands/set_setting.h). They
// change neither document nor motion. The laboratory's commands: layers over the scene, and measurements.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "world/settings.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Settings);

struct SetCamera {
  CameraChange to;
  COASTER_COMMAND(SetCamera, "camera", "Look at a target (m) from a distance (m) at yaw and pitch (degrees).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
// Returns the command that sets all four values.
inline SetCamera set_camera(const world::Camera& to) { return {{to.target, to.yaw_deg, to.pitch_deg, to.distance}}; }
// Returns a camera with the values that the command gives.
inline world::Camera changed(world::Camera camera, const SetCamera& command) {
  camera.target = command.to.target.value_or(camera.target);
  camera.yaw_deg = command.to.yaw_deg.value_or(camera.yaw_deg);
  camera.pitch_deg = command.to.pitch_deg.value_or(camera.pitch_deg);
  camera.distance = command.to.distance.value_or(camera.distance);
  return camera;
}
struct SetFlyCamera {
  world::FlyCamera to;
  COASTER_COMMAND(SetFlyCamera, "camera.fly",
                  "Put the free camera at a place (m), looking at yaw and pitch (degrees; yaw 0 is -Z, pitch up).",
                  Effect::settings);
  COASTER_FIELDS(visit("eye", self.to.eye), visit("yaw", self.to.yaw_deg), visit("pitch", self.to.pitch_deg))
};
struct Select {
  Target what;
  double at = 0.5;
  COASTER_COMMAND(Select, "select", "Select a knot, a train, or a segment with a place on it; none clears.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.what), visit(":at?", self.at))
};
struct SelectKnots {
  Knots knots;
  COASTER_COMMAND(SelectKnots, "select_knots", "Select several knots; the last one named is the active one.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.knots))
};
struct SelectSections {
  Sections sections;
  COASTER_COMMAND(SelectSections, "select_sections", "Select several sections; the last one named is the active one.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.sections))
};
struct SetSnapping {
  world::SnapTo to{};
  double step = world::Snapping{}.step, angle = world::Snapping{}.angle;
  COASTER_COMMAND(
      SetSnapping, "snapping",
      "Snap dragged knots to a grid (step in m), to other knots or to the ground, and rotations to an angle (degrees).",
      Effect::settings);
  COASTER_FIELDS(visit("", self.to), visit("step?", self.step), visit("angle?", self.angle))
};
struct SetPolyline {
  bool to = true;
  COASTER_COMMAND(SetPolyline, "polyline",
                  "Show or hide the evaluated polyline over the track (on, off); the same as show polyline.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};

COASTER_COMMAND_LIST(Settings, SetCamera, SetFlyCamera, Select, SelectKnots, SelectSections, SetSnapping, SetPolyline);

COASTER_COMMAND_GROUP(Lab);

struct ShowLayer {
  world::Layer what{};
  bool to = true;
  COASTER_COMMAND(ShowLayer, "show", "Show or hide one of the laboratory's pictures over the scene.", Effect::settings);
  COASTER_FIELDS(visit("", self.what), visit("", self.to))
};
// Measures the table of sim/study/evaluator_benchmark.h, a part per frame.
struct StartMeasuring {
  COASTER_COMMAND(
      StartMeasuring, "measure",
      "Measure time and error of every evaluator on this machine, a part in each frame, on the curves of this track.",
      Effect::settings);
  COASTER_FIELDS()
};
struct StopMeasuring {
  COASTER_COMMAND(StopMeasuring, "measure.stop", "Stop measuring; results so far are kept.", Effect::settings);
  COASTER_FIELDS()
};
struct SaveMeasurements {
  std::string path;
  COASTER_COMMAND(SaveMeasurements, "measure.save", "Write the measurements to a file of comma-separated values.",
                  Effect::session, {}, kWritesFile);
  COASTER_FIELDS(visit("", self.path))
};

COASTER_COMMAND_LIST(Lab, ShowLayer, StartMeasuring, StopMeasuring, SaveMeasurements);

}  // namespace coaster::edit
