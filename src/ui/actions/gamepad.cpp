#include "ui/actions/gamepad.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "edit/commands/commands_settings.h"
#include "ui/tools/camera_controls.h"
#include "world/aid_settings.h"

namespace coaster::ui {
namespace {

constexpr float kDeadZone = 0.18f, kTriggerRest = 0.08f;
// Rates at full deflection, per second:
constexpr float kTurn = 130, kTilt = 90;   // degrees
constexpr float kPan = 0.9f;               // heights of the picture
constexpr float kNotches = 9;              // steps of the mouse wheel: zoom, chase distance
constexpr float kFly = 20;                 // m
constexpr double kLongestPadFrame = 0.25;  // s

}  // namespace

glm::vec2 shaped_stick(glm::vec2 stick) {
  const float far = glm::length(stick);
  if (!(far > kDeadZone)) return glm::vec2(0);
  const float part = std::min(1.0f, (far - kDeadZone) / (1 - kDeadZone));
  return stick * (part * part / far);
}

float shaped_trigger(float trigger) {
  const float part = std::clamp((trigger - kTriggerRest) / (1 - kTriggerRest), 0.0f, 1.0f);
  return part * part;
}

std::string_view action_of(platform::PadButton button, const ActionContext& act) {
  switch (button) {
    case platform::PadButton::a: return "Play or pause";
    case platform::PadButton::y: return "Next camera";
    case platform::PadButton::b: {
      const world::Settings& settings = act.ui.session().settings;
      const bool busy = act.tool.dragging() || act.tool.box_waits() || act.ui.gesture.open ||
                        settings.aids->append_mode || settings.aids->show_element || settings.selected.valid();
      return busy ? "Cancel" : "Reset";
    }
    case platform::PadButton::x: break;
  }
  return {};
}

void Gamepad::move(Ui& ui, const view::Viewport& scene, double seconds) const {
  const auto time = static_cast<float>(std::min(seconds, kLongestPadFrame));
  const glm::vec2 left = time * shaped_stick({held_.left_x, held_.left_y}),
                  right = time * shaped_stick({held_.right_x, held_.right_y});
  const float pull = time * (shaped_trigger(held_.right_trigger) - shaped_trigger(held_.left_trigger));
  if (left == glm::vec2(0) && right == glm::vec2(0) && pull == 0) return;
  const glm::vec2 middle(scene.x + 0.5f * scene.width, scene.y + 0.5f * scene.height);
  const world::Settings& settings = ui.session().settings;
  const world::CameraMode shown = ui.state.rig ? ui.state.rig->mode : settings.camera_mode;
  switch (shown) {
    case world::CameraMode::orbit: {
      world::Camera camera = camera_now(ui);
      if (right != glm::vec2(0)) camera = view::in_perspective(camera);
      camera.yaw_deg = std::remainder(camera.yaw_deg - kTurn * right.x, 360.0f);
      camera.pitch_deg = std::clamp(camera.pitch_deg - kTilt * right.y, -89.0f, 89.0f);
      if (left != glm::vec2(0)) camera = panned(camera, ui.out.view, -kPan * scene.height * left);
      if (pull != 0) camera = zoomed(camera, ui.out.view, middle, kNotches * pull);
      return set_camera(ui, camera);
    }
    case world::CameraMode::fly: {
      world::FlyCamera fly = fly_now(ui);
      fly.yaw_deg = std::remainder(fly.yaw_deg - kTurn * right.x, 360.0f);
      fly.pitch_deg = std::clamp(fly.pitch_deg - kTilt * right.y, -89.0f, 89.0f);
      return ui.emit(edit::SetFlyCamera{flown(fly, kFly * glm::vec3(left.x, pull, -left.y), ui.find.ground())});
    }
    case world::CameraMode::chase:
      if (pull != 0) zoom_chase(ui, kNotches * pull);
      return;
    case world::CameraMode::ride: return;  // the camera follows the train
  }
}

void Gamepad::work(ActionContext& act, const platform::Events& events, bool asking) {
  double seconds = 0;
  for (const platform::Event& event : events) {
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) seconds += tick->dt;
    if (const auto* const focus = std::get_if<platform::Focus>(&event)) focused_ = focus->focused, held_ = {};
    if (!focused_) continue;  // every window receives a gamepad's events
    if (const auto* const axes = std::get_if<platform::GamepadAxes>(&event)) held_ = *axes;
    const auto* const press = std::get_if<platform::GamepadButton>(&event);
    if (!press || !press->down || asking) continue;
    const std::string_view wanted = action_of(press->button, act);
    for (const Action& action : actions())
      if (action.name == wanted && action.enabled.holds(act)) action.run(act);
  }
  if (!asking && seconds > 0) move(act.ui, act.scene, seconds);
}

}  // namespace coaster::ui
