// Camera: camera mode and camera feel.
#include <array>

#include "edit/commands/commands_settings.h"
#include "ui/context/ui.h"
#include "ui/tools/fly_keys.h"
#include "world/camera_feel.h"

namespace coaster::ui {
namespace {

struct CameraRow {
  const char *label, *tooltip, *action;
};
constexpr std::array<CameraRow, 4> kModes{{
    {"Orbit", "Orbits a point. Drag empty space to orbit, middle button to pan, wheel to zoom.", "Orbit camera"},
    {"Ride", "The view from the first cart's seat, 1.1 m above the rails.", "Ride camera"},
    {"Chase", "Follows the first train from behind and above. The wheel sets the distance.", "Chase camera"},
    {"Fly", "W A S D to fly, Q down, E up, Shift faster. Drag to look around.", "Fly camera"},
}};

}  // namespace

void camera_panel(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  const world::CameraFeel& feel = *settings.feel;
  for (std::size_t i = 0; i < kModes.size(); ++i) {
    const auto mode = static_cast<world::CameraMode>(i);
    if (i > 0) (void)beside_last(ui, kModes[i].label);
    if (radio(ui, kModes[i].label, settings.camera_mode == mode,
              with_keys(ui.keys, kModes[i].tooltip, kModes[i].action)))
      choose_camera(ui, mode);
  }
  const bool rides = settings.camera_mode == world::CameraMode::ride;
  const double view = rides ? feel.ride_view_deg : settings.camera.field_of_view_deg;
  const char* const help = rides ? "Vertical field of view of the rider, in degrees."
                                 : "Vertical field of view of the orbit, chase and fly cameras, in degrees.";
  if (const auto to = real_slider(ui, "Field of view", view, world::kMinFieldOfView, world::kMaxFieldOfView, 0, help)) {
    const auto degrees = static_cast<float>(*to);
    if (rides) ui.emit(edit::Set<&world::CameraFeel::ride_view_deg>{degrees});
    else ui.emit(edit::Set<&world::Camera::field_of_view_deg>{degrees});
  }
  if (const auto to =
          real_slider(ui, "Roll damping", feel.roll_damping, 0, 2, 2, "Lag of the rider's roll, 0 to 2 s. 0: no lag."))
    ui.emit(edit::Set<&world::CameraFeel::roll_damping>{static_cast<float>(*to)});
  if (const auto to = real_slider(ui, "Widening", feel.widening_deg, 0, 20, 0,
                                  "Widening of the rider's field of view at 30 m/s, 0 to 20 degrees."))
    ui.emit(edit::Set<&world::CameraFeel::widening_deg>{static_cast<float>(*to)});
  if (const auto to =
          real_slider(ui, "Chase distance", feel.chase_distance, world::kMinChase, world::kMaxChase, 0,
                      "Distance of the chase camera from a single car, in metres. Longer trains add to it."))
    ui.emit(edit::Set<&world::CameraFeel::chase_distance>{static_cast<float>(*to)});
  if (const auto on = checkbox(ui, "Head-bob", feel.head_bob, "The rider's head moves with g and vibrates slightly."))
    ui.emit(edit::Set<&world::CameraFeel::head_bob>{*on});
  if (const auto on = checkbox(ui, "Reduced motion", feel.reduced_motion,
                               "Level horizon, cuts between cameras, no head-bob, no widening."))
    ui.emit(edit::Set<&world::CameraFeel::reduced_motion>{*on});
}

}  // namespace coaster::ui
