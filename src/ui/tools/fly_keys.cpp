// Keys and mouse of the free camera.
#include "ui/tools/fly_keys.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"

namespace coaster::ui {
namespace {

using platform::Key;

struct Row {
  Key key;
  glm::vec3 way;  // right, up, forward
};
constexpr std::array<Row, 6> kRows{{{Key::w, {0, 0, 1}},
                                    {Key::s, {0, 0, -1}},
                                    {Key::d, {1, 0, 0}},
                                    {Key::a, {-1, 0, 0}},
                                    {Key::e, {0, 1, 0}},
                                    {Key::q, {0, -1, 0}}}};

// By place: the keys form a cross for the left hand in every layout.
Key place_of(const platform::KeyPress& press) { return press.place == Key::unknown ? press.key : press.place; }

constexpr float kSpeed = 12, kFaster = 4;  // m/s
constexpr double kLongestFrame = 0.25;     // s

}  // namespace

bool is_fly_key(const platform::KeyPress& press) {
  if (press.modifiers.ctrl || press.modifiers.alt) return false;
  return std::any_of(kRows.begin(), kRows.end(), [&](const Row& row) { return row.key == place_of(press); });
}

void FlyKeys::fly(Ui& ui, const platform::Events& events, bool text_has_keyboard) {
  double seconds = 0;
  // A key pressed and released within one frame counts as held for all of it.
  std::array<bool, 6> acts = held_;
  for (const platform::Event& event : events) {
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) seconds += tick->dt;
    if (const auto* const focus = std::get_if<platform::Focus>(&event); focus && !focus->focused)
      held_ = acts = {}, fast_ = false;
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    if (!press) continue;
    fast_ = press->modifiers.shift;
    for (std::size_t i = 0; i < kRows.size(); ++i) {
      if (kRows[i].key != place_of(*press)) continue;
      held_[i] = press->down && (press->repeat ? held_[i] : !text_has_keyboard && is_fly_key(*press));
      acts[i] = acts[i] || held_[i];
    }
  }
  if (ui.session().settings.camera_mode != world::CameraMode::fly) return;
  glm::vec3 way(0);
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (acts[i]) way += kRows[i].way;
  if (way == glm::vec3(0) || !(seconds > 0)) return;
  const float metres = kSpeed * (fast_ ? kFaster : 1) * static_cast<float>(std::min(seconds, kLongestFrame));
  const world::FlyCamera now = fly_now(ui), to = flown(now, metres * glm::normalize(way));
  if (to != now) ui.emit(edit::SetFly{to});
}

world::Camera camera_now(const Ui& ui) {
  world::Camera camera = ui.session().settings.camera;
  for (const edit::Command& command : ui.out.commands)
    if (const auto* const set = command.as<edit::SetCamera>()) camera = edit::changed(camera, *set);
  return camera;
}
world::FlyCamera fly_now(const Ui& ui) {
  world::FlyCamera camera = ui.session().settings.fly;
  for (const edit::Command& command : ui.out.commands)
    if (const auto* const set = command.as<edit::SetFly>()) camera = set->to;
  return camera;
}

world::FlyCamera flown(world::FlyCamera fly, glm::vec3 by) {
  const float yaw = glm::radians(fly.yaw_deg), pitch = glm::radians(fly.pitch_deg);
  const glm::vec3 right(std::cos(yaw), 0, -std::sin(yaw)),
      ahead(-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
  const glm::vec3 low(-world::kMaxCoordinate, world::kLowestFlight, -world::kMaxCoordinate),
      high(world::kMaxCoordinate);
  fly.eye = glm::clamp(fly.eye + by.x * right + by.z * ahead + glm::vec3(0, by.y, 0), low, high);
  return fly;
}

world::FlyCamera looked(world::FlyCamera fly, glm::vec2 pixels, float scale) {
  constexpr float kDegreesPerPixel = 0.2f;
  fly.yaw_deg = std::remainder(fly.yaw_deg - pixels.x * kDegreesPerPixel / scale, 360.0f);
  fly.pitch_deg = std::clamp(fly.pitch_deg - pixels.y * kDegreesPerPixel / scale, -89.0f, 89.0f);
  return fly;
}

void choose_camera(Ui& ui, world::CameraMode mode) {
  if (mode == world::CameraMode::fly && ui.session().settings.camera_mode != mode)
    ui.emit(edit::SetFly{view::fly_from(ui.out.view)});
  ui.emit(edit::Set<&world::Settings::camera_mode>{mode});
}

}  // namespace coaster::ui
