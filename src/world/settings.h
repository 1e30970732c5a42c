// Settings: how things are shown and measured. Changed by commands, so scripts and recordings have them; neither undone
// nor hashed.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "curve/arc_length.h"
#include "curve/evaluators.h"
#include "world/element.h"
#include "world/entity.h"
#include "world/laboratory.h"

namespace coaster::world {

// Orbit camera: looks at `target` from `distance` metres; yaw about +Y (0 looks along -Z), pitch above the horizon (up
// to kMaxPitch either way; the view keeps it out of the ground). Its vertical field of view is that of the chase and
// the free camera, too.
struct Camera {
  glm::vec3 target{0, 5, 0};
  float yaw_deg = 35, pitch_deg = 18, distance = 80;
  float field_of_view_deg = 45;  // kMinFieldOfView..kMaxFieldOfView
  friend bool operator==(const Camera&, const Camera&) = default;
};

// How carts and the ride camera are turned: a row of sim::frame_methods(), in its order.
enum class FrameMethod : std::uint8_t { knots, rmf, frenet, world_up };
// How carts move: a row of sim::integrators().
enum class IntegratorId : int {};

enum class CameraMode : std::uint8_t { orbit, ride, chase, fly };
inline constexpr base::NameRow kCameraModes[] = {{"orbit"}, {"ride"}, {"chase"}, {"fly"}};
constexpr std::span<const base::NameRow> rows_of(CameraMode) { return kCameraModes; }
inline constexpr float kMaxPitch = 89;                               // degrees
inline constexpr float kMinFieldOfView = 30, kMaxFieldOfView = 110;  // degrees, vertical

// The free camera: level, from `eye` (m), yaw as the orbit camera's, pitch of the view above the horizon (up to
// kMaxPitch).
struct FlyCamera {
  glm::vec3 eye{0, 12, 60};  // at least kLowestFlight over the ground
  float yaw_deg = 0, pitch_deg = -6;
  friend bool operator==(const FlyCamera&, const FlyCamera&) = default;
};
inline constexpr float kLowestFlight = 0.5f;  // m

inline constexpr float kMinChase = 5, kMaxChase = 60;  // m

// How the cameras that go with a train feel.
struct CameraFeel {
  float ride_view_deg = 70;  // the rider's vertical field of view, kMinFieldOfView..kMaxFieldOfView
  float widening_deg = 6;    // by which it has grown at 30 m/s, 0..20
  float roll_damping =
      0.25f;                 // s by which the rider's roll is late in a steady roll; 0: the track's roll at once; 0..2
  float chase_distance = 9;  // m from the chase camera to the middle of a lone car, kMinChase..kMaxChase
  bool head_bob = false;     // the rider's head gives way to g
  bool reduced_motion = false;  // no transitions, no head-bob, no widening, the rider's horizon level
  friend bool operator==(const CameraFeel&, const CameraFeel&) = default;
};

enum class Axis : std::uint8_t { x, y, z };
inline constexpr base::NameRow kAxes[] = {{"x"}, {"y"}, {"z"}};
constexpr std::span<const base::NameRow> rows_of(Axis) { return kAxes; }

// The parameter of a spline through knots: the lengths of the chords between them, or 1 from each to the next.
enum class SplineSteps : std::uint8_t { chord, uniform };
inline constexpr base::NameRow kSplineSteps[] = {{"chord"}, {"uniform"}};
constexpr std::span<const base::NameRow> rows_of(SplineSteps) { return kSplineSteps; }

// What moves by hand snap to.
enum class SnapTo : std::uint8_t { off, grid, knots, ground };
inline constexpr base::NameRow kSnapTos[] = {{"off", "Nothing", "What is moved goes where the mouse is."},
                                             {"grid", "Grid", "Positions are whole steps."},
                                             {"knots", "Knots", "A knot under the cursor draws what is moved onto it."},
                                             {"ground", "Ground", "What is moved stays on the ground."}};
constexpr std::span<const base::NameRow> rows_of(SnapTo) { return kSnapTos; }
struct Snapping {
  SnapTo to = SnapTo::off;
  double step = 1;    // m, 0.001..1000
  double angle = 15;  // degrees, 0.1..180
  friend bool operator==(const Snapping&, const Snapping&) = default;
};

// Colours of the panels; by name in scripts and in the settings file.
enum class Theme : std::uint8_t { dark, light, high_contrast };
inline constexpr base::NameRow kThemes[] = {{"dark", "Dark", "Colours of the panels."},
                                            {"light", "Light", "Colours of the panels."},
                                            {"high_contrast", "High contrast", "Colours of the panels."}};
constexpr std::span<const base::NameRow> rows_of(Theme) { return kThemes; }

// Light, sky and ground of the scene; by name in scripts and in the settings file.
enum class Style : std::uint8_t { day, dusk, blueprint };
inline constexpr base::NameRow kStyles[] = {
    {"day", "Day", "The sun high, a clear sky."},
    {"dusk", "Dusk", "The sun low, long shadows."},
    {"blueprint", "Blueprint", "Lines on blue, for the laboratory and for print."}};
constexpr std::span<const base::NameRow> rows_of(Style) { return kStyles; }

struct Settings {
  curve::EvaluatorId evaluator = curve::kDefaultEvaluator;
  int steps = 64;                           // polyline resolution, steps per segment, 1..4096
  std::int64_t vertex_budget = 16'000'000;  // vertices of all polylines together
  curve::ArcLengthId arc_length{};
  FrameMethod frames = FrameMethod::knots;
  IntegratorId integrator{};
  Camera camera;
  CameraMode camera_mode = CameraMode::orbit;
  FlyCamera fly;
  CameraFeel feel;
  Entity selected = kNone;   // a knot, segment or cart: the active one
  std::vector<Entity> also;  // further selected knots while `selected` is one: no one twice, in the order of selecting
  double selected_t = 0.5;   // the picked place on a selected segment, parameter in [0,1]
  bool show_panels = true;
  Layers layers;                   // the laboratory's pictures over the scene
  Colouring colouring{};           // of the track
  double magnification = 100'000;  // of the rounding layer, 1..1e7
  double comb_scale = 100;         // m^2: metres of a tooth for a curvature of 1/m, 0.001..1e6
  bool show_laboratory = false;    // the strip of pages below the viewport
  LabPage lab_page = LabPage::construction;
  bool append_mode = false;  // a click on the ground appends a knot
  Snapping snapping;
  bool show_gizmo = true;   // arrows that move the selected knots
  bool show_hints = false;  // the first steps, in the viewport; a window shows them until they are dismissed
  bool show_card = false;   // the score card at the end of a ride; a window shows it unless told otherwise
  Element element = usual_element(ElementKind::curve);  // the palette's
  bool show_element = false;                            // where it would go
  float ui_scale = 1.0f;
  Theme theme = Theme::dark;
  Style style = Style::day;
  bool shadows = true;  // of track and trains; without them frames cost less
  float sound = 0.5f;   // loudness of the ride where there is a device for it, 0 (silent) to 1
  friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace coaster::world
