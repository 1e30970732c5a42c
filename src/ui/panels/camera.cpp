// Camera: camera mode and camera feel.
#include <array>
#include <utility>

#include "ui/context/setting_rows.h"
#include "ui/tools/fly_keys.h"

namespace coaster::ui {
namespace {

using world::CameraFeel;

// Mode and tooltip; "MODE camera" is the action that selects it.
constexpr std::array<std::pair<const char*, const char*>, 4> kModes{{
    {"Orbit", "Orbits a point. Drag empty space to orbit, middle button to pan, wheel to zoom."},
    {"Ride", "The view from a seat of the first train, 1.1 m above the rails."},
    {"Chase", "Follows the first train from behind and above. The wheel sets the distance."},
    {"Fly", "W A S D to fly, Q down, E up, Shift faster. Drag to look around."},
}};

}  // namespace

void camera_panel(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  for (std::size_t i = 0; i < kModes.size(); ++i) {
    const auto mode = static_cast<world::CameraMode>(i);
    const auto& [label, tooltip] = kModes[i];
    if (i > 0) (void)beside_last(ui, label);
    if (radio(ui, label, settings.camera_mode == mode, with_keys(ui.keys, tooltip, std::string(label) + " camera")))
      choose_camera(ui, mode);
  }
  const bool rides = settings.camera_mode == world::CameraMode::ride;
  if (rides)
    setting_slider<&CameraFeel::ride_view_deg>(ui, "Field of view", 0,
                                               "Vertical field of view of the rider, in degrees.");
  else
    setting_slider<&world::Camera::field_of_view_deg>(
        ui, "Field of view", 0, "Vertical field of view of the orbit, chase and fly cameras, in degrees.");
  setting_slider<&CameraFeel::roll_damping>(ui, "Roll damping", 2, "Lag of the rider's roll, 0 to 2 s. 0: no lag.");
  setting_slider<&CameraFeel::widening_deg>(ui, "Widening", 0,
                                            "Widening of the rider's field of view at 30 m/s, 0 to 20 degrees.");
  setting_slider<&CameraFeel::chase_distance>(
      ui, "Chase distance", 0, "Distance of the chase camera from a single car, 5 to 60 m. Longer trains add to it.");
  setting_box<&CameraFeel::head_bob>(ui, "Head-bob", "The rider's head moves with g and vibrates slightly.");
  setting_box<&CameraFeel::follow>(ui, "Follow the open end",
                                   "Move the orbit camera where the open end or the preview leaves the view.");
  setting_box<&CameraFeel::reduced_motion>(ui, "Reduced motion",
                                           "Level horizon, cuts between cameras, no head-bob, no widening.");
}

}  // namespace coaster::ui
