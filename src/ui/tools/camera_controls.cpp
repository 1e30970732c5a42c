#include "ui/tools/camera_controls.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/tools/show_places.h"
#include "world/camera_feel.h"
#include "world/sections.h"

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
  const glm::vec3 limit(world::kMaxCoordinate);
  camera.target =
      glm::clamp(camera.target - view::right_of(view) * (pixels.x * metres) + view::top_of(view) * (pixels.y * metres),
                 -limit, limit);
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

namespace {

using platform::Key;

struct FlyKeyRow {
  Key key;
  glm::vec3 way;  // right, up, forward
};
constexpr std::array<FlyKeyRow, 6> kRows{{{Key::w, {0, 0, 1}},
                                          {Key::s, {0, 0, -1}},
                                          {Key::d, {1, 0, 0}},
                                          {Key::a, {-1, 0, 0}},
                                          {Key::e, {0, 1, 0}},
                                          {Key::q, {0, -1, 0}}}};

// By place: the keys form a cross for the left hand in every layout.
Key place_of(const platform::KeyPress& press) { return press.place == Key::unknown ? press.key : press.place; }

constexpr float kSpeed = 12, kFaster = 4;  // m/s
constexpr double kLongestFrame = 0.25;     // s

constexpr float kLag = 0.15f;  // s
constexpr float kRoom = 1.4f;  // a camera that has to move leaves room for what comes next

world::Camera between(const world::Camera& from, const world::Camera& to, float part) {
  world::Camera camera = from;
  camera.target = glm::mix(from.target, to.target, part);
  camera.distance = from.distance * std::pow(to.distance / from.distance, part);
  return camera;
}

bool near(const world::Camera& a, const world::Camera& b) {
  const float least = 2e-3f * b.distance;
  return glm::distance(a.target, b.target) < least && std::abs(a.distance - b.distance) < least;
}

void add_knots(const world::Document& document, std::size_t first, std::size_t end, std::vector<glm::vec3>& points) {
  for (std::size_t i = first; i < end; ++i)
    points.emplace_back(world::knot(document, document.track.knots[i]).position);
}

// Appends the knots of what is new: all of a track that was closed, or else the section, if it is not free, that ends
// at the open end.
void add_new(const world::Document& document, std::vector<glm::vec3>& points) {
  const std::vector<world::Entity>& knots = document.track.knots;
  if (document.track.closed) return add_knots(document, 0, knots.size(), points);
  const world::Entity section = knots.empty() ? world::kNone : world::section_of_knot(document, knots.back());
  if (!section.valid() || world::is_free(document, section)) return;
  const world::SectionRun run = world::run_of(document, section);
  add_knots(document, run.first, run.end(), points);
}

}  // namespace

bool is_fly_key(const platform::KeyPress& press) {
  if (press.modifiers.ctrl || press.modifiers.alt) return false;
  return std::any_of(kRows.begin(), kRows.end(), [&](const FlyKeyRow& row) { return row.key == place_of(press); });
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
  const world::FlyCamera now = fly_now(ui), to = flown(now, metres * glm::normalize(way), ui.find.ground());
  if (to != now) ui.emit(edit::SetFlyCamera{to});
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
    if (const auto* const set = command.as<edit::SetFlyCamera>()) camera = set->to;
  return camera;
}

world::FlyCamera flown(world::FlyCamera fly, glm::vec3 by, const sim::Ground& ground) {
  const float yaw = glm::radians(fly.yaw_deg), pitch = glm::radians(fly.pitch_deg);
  const glm::vec3 right(std::cos(yaw), 0, -std::sin(yaw)),
      ahead(-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
  const glm::vec3 most(world::kMaxCoordinate);
  fly.eye = glm::clamp(fly.eye + by.x * right + by.z * ahead + glm::vec3(0, by.y, 0), -most, most);
  fly.eye = view::above_ground(fly.eye, &ground);
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
    ui.emit(edit::SetFlyCamera{view::fly_from(ui.out.view, &ui.find.ground())});
  ui.emit(edit::Set<&world::Settings::camera_mode>{mode});
}

world::Camera framed_all(const edit::Session& session, const view::Viewport& scene, const view::Viewport& free) {
  const world::Camera all = view::frame_all(session.settings.camera, session.document, scene);
  if (free.width == scene.width && free.height == scene.height) return all;
  std::vector<glm::vec3> knots;
  for (const world::Entity knot : session.document.track.knots)
    knots.emplace_back(world::knot(session.document, knot).position);
  return view::kept_in_view(all, knots, scene, free);
}

void FollowCamera::update(Ui& ui, const view::View& view, const view::Viewport& free, bool busy) {
  const edit::Session& session = ui.session();
  const world::Settings& settings = session.settings;
  const std::vector<world::Entity>& knots = session.document.track.knots;
  std::vector<glm::vec3> points = preview_points(ui);
  FollowedState now{{}, glm::vec3(0), points};
  if (!session.document.track.closed && !knots.empty()) {
    now.last = knots.back(), now.end = world::knot(session.document, now.last).position;
    points.push_back(now.end);
  }
  const bool undo = session.history.redo.size() > std::exchange(undone_, session.history.redo.size());
  const bool may = settings.feel->follow && settings.camera_mode == world::CameraMode::orbit && !busy;
  const auto there = [&](const world::Camera& from, const std::vector<glm::vec3>& shown, float margin) {
    return view::kept_in_view(from, shown, view.viewport, free, margin);
  };
  // Changes during a drag are followed when it has ended.
  if (!std::exchange(busy_, busy) && !busy) {
    const std::optional<FollowedState> before = std::exchange(seen_, now);
    if (before && *before != now) {
      to_.reset();
      const bool carried = before->last.valid() && before->last == now.last && before->end != now.end;
      if (before->last != now.last && !undo) add_new(session.document, points);
      const bool at_end = before->last == now.last && before->end == now.end, turned = settings.camera != sent_;
      if (!at_end || turned) before_preview_.reset();
      const world::Camera here = settings.camera,
                          from = before_preview_ && !now.preview.empty() ? *before_preview_ : here;
      if (may && !points.empty() && (!carried || (!undo && near(here, there(here, {before->end}, view::kMargin))))) {
        const bool fits = near(from, there(from, points, view::kMargin));
        const world::Camera to = fits ? from : there(from, points, kRoom);
        if (!near(here, to)) to_ = to, sent_ = here;
        if (to_ && at_end && !before_preview_) before_preview_ = here;
      }
    }
  }
  if (!to_) return;
  const bool moved =
      std::ranges::any_of(ui.out.commands, [](const edit::Command& one) { return one.is<edit::SetCamera>(); });
  if (moved || !may || !(settings.camera == sent_)) return to_.reset();  // the user moves the camera
  const float part = settings.feel->reduced_motion ? 1.0f : 1 - std::exp(-ImGui::GetIO().DeltaTime / kLag);
  world::Camera next = between(settings.camera, *to_, part);
  if (near(next, *to_)) next = *to_, to_.reset();
  sent_ = next;
  ui.emit(edit::set_camera(next));
}

}  // namespace coaster::ui
