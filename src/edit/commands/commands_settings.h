// Commands on how things are shown and measured: they change settings alone, neither document nor motion. Those of the
// cameras and of the laboratory have files of their own.
#pragma once

#include <cstdint>

#include "edit/commands/command_fields.h"
#include "world/settings.h"

namespace coaster::edit {

struct SetEvaluator {
  curve::EvaluatorId to{};
  COASTER_COMMAND("evaluator", "Choose how polylines are evaluated.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetResolution {
  int to = 64;
  COASTER_COMMAND("resolution", "Set the polyline's steps per segment (1..4096).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetVertexBudget {
  std::int64_t to = 16'000'000;
  COASTER_COMMAND("vertex_budget", "Set how many vertices all polylines together may have.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetArcLength {
  curve::ArcLengthId to{};
  COASTER_COMMAND("arc_length", "Choose how the displayed length is measured.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetFrames {
  world::FrameMethod to{};
  COASTER_COMMAND("frames_by",
                  "Turn carts by the knots' banked frames (knots), rotation-minimising along the track (rmf), "
                  "Frenet-Serret (frenet) or upright (world_up).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetIntegrator {
  world::IntegratorId to{};
  COASTER_COMMAND("integrator", "Choose how carts move.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetCamera {
  world::Camera to;
  COASTER_COMMAND("camera", "Look at a target (m) from a distance (m) at yaw and pitch (degrees).", Effect::settings);
  COASTER_FIELDS(visit("target", self.to.target), visit("yaw", self.to.yaw_deg), visit("pitch", self.to.pitch_deg),
                 visit("distance", self.to.distance))
};
struct Select {
  Target what;
  double at = 0.5;
  COASTER_COMMAND("select", "Select a knot, a cart, or a segment with a place on it; none clears.", Effect::settings);
  COASTER_FIELDS(visit("", self.what), visit("at?", self.at))
};
struct SelectKnots {
  Knots knots;
  COASTER_COMMAND("select_knots", "Select several knots; the last one named is the active one.", Effect::settings);
  COASTER_FIELDS(visit("", self.knots))
};
struct SetSnapping {
  world::SnapTo to{};
  double step = world::Snapping{}.step, angle = world::Snapping{}.angle;
  COASTER_COMMAND("snapping",
                  "Let what is moved by hand snap to a grid (step in m), to other knots or to the ground; turns to an "
                  "angle (degrees).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to), visit("step?", self.step), visit("angle?", self.angle))
};
struct SetGizmo {
  bool to = true;
  COASTER_COMMAND("gizmo", "Show or hide the arrows that move the selected knots (on, off).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetHints {
  bool to = true;
  COASTER_COMMAND("hints", "Show or dismiss the first steps in the viewport (on, off).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetPanels {
  bool to = true;
  COASTER_COMMAND("panels", "Show or hide the panels (on, off).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetPolyline {
  bool to = true;
  COASTER_COMMAND("polyline",
                  "Show or hide the evaluated polyline over the track (on, off); the same as show polyline.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetAppendMode {
  bool to = true;
  COASTER_COMMAND("append_mode", "Clicks on the ground append knots (on, off).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetScale {
  float to = 1;
  COASTER_COMMAND("scale", "Scale the panels (0.75..3).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetTheme {
  world::Theme to{};
  COASTER_COMMAND("theme", "Choose the colours of the panels: dark, light or high_contrast.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetStyle {
  world::Style to{};
  COASTER_COMMAND("style", "Choose the light of the scene: day, dusk or blueprint.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetShadows {
  bool on = true;
  COASTER_COMMAND("shadows", "Show what track and trains take of the sun (on or off); without them frames cost less.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.on))
};
struct SetSound {
  float to = 0;
  COASTER_COMMAND("sound", "Set the loudness of the ride in the window (0: silent, to 1).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};

}  // namespace coaster::edit
