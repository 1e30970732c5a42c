// Camera: which one looks, and how it feels.
#include <array>

#include "ui/actions/key_map.h"
#include "ui/panels/panels.h"
#include "ui/tools/fly_keys.h"
#include "world/camera_feel.h"

namespace coaster::ui {
namespace {

struct CameraRow {
  const char *label, *tooltip, *action;
};
constexpr std::array<CameraRow, 4> kModes{{
    {"Orbit", "Turn about a place: drag empty space, middle button to pan, wheel to zoom.", "Orbit camera"},
    {"Ride", "From the first cart's seat, 1.1 m over the rails.", "Ride camera"},
    {"Chase", "Behind and above the first cart's train; the wheel sets how far.", "Chase camera"},
    {"Fly", "W A S D along the view and sideways, Q down, E up, Shift faster; drag to look around.", "Fly camera"},
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
  if (const auto to = real_slider(ui, "Roll damping", feel.roll_damping, 0, 2, 2,
                                  "Seconds by which the rider's roll is late behind the track's; 0: at once."))
    ui.emit(edit::Set<&world::CameraFeel::roll_damping>{static_cast<float>(*to)});
  if (const auto to = real_slider(ui, "Widening", feel.widening_deg, 0, 20, 0,
                                  "Degrees by which the rider's view has widened at 30 m/s."))
    ui.emit(edit::Set<&world::CameraFeel::widening_deg>{static_cast<float>(*to)});
  if (const auto to = real_slider(ui, "Chase distance", feel.chase_distance, world::kMinChase, world::kMaxChase, 0,
                                  "Metres from the chase camera to a lone car; trains more."))
    ui.emit(edit::Set<&world::CameraFeel::chase_distance>{static_cast<float>(*to)});
  if (const auto on = checkbox(ui, "Head-bob", feel.head_bob,
                               "The rider's head gives way to g, and shakes a little with the rails."))
    ui.emit(edit::Set<&world::CameraFeel::head_bob>{*on});
  if (const auto on = checkbox(ui, "Reduced motion", feel.reduced_motion,
                               "The rider's horizon stays level; cameras cut; no bobbing, no widening."))
    ui.emit(edit::Set<&world::CameraFeel::reduced_motion>{*on});
}

}  // namespace coaster::ui
