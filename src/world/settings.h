// Settings: how things are shown and measured. Changed by commands, so scripts and recordings have them; neither undone nor hashed.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "curve/arc_length.h"
#include "curve/evaluators.h"
#include "world/entity.h"
#include "world/laboratory.h"

namespace coaster::world {

// Orbit camera: looks at `target` from `distance` metres; yaw about +Y (0 looks along -Z), pitch above the horizon (-89..89; the view
// keeps it out of the ground). Vertical field of view 45 degrees.
struct Camera {
  glm::vec3 target{0, 5, 0};
  float yaw_deg = 35, pitch_deg = 18, distance = 80;
  friend bool operator==(const Camera&, const Camera&) = default;
};

// How carts and the ride camera are turned: a row of sim::frame_methods(), in its order.
enum class FrameMethod : std::uint8_t { knots, rmf, frenet, world_up };
enum class CameraMode : std::uint8_t { orbit, ride };

struct Settings {
  curve::EvaluatorId evaluator = curve::kDefaultEvaluator;
  int steps = 64;                            // polyline resolution, steps per segment, 1..4096
  std::int64_t vertex_budget = 16'000'000;   // vertices of all polylines together
  curve::ArcLengthId arc_length{};
  FrameMethod frames = FrameMethod::knots;
  int integrator = 0;                        // row of sim::integrators()
  Camera camera;
  CameraMode camera_mode = CameraMode::orbit;
  Entity selected = kNone;                   // a knot, segment or cart
  double selected_t = 0.5;                   // the picked place on a selected segment, parameter in [0,1]
  bool show_panels = true;
  Layers layers;                             // the laboratory's pictures over the scene
  Colouring colouring{};                     // of the track
  double magnification = 100'000;            // of the rounding layer, 1..1e7
  double comb_scale = 100;                   // m^2: metres of a tooth for a curvature of 1/m, 0.001..1e6
  bool show_laboratory = false;              // the strip of pages below the viewport
  LabPage lab_page = LabPage::construction;
  bool append_mode = false;                  // a click on the ground appends a knot
  float ui_scale = 1.0f;
  friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace coaster::world
