#include "view/marks.h"

#include <algorithm>

#include "view/spin_ring.h"

namespace coaster::view {
namespace {

constexpr float kLargestMark = 64;  // points, more than the radius and the reach of any mark

bool is_handle(PickKind kind) {
  return kind == PickKind::handle_in || kind == PickKind::handle_out || kind == PickKind::spin;
}

}  // namespace

Projector::Projector(const View& view)
    : matrix_(glm::dmat4(view.projection) * glm::dmat4(view.view)), viewport_(view.viewport) {}

std::optional<glm::dvec2> Projector::operator()(glm::dvec3 world) const {
  const glm::dvec4 clip = matrix_ * glm::dvec4(world, 1);
  if (!(clip.w > 1e-4) || !(std::abs(clip.z) <= clip.w)) return std::nullopt;
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  return glm::dvec2(viewport_.x + (ndc.x + 1) * 0.5 * viewport_.width,
                    viewport_.y + (1 - ndc.y) * 0.5 * viewport_.height);
}

bool Projector::may_show(const curve::Box& box, double margin) const {
  constexpr double kRounding = 1e-9;
  const auto row = [&](int i) { return glm::dvec4(matrix_[0][i], matrix_[1][i], matrix_[2][i], matrix_[3][i]); };
  // Negative values of a plane are on its far side.
  const auto is_beyond = [&](const glm::dvec4& plane) {
    glm::dvec4 corner(0, 0, 0, 1);
    for (int a = 0; a < 3; ++a) corner[a] = plane[a] > 0 ? box.high[a] : box.low[a];
    const glm::dvec4 terms = plane * corner;
    return terms.x + terms.y + terms.z + terms.w <
           -kRounding * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w));
  };
  const glm::dvec4 w = row(3);
  const auto is_outside = [&](const glm::dvec4& of_axis, const glm::dvec4& border) {
    return is_beyond(border + of_axis) || is_beyond(border - of_axis);
  };
  return !is_beyond(w) && !is_outside(row(2), w) && !is_outside(row(0), w * (1 + 2 * margin / viewport_.width)) &&
         !is_outside(row(1), w * (1 + 2 * margin / viewport_.height));
}

std::vector<world::Entity> knots_with_handles(const world::Document& document, const world::Settings& settings) {
  if (document.entities.find<world::Knot>(settings.selected)) return {settings.selected};
  if (const world::Segment* const s = document.entities.find<world::Segment>(settings.selected))
    return {s->from, s->to};
  return {};
}

std::optional<PlacedMark> placed_mark(const Projector& projector, const View& view, PickKind kind, world::Entity knot,
                                      glm::vec3 position) {
  const auto pixel = projector(position);
  if (!pixel) return std::nullopt;
  const glm::dvec2 first(view.viewport.x, view.viewport.y), size(view.viewport.width, view.viewport.height);
  const glm::dvec2 off = glm::max(first - *pixel, *pixel - first - size);
  if (std::max(off.x, off.y) > kLargestMark * view.density) return std::nullopt;
  const glm::dvec3 away = glm::dvec3(position) - glm::dvec3(view.eye);
  const double distance = view.parallel > 0 ? glm::dot(away, glm::dvec3(line_of_sight(view))) : glm::dot(away, away);
  return PlacedMark{kind, knot, position, *pixel, distance, 0};
}

MarksOnScreen marks_on_screen(const world::Document& document, const sim::Derived& derived,
                              const world::Settings& settings, const View& view) {
  const Projector projector(view);
  MarksOnScreen found;
  const auto add = [&](PickKind kind, world::Entity knot, glm::vec3 position, std::size_t order) {
    auto mark = placed_mark(projector, view, kind, knot, position);
    if (!mark) return;
    mark->order = order;
    found.marks.push_back(*mark);
  };
  const std::vector<world::Entity>& knots = document.track.knots;
  const auto add_knot = [&](std::size_t i, const world::Knot& knot) {
    ++found.looked_at;
    add(PickKind::knot, knots[i], knot.position, i);
    return true;
  };
  const std::vector<world::Knot>& made_from = derived.made.knots;  // the same knots, side by side
  if (made_from.size() != knots.size() || derived.order.empty()) {
    for (std::size_t i = 0; i < knots.size(); ++i) add_knot(i, world::knot(document, knots[i]));
  } else {
    sim::all_within(
        derived.tree, [&](const curve::Box& box) { return projector.may_show(box, kLargestMark * view.density); },
        [&](std::size_t i) { return add_knot(i, made_from[i]); });
    if (!derived.closed) add_knot(knots.size() - 1, made_from.back());  // no segment begins there
  }
  for (const world::Entity e : knots_with_handles(document, settings)) {
    const world::Knot& knot = world::knot(document, e);
    const std::size_t order = 2 * world::index_of(knots, e).value_or(0);
    add(PickKind::handle_in, e, world::in_handle(knot), order);
    add(PickKind::handle_out, e, world::out_handle(knot), order + 1);
  }
  if (const auto ring = spin_ring_of(document, settings, view))
    add(PickKind::spin, ring->knot, glm::vec3(ring->handle()), 2 * knots.size());
  return found;
}

bool covers(const PlacedMark& a, const PlacedMark& b) {
  if (is_handle(a.kind) != is_handle(b.kind)) return is_handle(a.kind);
  if (a.distance != b.distance) return a.distance < b.distance;
  return a.order < b.order;
}

}  // namespace coaster::view
