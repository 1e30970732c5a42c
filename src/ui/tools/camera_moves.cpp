// Mouse control of the orbit camera: exact, without damping, so that a recording repeats it.
#include <algorithm>
#include <cmath>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/tools/fly_keys.h"
#include "ui/tools/viewport_tool.h"
#include "world/camera_feel.h"

namespace coaster::ui {

constexpr float kPerNotch = 1.12f;  // per step of the wheel, for distances

world::Camera orbited(world::Camera camera, glm::vec2 pixels, float scale) {
  constexpr float kDegreesPerPixel = 0.3f;
  camera = view::in_perspective(camera);
  camera.yaw_deg -= pixels.x * kDegreesPerPixel / scale;
  camera.pitch_deg = std::clamp(camera.pitch_deg + pixels.y * kDegreesPerPixel / scale, -89.0f, 89.0f);
  return camera;
}

world::Camera panned(world::Camera camera, const view::View& view, glm::vec2 pixels) {
  // Metres that a pixel covers at the target, so that the target stays under the cursor.
  const float metres = view::metres_per_pixel(view, camera.distance);
  const glm::vec3 right(view.view[0][0], view.view[1][0], view.view[2][0]),
      up(view.view[0][1], view.view[1][1], view.view[2][1]);
  const glm::vec3 limit(world::kMaxCoordinate);
  camera.target = glm::clamp(camera.target - right * (pixels.x * metres) + up * (pixels.y * metres), -limit, limit);
  return camera;
}

world::Camera zoomed(world::Camera camera, const view::View& view, glm::vec2 cursor, float notches) {
  constexpr float kNearest = 0.5f, kFarthest = 20'000.0f;
  const float before = camera.distance;
  camera.distance = std::clamp(before * std::pow(kPerNotch, -notches), kNearest, kFarthest);
  if (view.parallel <= 0) return camera;
  const view::Viewport& port = view.viewport;
  const glm::vec2 middle(port.x + 0.5f * port.width, port.y + 0.5f * port.height);
  return panned(camera, view, (cursor - middle) * (camera.distance / before - 1));
}

void set_camera(Ui& ui, const world::Camera& camera) {
  if (camera.projection != ui.session().settings.camera.projection)
    ui.emit(edit::Set<&world::Camera::projection>{camera.projection});
  ui.emit(edit::set_camera(camera));
}

void zoom_chase(Ui& ui, float notches) {
  const float distance = ui.session().settings.feel->chase_distance * std::pow(kPerNotch, -notches);
  ui.emit(edit::Set<&world::CameraFeel::chase_distance>{std::clamp(distance, world::kMinChase, world::kMaxChase)});
}

world::CameraMode shown_camera(const Ui& ui) {
  const edit::Session& s = ui.session();
  return view::shown_mode({s.document, s.derived, s.motion, s.settings});
}

void ViewportTool::turn_wheel(Ui& ui, const view::View& view, float notches) {
  constexpr float kMetres = 2;
  const world::Settings& settings = ui.session().settings;
  switch (shown_camera(ui)) {
    case world::CameraMode::orbit:
      ui.emit(edit::set_camera(zoomed(settings.camera, view, mouse_position(), notches)));
      break;
    case world::CameraMode::fly: ui.emit(edit::SetFly{flown(fly_now(ui), {0, 0, kMetres * notches})}); break;
    case world::CameraMode::chase: zoom_chase(ui, notches); break;
    case world::CameraMode::ride: break;
  }
}

}  // namespace coaster::ui
