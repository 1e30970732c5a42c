#include "ui/tools/ground_brush.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "edit/commands/commands_park.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "sim/ground/ground.h"
#include "ui/widgets/theme.h"
#include "world/aid_settings.h"

namespace coaster::ui {
namespace {

using world::Brush;
using world::EditingAids;

constexpr double kBetweenDabs = 0.05;  // s

// Returns where the mouse's ray meets the ground, m, (x, z); nothing over the sky.
std::optional<glm::vec2> under_mouse(const sim::Ground& ground, const view::View& view) {
  constexpr double kFarthest = 5000, kBehind = 20'000;  // m; a line of an orthographic view begins that far behind
  const view::Ray ray = view::ray_through(view, mouse_position());
  const glm::dvec3 along(ray.direction), from = glm::dvec3(ray.origin) - (ray.endless ? kBehind : 0) * along;
  const auto distance = ground.meet(from, along, ray.endless ? 2 * kBehind : kFarthest);
  if (!distance) return std::nullopt;
  return glm::vec2(from.x + *distance * along.x, from.z + *distance * along.z);
}

// Draws a line on the ground through the places (x, z) at(0) to at(steps), m.
template <class At>
void draw_line(const Ui& ui, const view::View& view, int steps, At at) {
  constexpr double kAbove = 0.15;  // m
  const float width = 2 * ui.scale;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  std::optional<glm::vec3> before;
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 place = at(i);
    const double height = ui.find.ground().surface(place.x, place.y) + kAbove;
    const auto next = view::project(view, glm::vec3(place.x, height, place.y));
    if (before && next) {
      list.AddLine({before->x, before->y}, {next->x, next->y}, packed(palette().background, 0.6f), width + 2);
      list.AddLine({before->x, before->y}, {next->x, next->y}, packed(palette().accent, 1), width);
    }
    before = next;
  }
}

void draw_ring(const Ui& ui, const view::View& view, glm::dvec2 middle, double radius) {
  constexpr int kSides = 72;
  draw_line(ui, view, kSides, [&](int i) {
    const double angle = 2 * base::kPi * (i % kSides) / kSides;
    return middle + radius * glm::dvec2(std::cos(angle), std::sin(angle));
  });
}

void draw_way(const Ui& ui, const view::View& view, glm::dvec2 from, glm::dvec2 to) {
  constexpr int kSteps = 48;
  draw_line(ui, view, kSteps, [&](int i) { return from + (to - from) * (i / double{kSteps}); });
}
}  // namespace

bool GroundBrush::chosen(const edit::Session& session) {
  return session.settings.aids->brush != Brush::off && !session.document.park.plain();
}

void GroundBrush::update(Ui& ui, const view::View& view, bool over) {
  const edit::Session& session = ui.session();
  const ImGuiIO& io = ImGui::GetIO();
  if (stroke_ && ((stroke_->gesture && !session.history.in_gesture) || !chosen(session))) stroke_.reset();
  if (session.settings.aids->brush != Brush::slope || !chosen(session)) slope_from_.reset();
  if (!chosen(session)) return;
  const float radius = session.settings.aids->brush_radius;
  if (over && io.MouseWheel != 0 && !io.KeyCtrl) {
    constexpr float kNotch = 1.15f;
    const float wish = std::round(10 * radius * std::pow(kNotch, io.MouseWheel)) / 10;
    ui.emit(edit::Set<&EditingAids::brush_radius>{
        std::clamp(wish, static_cast<float>(world::kLeastBrush), static_cast<float>(world::kLargestBrush))});
  }
  std::optional<glm::vec2> at;
  if (over || stroke_) at = under_mouse(ui.find.ground(), view);
  if (over && at && !stroke_ && io.MouseClicked[ImGuiMouseButton_Left] && !io.KeyAlt) press(ui, *at);
  if (stroke_ && at) paint(ui, *at);
  if (at) draw_ring(ui, view, *at, radius);
  if (slope_from_) draw_ring(ui, view, *slope_from_, radius);
  if (slope_from_ && at) draw_way(ui, view, *slope_from_, *at);
  if (stroke_ && !io.MouseDown[ImGuiMouseButton_Left]) end(ui);
}

bool GroundBrush::cancel(Ui& ui) {
  if (!stroke_) return std::exchange(slope_from_, std::nullopt).has_value();
  if (stroke_->gesture) ui.emit(edit::CancelGesture{});
  stroke_.reset();
  return true;
}

void GroundBrush::press(Ui& ui, glm::vec2 at) {
  const EditingAids& aids = *ui.session().settings.aids;
  if (aids.brush != Brush::slope) {
    stroke_ = Stroke{.last = at, .height = ui.find.ground().land().height(at.x, at.y)};
  } else if (!slope_from_) {
    slope_from_ = at;
  } else if (glm::distance(at, *slope_from_) > 1) {  // the second click of a double click ends none
    ui.emit(edit::SlopeGround{*slope_from_, at, double{aids.brush_radius}});
    slope_from_.reset();
  }
}

// Dabs follow each other in time, so that a mouse held still goes on; woods only where it moves.
void GroundBrush::paint(Ui& ui, glm::vec2 at) {
  const EditingAids& aids = *ui.session().settings.aids;
  constexpr int kMost = 4;  // in one frame
  stroke_->due -= double{ImGui::GetIO().DeltaTime};
  const bool moved = !stroke_->gesture || glm::distance(at, stroke_->last) > 0.25f * aids.brush_radius;
  if (aids.brush == Brush::woods) {
    if (moved) dab(ui, at);
    return;
  }
  if (!stroke_->gesture) stroke_->due = 0;
  for (int i = 0; i < kMost && stroke_->due <= 0; ++i, stroke_->due += kBetweenDabs) dab(ui, at);
  stroke_->due = std::max(stroke_->due, 0.0);
}

void GroundBrush::dab(Ui& ui, glm::vec2 at) {
  const EditingAids& aids = *ui.session().settings.aids;
  const ImGuiIO& io = ImGui::GetIO();
  if (!stroke_->gesture) ui.emit(edit::BeginGesture{});
  stroke_->gesture = true, stroke_->last = at;
  const double radius{aids.brush_radius};
  switch (aids.brush) {
    case Brush::raise: {
      const double by = kBetweenDabs * std::max(0.35 * radius, 1.5);  // m
      ui.emit(edit::RaiseGround{at, radius, io.KeyShift ? -by : by});
      break;
    }
    case Brush::smooth: ui.emit(edit::SmoothGround{at, radius}); break;
    case Brush::flatten: ui.emit(edit::FlattenGround{at, radius, stroke_->height}); break;
    case Brush::woods:
      if (io.KeyCtrl) ui.emit(edit::ResetWoods{at, radius});
      else ui.emit(edit::PaintWoods{at, radius, io.KeyShift ? 0.0 : 1.0});
      break;
    case Brush::off:
    case Brush::slope: break;
  }
}

void GroundBrush::end(Ui& ui) {
  if (stroke_->gesture) ui.emit(edit::EndGesture{});
  stroke_.reset();
}

}  // namespace coaster::ui
