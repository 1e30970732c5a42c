#include "ui/tools/follow_camera.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "edit/commands/commands_settings.h"
#include "sim/study/complete_circuit.h"
#include "ui/context/ways_home.h"
#include "ui/tools/viewport_tool.h"
#include "world/aids.h"
#include "world/camera_feel.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

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

std::vector<glm::vec3> preview_points(const Ui& ui) {
  std::vector<glm::vec3> points;
  const world::Aids& aids = *ui.session().settings.aids;
  const auto add = [&](const sim::ElementPlan& plan) {
    if (plan.refusal.empty())
      for (const world::Knot& knot : plan.fit.knots) points.emplace_back(knot.position);
  };
  if (aids.circuit > 0 && completable(ui.session().document)) {
    if (ui.session().history.in_gesture) return points;  // a search would hold up each frame of a drag
    const sim::CircuitProposals& ways = ui.find.circuit();
    if (!ways.list.empty()) add(ways.list[shown_way_home(aids, ways)].plan);
  } else if (aids.show_element) {
    add(ui.find.element());
  }
  return points;
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
  Seen now{{}, glm::vec3(0), points};
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
    const std::optional<Seen> before = std::exchange(seen_, now);
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
