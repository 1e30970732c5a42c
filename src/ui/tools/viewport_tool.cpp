// The mouse in the viewport.
#include "ui/tools/viewport_tool.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "edit/commands/set_setting.h"
#include "sim/ground/land.h"
#include "sim/plan/element_shapes.h"
#include "ui/tools/camera_controls.h"
#include "ui/widgets/theme.h"
#include "view/gizmo.h"
#include "world/aid_settings.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {

namespace {

// Returns the place on the ray that is `standing` m above land or water.
std::optional<glm::vec3> on_land(const view::Ray& ray, const sim::Land& land, float standing) {
  auto at = view::meet_land(ray, land, double{standing});
  if (at) at->y = static_cast<float>(land.standing(double{at->x}, double{at->z}, double{standing}));
  return at;
}

}  // namespace

std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel) {
  const auto standing = static_cast<float>(sim::TrackEnd{}.position.y);
  const view::Ray ray = view::ray_through(view, pixel);
  const world::Track& track = document.track;
  const sim::Land land(document.park);
  if (view.parallel <= 0 && !land.plain()) return on_land(ray, land, standing);
  if (view.parallel <= 0) {
    const auto ground = view::meet_plane(ray, glm::vec3(0), {0, 1, 0});
    const auto at = ray.origin.y > standing ? view::meet_plane(ray, {0, standing, 0}, {0, 1, 0}) : ground;
    return ground && at ? std::optional(glm::vec3(at->x, standing, at->z)) : std::nullopt;
  }
  const auto first = static_cast<float>(land.standing(0, 0, double{standing}));
  const glm::vec3 normal = view::line_of_sight(view), last = track.knots.empty()
                                                                 ? glm::vec3(0, first, 0)
                                                                 : world::knot(document, track.knots.back()).position;
  auto at = view::meet_plane(ray, last, normal);
  if (!at) return at;
  for (int i = 0; i < 3; ++i)
    if (std::abs(normal[i]) == 1) (*at)[i] = last[i];  // exactly
  if (land.plain()) at->y = std::max(at->y, standing);
  return at;
}

namespace {

using view::PickKind;

// Returns what is under the mouse. A finger covers more than a pixel: where it is exactly on no mark, it takes one
// nearby.
view::Pick under_mouse(const Ui& ui, const view::View& view) {
  constexpr float kFinger = 16;  // points from a knot's middle
  const edit::Session& s = ui.session();
  const auto at = [&](const view::View& from) {
    return view::pick(s.document, s.derived, s.motion, s.settings, from, mouse_position());
  };
  const view::Pick exact = at(view);
  if (!ui.finger || (exact.kind != PickKind::none && exact.kind != PickKind::curve)) return exact;
  view::View grown = view;
  grown.reach = kFinger * ui.scale / (view::kKnotRadius * view::mark_scale(s.settings, view));
  const view::Pick near = at(grown);
  return near.kind == PickKind::none || (near.kind == PickKind::curve && exact.kind == PickKind::curve) ? exact : near;
}

// Returns the track or train under the cursor if it is in front of the whole gizmo at `gizmo`, m.
std::optional<view::Pick> in_front_of_gizmo(const Ui& ui, const view::View& view, glm::vec3 gizmo) {
  const edit::Session& s = ui.session();
  world::Settings settings = s.settings;
  settings.aids->show_gizmo = false;
  const view::Pick pick = view::pick(s.document, s.derived, s.motion, settings, view, mouse_position());
  const auto depth = [&](glm::vec3 at) { return glm::dot(at - view.eye, view::line_of_sight(view)); };
  const float reach =
      view::kGizmoLength * view::mark_scale(s.settings, view) * view::metres_per_pixel(view, depth(gizmo));
  const bool solid = pick.kind == PickKind::curve || pick.kind == PickKind::cart;
  return solid && depth(pick.position) < depth(gizmo) - reach ? std::optional(pick) : std::nullopt;
}

bool is_handle(PickKind kind) { return kind == PickKind::handle_in || kind == PickKind::handle_out; }

// Returns the present position of a knot or handle.
glm::vec3 item_position(const world::Document& document, const view::Pick& pick) {
  const world::Knot& knot = world::knot(document, pick.entity);
  if (pick.kind == PickKind::handle_in) return world::in_handle(knot);
  if (pick.kind == PickKind::handle_out) return world::out_handle(knot);
  return knot.position;
}

}  // namespace

view::Pick ViewportTool::update(Ui& ui, const view::View& view) {
  const ImGuiIO& io = ImGui::GetIO();
  const edit::Session& session = ui.session();
  const glm::vec2 mouse = mouse_position();
  if (transform_.active()) {
    if (transform_.update(ui, view) && in_front_)
      ui.emit(edit::Select{{world::name_of(session.document, in_front_->entity)}, in_front_->t});
    return {};
  }
  // An undo or a script may have ended the gesture, or removed what is dragged.
  if (drag_.gesture && !session.history.in_gesture) drag_ = {};
  if (dragging() && drag_.pick.kind != PickKind::none && !session.document.entities.alive(drag_.pick.entity))
    cancel(ui);

  const bool over = view.viewport.contains(mouse) && !io.WantCaptureMouse;
  const bool brushes = GroundBrush::chosen(session);
  if ((brushes && !dragging()) || brush_.painting()) brush_.update(ui, view, over);
  if (brush_.painting()) return {};
  view::Pick under;
  if (over && !dragging()) {
    if (!brushes) under = under_mouse(ui, view);
    if (!brushes || io.KeyAlt || !io.MouseClicked[ImGuiMouseButton_Left]) press(ui, view, under);
  }
  const bool turned = over && io.MouseWheel != 0 && (!brushes || io.KeyCtrl);
  if (turned) turn_wheel(ui, view, io.MouseWheel);
  if (!dragging()) return under;

  const view::Pick held = drag_.pick;
  // The wheel has moved the camera in this frame; a drag of it continues in the next one.
  if (!turned || (drag_.what != DragTarget::orbit && drag_.what != DragTarget::pan)) move(ui, view, mouse);
  if (!io.MouseDown[drag_.button]) release(ui, view);
  return held;
}

bool ViewportTool::cancel(Ui& ui) {
  if (transform_.cancel(ui) || brush_.cancel(ui)) return true;
  if (box_waits_ && drag_.what == DragTarget::nothing) return box_waits_ = false, true;
  if (!dragging()) return false;
  if (drag_.gesture) ui.emit(edit::CancelGesture{});
  drag_ = {};
  return true;
}

void ViewportTool::press(Ui& ui, const view::View& view, const view::Pick& under) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto begin = [&](DragTarget what, int button) {
    drag_ = {};
    drag_.what = what;
    drag_.button = button;
    drag_.start = drag_.last = mouse_position();
    drag_.shift = io.KeyShift, drag_.ctrl = io.KeyCtrl;
  };
  if (io.MouseClicked[ImGuiMouseButton_Left]) {
    begin(DragTarget::orbit, ImGuiMouseButton_Left);
    const bool waited = std::exchange(box_waits_, false);
    if (waited || (under.kind == PickKind::none && !io.KeyAlt && (io.KeyShift || io.KeyCtrl))) {
      drag_.what = DragTarget::box;
      drag_.box = io.KeyShift ? BoxMode::add : io.KeyCtrl ? BoxMode::remove : BoxMode::replace;
    } else if (view::is_gizmo(under.kind)) {
      drag_ = {};
      in_front_ = in_front_of_gizmo(ui, view, under.position);
      const Constraint constraint{view::is_axis(under.kind) ? Constraint::Kind::axis : Constraint::Kind::plane,
                                  view::gizmo_axis(under.kind)};
      transform_.begin(ui, TransformKind::move, constraint, ImGuiMouseButton_Left);
    } else if (!io.KeyAlt) {
      press_left(ui, under);
    }
  } else if (io.MouseClicked[ImGuiMouseButton_Right]) {
    begin(io.KeyShift ? DragTarget::pan : DragTarget::orbit, ImGuiMouseButton_Right);
  } else if (io.MouseClicked[ImGuiMouseButton_Middle]) {
    begin(DragTarget::pan, ImGuiMouseButton_Middle);
  }
}

void ViewportTool::press_left(Ui& ui, const view::Pick& under) {
  const edit::Session& session = ui.session();
  const bool chose = std::exchange(chose_section_, false);  // a second click then is no double click
  const bool twice = ImGui::GetIO().MouseDoubleClicked[ImGuiMouseButton_Left] && !chose;
  drag_.pick = under;
  if (auto section = section_click(session, under, drag_.shift)) {
    chose_section_ = true;
    return ui.out.commands.push_back(std::move(*section));
  }
  if (under.kind == PickKind::none) {
    drag_.click_acts = !twice;
    return;
  }
  const edit::Target target{world::name_of(session.document, under.entity)};
  if (under.kind == PickKind::curve) {
    drag_.what = DragTarget::place;
    if (twice) {
      drag_.what = DragTarget::cart;  // the position is gone with the split: the rest of the press does nothing
      ui.emit(edit::SplitSegment{target, under.t});
    } else {
      ui.emit(edit::Select{target, under.t});
    }
    return;
  }
  if (under.kind == PickKind::spin && twice) {
    drag_.what = DragTarget::nothing;
    ui.emit(edit::AutomaticSpin{target.name});
    return;
  }
  if (view::is_section_handle(under.kind)) {
    drag_.what = DragTarget::section;
    return;
  }
  drag_.what = under.kind == PickKind::cart   ? DragTarget::cart
               : under.kind == PickKind::spin ? DragTarget::spin
                                              : DragTarget::item;
  // With Shift or Ctrl a click adds to the selection and a drag moves; which of them it is is not known yet.
  const bool waits =
      under.kind == PickKind::knot && (drag_.shift || drag_.ctrl || world::is_selected(session.settings, under.entity));
  if (!is_handle(under.kind) && under.kind != PickKind::spin && session.settings.selected != under.entity && !waits)
    ui.emit(edit::Select{target});
}

void ViewportTool::move(Ui& ui, const view::View& view, glm::vec2 mouse) {
  drag_.moved = drag_.moved || glm::length(mouse - drag_.start) >= ImGui::GetIO().MouseDragThreshold;
  if (!drag_.moved) return;
  const edit::Session& session = ui.session();
  const world::Camera& camera = session.settings.camera;
  const glm::vec2 by = mouse - drag_.last;
  const world::CameraMode mode = shown_camera(ui);
  const bool turns = by != glm::vec2(0) && mode == world::CameraMode::orbit;
  switch (drag_.what) {
    case DragTarget::orbit:
      if (turns) set_camera(ui, orbited(camera, by, ui.scale));
      if (by != glm::vec2(0) && mode == world::CameraMode::fly)
        ui.emit(edit::SetFlyCamera{looked(fly_now(ui), by, ui.scale)});
      break;
    case DragTarget::pan:
      if (turns) ui.emit(edit::set_camera(panned(camera, view, by)));
      break;
    case DragTarget::item: move_item(ui, view, mouse); break;
    case DragTarget::spin: turn_spin(ui, view, mouse); break;
    case DragTarget::section:
      if (drag_.pick.kind == PickKind::section) pull_section(ui, view, mouse);
      else turn_section(ui, view, mouse);
      break;
    case DragTarget::box: {
      const glm::vec2 low = glm::min(drag_.start, mouse), high = glm::max(drag_.start, mouse);
      ImDrawList& list = *ImGui::GetBackgroundDrawList();
      list.AddRectFilled({low.x, low.y}, {high.x, high.y}, packed(palette().accent, 0.14f));
      list.AddRect({low.x, low.y}, {high.x, high.y}, packed(palette().accent, 0.9f), 0, 0, std::max(1.0f, ui.scale));
      break;
    }
    case DragTarget::place:
      if (by == glm::vec2(0)) break;
      if (const auto place = view::pick_segment(session.derived, view, mouse, drag_.pick.entity))
        ui.emit(edit::Select{{world::name_of(session.document, place->entity)}, place->t});
      break;
    case DragTarget::cart:
    case DragTarget::nothing: break;
  }
  drag_.last = mouse;
}

void ViewportTool::move_item(Ui& ui, const view::View& view, glm::vec2 mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  const world::Document& document = ui.session().document;
  const DragPlane along = io.KeyShift ? DragPlane::vertical : io.KeyCtrl ? DragPlane::ground : DragPlane::screen;
  const auto hit = [&](glm::vec2 pixel) -> std::optional<glm::vec3> {
    const view::Ray ray = view::ray_through(view, pixel);
    if (along == DragPlane::screen) return view::meet_plane(ray, drag_.anchor, view::line_of_sight(view));
    if (along == DragPlane::ground) return view::meet_plane(ray, drag_.anchor, {0, 1, 0});
    const auto height = view::meet_vertical(ray, drag_.anchor);
    return height ? std::optional(glm::vec3(drag_.anchor.x, *height, drag_.anchor.z)) : std::nullopt;
  };
  if (!drag_.grabbed || along != drag_.along) {  // another plane continues from the present position of the item
    drag_.along = along;
    drag_.anchor = drag_.sent = item_position(document, drag_.pick);
    const auto at = hit(drag_.last);
    drag_.grabbed = at.has_value();
    if (!at) return;
    drag_.offset = drag_.anchor - *at;
  }
  const auto at = hit(mouse);
  if (!at) return;
  glm::vec3 to = *at + drag_.offset;
  const world::Settings& settings = ui.session().settings;
  if (drag_.pick.kind == PickKind::knot) draw_snap_label(ui, TransformKind::move, settings.snapping.to);
  if (drag_.pick.kind == PickKind::knot && settings.snapping.to != world::SnapTo::off) {
    const Constraint constraint{along == DragPlane::vertical ? Constraint::Kind::axis
                                : along == DragPlane::ground ? Constraint::Kind::plane
                                                             : Constraint::Kind::free,
                                1};
    to = glm::vec3(snapped({document, settings, view, mouse}, settings.snapping.to, glm::dvec3(to),
                           glm::dvec3(drag_.anchor), constraint));
  }
  if (to == drag_.sent) return;
  if (!world::is_selected(settings, drag_.pick.entity) && drag_.pick.kind == PickKind::knot)
    ui.emit(edit::Select{{world::name_of(document, drag_.pick.entity)}});
  if (!drag_.gesture) ui.emit(edit::BeginGesture{});
  drag_.gesture = true;
  drag_.sent = to;
  const world::EntityName name = world::name_of(document, drag_.pick.entity);
  if (drag_.pick.kind == PickKind::knot && world::is_selected(settings, drag_.pick.entity) && !settings.also.empty()) {
    move_knots(ui, to);
  } else if (drag_.pick.kind == PickKind::knot) {
    ui.emit(edit::MoveKnot{{name}, to});
  } else {
    const auto end = drag_.pick.kind == PickKind::handle_in ? edit::HandleEnd::in : edit::HandleEnd::out;
    ui.emit(edit::MoveHandle{{name, end}, to});
  }
}

void ViewportTool::turn_spin(Ui& ui, const view::View& view, glm::vec2 mouse) {
  const edit::Session& session = ui.session();
  const auto ring = view::spin_ring_of(session.document, session.settings, view);
  if (!ring) return;
  const auto spin = view::spin_under(*ring, view::ray_through(view, mouse));
  if (!spin) return;
  if (!drag_.gesture) ui.emit(edit::BeginGesture{});
  drag_.gesture = true;
  const double step = ImGui::GetIO().KeyCtrl ? 1.0 : 0.01;  // deg/m
  ui.emit(edit::SetSpin{world::name_of(session.document, ring->knot), std::round(base::degrees(*spin) / step) * step});
}

// Moves all selected knots by the movement of the dragged one.
void ViewportTool::move_knots(Ui& ui, glm::vec3 to) {
  const edit::Session& session = ui.session();
  edit::Knots knots(names_of(session.document, world::selected_knots(session.document, session.settings)));
  const world::Document& start = session.history.in_gesture ? session.history.gesture_start : session.document;
  const glm::dvec3 from(world::knot(start, drag_.pick.entity).position);
  ui.emit(edit::Translate{std::move(knots), glm::vec3(glm::dvec3(to) - from), true});
}

void ViewportTool::click_knot(Ui& ui) {
  const edit::Session& session = ui.session();
  const world::Entity knot = drag_.pick.entity;
  if (drag_.shift) ui.out.commands.push_back(toggled(session, knot));
  else if (drag_.ctrl) ui.out.commands.push_back(up_to(session, knot));
  else if (!session.settings.also.empty()) ui.emit(edit::Select{{world::name_of(session.document, knot)}});
}

void ViewportTool::release(Ui& ui, const view::View& view) {
  if (drag_.gesture) ui.emit(edit::EndGesture{});
  if (!drag_.moved && drag_.click_acts) click_ground(ui, view);
  if (!drag_.moved && drag_.what == DragTarget::item && drag_.pick.kind == PickKind::knot) click_knot(ui);
  if (!drag_.moved && drag_.pick.kind == PickKind::section) click_handle(ui);
  if (drag_.moved && drag_.what == DragTarget::box)
    if (auto chosen = boxed(ui.session(), view, drag_.start, drag_.last, drag_.box))
      ui.out.commands.push_back(std::move(*chosen));
  drag_ = {};
}

void ViewportTool::click_ground(Ui& ui, const view::View& view) {
  const edit::Session& session = ui.session();
  const world::Track& track = session.document.track;
  const bool appends = session.settings.aids->append_mode;
  if ((appends && !track.closed) || (track.knots.empty() && !session.settings.aids->show_element)) {
    const auto at = append_place(session.document, view, drag_.start);
    if (at) ui.emit(edit::AppendKnot{*at});
    if (at && !appends) ui.emit(edit::Set<&world::EditingAids::append_mode>{true});
  } else if (session.settings.selected.valid()) {
    ui.emit(edit::Select{});
  }
}

void ViewportTool::pull_section(Ui& ui, const view::View& view, glm::vec2 mouse) {
  const edit::Session& session = ui.session();
  const auto handle = view::section_handle(session.document, session.derived, drag_.pick.entity);
  if (!handle) return;
  const auto under = [&](glm::vec2 pixel) { return view::value_under(*handle, view::ray_through(view, pixel)); };
  if (!drag_.grip) {
    const auto grabbed = under(drag_.start);
    if (!grabbed || *grabbed == 0) return;
    drag_.grip = handle->value / *grabbed;
  }
  const auto value = under(mouse);
  if (!value) return;
  const double steps = ImGui::GetIO().KeyCtrl ? 1 : 20;  // per metre
  change_section(ui, handle->parameter, std::round(*value * *drag_.grip * steps) / steps);
}

void ViewportTool::turn_section(Ui& ui, const view::View& view, glm::vec2 mouse) {
  const edit::Session& session = ui.session();
  const auto handle = view::angle_handle(session.document, session.derived, drag_.pick.entity, drag_.pick.kind);
  if (!handle) return;
  const auto under = [&](glm::vec2 pixel, double near) {
    return view::angle_under(*handle, view::ray_through(view, pixel), near);
  };
  if (!drag_.grip) {
    const auto grabbed = under(drag_.start, handle->angle);
    if (!grabbed) return;
    drag_.grip = handle->angle - *grabbed;
  }
  const auto angle = under(mouse, handle->angle - *drag_.grip);
  if (!angle) return;
  const double step = ImGui::GetIO().KeyCtrl ? 5 : 0.5;  // deg
  change_section(ui, handle->parameter, std::round((*angle + *drag_.grip) / step) * step * handle->whole);
}

// Changes the section whose handle is dragged, planned again from the drag's start.
void ViewportTool::change_section(Ui& ui, std::string_view parameter, double value) {
  const edit::Session& session = ui.session();
  world::Element to = world::section(session.document, drag_.pick.entity).element;
  const double now = world::value_of(to, parameter);
  world::set_value(to, parameter, value);
  if (world::value_of(to, parameter) == now) return;
  if (!drag_.gesture) ui.emit(edit::BeginGesture{});
  drag_.gesture = true;
  ui.emit(edit::ChangeSection{{world::name_of(session.document, drag_.pick.entity)}, true, to});
}

// A click selects the knot under a section's handle, at the section's end.
void ViewportTool::click_handle(Ui& ui) {
  constexpr float kThere = 1e-3f;  // m
  const world::Document& document = ui.session().document;
  const std::vector<world::Entity>& knots = document.track.knots;
  const world::Entity knot = knots[world::run_of(document, drag_.pick.entity).end() % knots.size()];
  if (glm::distance(world::knot(document, knot).position, drag_.pick.position) < kThere)
    ui.emit(edit::Select{{world::name_of(document, knot)}});
}

void ViewportTool::turn_wheel(Ui& ui, const view::View& view, float notches) {
  constexpr float kMetres = 2;
  const world::Settings& settings = ui.session().settings;
  switch (shown_camera(ui)) {
    case world::CameraMode::orbit:
      ui.emit(edit::set_camera(zoomed(settings.camera, view, mouse_position(), notches)));
      break;
    case world::CameraMode::fly:
      ui.emit(edit::SetFlyCamera{flown(fly_now(ui), {0, 0, kMetres * notches}, ui.find.ground())});
      break;
    case world::CameraMode::chase: zoom_chase(ui, notches); break;
    case world::CameraMode::ride: break;
  }
}

}  // namespace coaster::ui
