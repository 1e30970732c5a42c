#include "ui/tools/cursor_places.h"

#include <algorithm>
#include <cmath>

#include "sim/plan/element_shapes.h"
#include "view/gizmo.h"
#include "world/aids.h"

namespace coaster::ui {

std::optional<glm::vec3> append_place(const world::Document& document, const view::View& view, glm::vec2 pixel) {
  const auto standing = static_cast<float>(sim::TrackEnd{}.position.y);
  const view::Ray ray = view::ray_through(view, pixel);
  const world::Track& track = document.track;
  if (view.parallel <= 0) {
    const auto ground = view::meet_plane(ray, glm::vec3(0), {0, 1, 0});
    const auto at = ray.origin.y > standing ? view::meet_plane(ray, {0, standing, 0}, {0, 1, 0}) : ground;
    return ground && at ? std::optional(glm::vec3(at->x, standing, at->z)) : std::nullopt;
  }
  const glm::vec3 normal = view::line_of_sight(view), last = track.knots.empty()
                                                                 ? glm::vec3(0, standing, 0)
                                                                 : world::knot(document, track.knots.back()).position;
  auto at = view::meet_plane(ray, last, normal);
  if (!at) return at;
  for (int i = 0; i < 3; ++i)
    if (std::abs(normal[i]) == 1) (*at)[i] = last[i];  // exactly
  at->y = std::max(at->y, standing);
  return at;
}

view::Pick under_mouse(const Ui& ui, const view::View& view) {
  using view::PickKind;
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

std::optional<view::Pick> in_front_of_gizmo(const Ui& ui, const view::View& view, glm::vec3 gizmo) {
  using view::PickKind;
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

}  // namespace coaster::ui
