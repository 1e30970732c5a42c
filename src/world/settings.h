// Settings: how things are shown and measured. Changed by commands, so scripts and recordings contain them; neither
// undone nor hashed. Most are in groups, each with a separate header; see world/setting_row.h.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "base/enum_names.h"
#include "world/camera.h"
#include "world/element.h"
#include "world/entity.h"
#include "world/heap_value.h"
#include "world/setting_row.h"

namespace coaster::world {

// How trains and the ride camera are oriented: a row of sim::frame_methods(), in its order.
enum class FrameMethod : std::uint8_t { knots, rmf, frenet, world_up };
// How carts move: a row of sim::integrators().
enum class IntegratorId : int {};

enum class Axis : std::uint8_t { x, y, z };
inline constexpr base::NameRow kAxes[] = {{"x", "X"}, {"y", "Y"}, {"z", "Z"}};
constexpr std::span<const base::NameRow> rows_of(Axis) { return kAxes; }

// The parameter of a spline through knots: chord lengths, or 1 per span.
enum class SplineSteps : std::uint8_t { chord, uniform };
inline constexpr base::NameRow kSplineSteps[] = {{"chord"}, {"uniform"}};
constexpr std::span<const base::NameRow> rows_of(SplineSteps) { return kSplineSteps; }

// What dragged knots snap to.
enum class SnapTo : std::uint8_t { off, grid, knots, ground };
inline constexpr base::NameRow kSnapTos[] = {{"off", "Nothing", "Dragged knots follow the mouse."},
                                             {"grid", "Grid", "Positions snap to multiples of the step."},
                                             {"knots", "Knots", "Dragged knots snap to the knot under the cursor."},
                                             {"ground", "Ground", "Dragged knots stay on the ground."}};
constexpr std::span<const base::NameRow> rows_of(SnapTo) { return kSnapTos; }
struct Snapping {
  SnapTo to = SnapTo::off;
  double step = 1;    // m, 0.001..1000
  double angle = 15;  // degrees, 0.1..180
  friend bool operator==(const Snapping&, const Snapping&) = default;
};

struct EditingAids;  // world/aid_settings.h
struct CameraFeel;   // world/camera_feel.h
struct Evaluation;   // world/evaluation_settings.h
struct LabView;      // world/laboratory_settings.h
struct Appearance;   // world/appearance_settings.h
struct Panels;       // world/panel_settings.h

enum class Colouring : std::uint8_t;  // world/laboratory.h
enum class LabPage : std::uint8_t;    // world/laboratory.h
enum class Layer : std::uint8_t;      // world/layers.h
enum class Scenery : std::uint8_t;    // world/appearance_settings.h
enum class Style : std::uint8_t;      // world/appearance_settings.h
enum class Theme : std::uint8_t;      // world/appearance_settings.h

struct Settings {
  HeapValue<Appearance> look;
  HeapValue<Panels> panels;
  HeapValue<CameraFeel> feel;
  HeapValue<EditingAids> aids;
  HeapValue<Evaluation> evaluation;
  HeapValue<LabView> lab;
  FrameMethod frames = FrameMethod::knots;
  IntegratorId integrator{};
  CameraMode camera_mode = CameraMode::orbit;
  Camera camera;
  FlyCamera fly;
  Entity selected = kNone;   // a knot, segment, section or cart: the active one
  std::vector<Entity> also;  // further selected knots or sections, of the kind of `selected`: unique, in the order of
                             // selection
  double selected_t = 0.5;   // the picked position on a selected segment, parameter in [0,1]
  Snapping snapping;
  Element element = first_element();  // the palette's element
  friend bool operator==(const Settings&, const Settings&) = default;

  static constexpr auto kRows =
      std::tuple{setting(&Settings::frames, "frames_by",
                         "Frames that turn trains: the knots' banked ones (knots), rotation-minimising "
                         "along the track (rmf), Frenet-Serret (frenet) or upright (world_up)."),
                 setting(&Settings::integrator, "integrator", "Method that moves the trains."),
                 setting(&Settings::camera_mode, "camera_mode",
                         "Camera: orbit, from the first train (ride), from behind it (chase) or free (fly).")};
};

}  // namespace coaster::world
