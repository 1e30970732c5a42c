#include "view/marks.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "view/gizmo.h"

namespace coaster::view {
namespace {

constexpr double kLargestMark = 64;  // points, more than the radius and the reach of any mark

bool is_handle(PickKind kind) {
  return kind == PickKind::handle_in || kind == PickKind::handle_out || kind == PickKind::spin;
}

// The square of the distance from the eye (m^2) or, in a parallel view, the depth: what orders marks.
double distance_of(const View& view, const glm::dvec3& away) {
  return view.parallel > 0 ? glm::dot(away, glm::dvec3(line_of_sight(view))) : glm::dot(away, away);
}

// Returns the least distance_of() the points of a box. Rounded in the same way, it is never more than that of a point.
double least_distance(const View& view, const curve::Box& box) {
  const glm::dvec3 low = glm::dvec3(box.low) - glm::dvec3(view.eye), high = glm::dvec3(box.high) - glm::dvec3(view.eye);
  const glm::dvec3 nearest = view.parallel > 0
                                 ? glm::mix(high, low, glm::greaterThan(glm::dvec3(line_of_sight(view)), glm::dvec3(0)))
                                 : glm::max(glm::max(low, -high), glm::dvec3(0));
  return distance_of(view, nearest);
}

// Keeps those marks of the ones offered that cover all others, behind those that a list has.
class TopMarks {
 public:
  TopMarks(std::size_t most, std::vector<PlacedMark>& marks) : most_(most), marks_(marks), first_(marks.size()) {}

  bool takes(double distance) const {
    return marks_.size() < most_ || (first_ < marks_.size() && distance <= marks_[first_].distance);
  }
  void offer(const PlacedMark& mark) {
    const auto heap = [this] { return marks_.begin() + static_cast<std::ptrdiff_t>(first_); };  // the farthest is first
    if (marks_.size() >= most_) {
      if (heap() == marks_.end() || !covers(mark, *heap())) return;
      std::pop_heap(heap(), marks_.end(), covers);
      marks_.pop_back();
    }
    marks_.push_back(mark);
    std::push_heap(heap(), marks_.end(), covers);
  }

 private:
  std::size_t most_;
  std::vector<PlacedMark>& marks_;
  std::size_t first_;
};

// The parts of marks_on_screen().
class MarkSearch {
 public:
  MarkSearch(const world::Document& document, const world::Settings& settings, const View& view,
             const SelectionLookup& selected, const MarkChoice& choice)
      : document_(document),
        settings_(settings),
        view_(view),
        selected_(selected),
        choice_(choice),
        projector_(view),
        knots_(document.track.knots) {}

  // Adds what shows at any distance: the marks of the active and of the hovered knot, and handles.
  void add_near_and_far(std::vector<PlacedMark>& marks) const {
    const auto add = [&](PickKind kind, world::Entity knot, glm::vec3 position, std::size_t order) {
      const bool shows =
          kind == PickKind::spin || choice_.all || selected_(knot) || choice_.hovered == Pick{kind, knot};
      const auto mark = shows ? placed(kind, knot, position, order) : std::nullopt;
      if (mark) marks.push_back(*mark);
    };
    const auto add_knot = [&](world::Entity e) {
      const world::Knot* const knot = document_.entities.find<world::Knot>(e);
      if (knot) add(PickKind::knot, e, knot->position, world::index_of(knots_, e).value_or(0));
    };
    add_knot(settings_.selected);
    if (choice_.hovered.entity != settings_.selected) add_knot(choice_.hovered.entity);
    for (const world::Entity e : knots_with_handles(document_, settings_)) {
      const world::Knot& knot = world::knot(document_, e);
      const std::size_t order = 2 * world::index_of(knots_, e).value_or(0);
      add(PickKind::handle_in, e, world::in_handle(knot), order);
      add(PickKind::handle_out, e, world::out_handle(knot), order + 1);
    }
    if (const auto ring = choice_.spin ? spin_ring_of(document_, settings_, view_) : std::nullopt)
      add(PickKind::spin, ring->knot, glm::vec3(ring->handle()), 2 * knots_.size());
  }

  // Adds the nearest of all others.
  void add_nearest(const sim::DerivedTrack& derived, MarksOnScreen& found) const {
    TopMarks top(choice_.most, found.marks);
    const auto offer = [&](std::size_t i, glm::vec3 position) {
      const world::Entity e = knots_[i];
      if (e == settings_.selected || e == choice_.hovered.entity || !(choice_.all || selected_(e))) return;
      ++found.looked_at;
      if (const auto mark = placed(PickKind::knot, e, position, i)) top.offer(*mark);
    };
    const std::vector<world::Knot>& made_from = derived.made.knots;  // the same knots, side by side
    if (made_from.size() != knots_.size() || derived.order.empty()) {
      for (std::size_t i = 0; i < knots_.size(); ++i) offer(i, world::knot(document_, knots_[i]).position);
      return;
    }
    if (!derived.closed) offer(knots_.size() - 1, made_from.back().position);  // no segment begins there
    const auto distance = [&](const curve::Box& box) {
      const bool seen = projector_.may_show(box, kLargestMark * view_.density);
      return seen ? std::optional(least_distance(view_, box)) : std::nullopt;
    };
    sim::all_by_key(
        derived.tree, distance, [&](double least) { return top.takes(least); },
        [&](std::size_t i) { offer(i, made_from[i].position); });
  }

 private:
  std::optional<PlacedMark> placed(PickKind kind, world::Entity knot, glm::vec3 position, std::size_t order) const {
    auto mark = placed_mark(projector_, view_, kind, knot, position);
    if (mark) mark->order = order;
    return mark;
  }

  const world::Document& document_;
  const world::Settings& settings_;
  const View& view_;
  const SelectionLookup& selected_;
  const MarkChoice& choice_;
  Projector projector_;
  const std::vector<world::Entity>& knots_;
};

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
  return PlacedMark{kind, knot, position, *pixel, distance_of(view, glm::dvec3(position) - glm::dvec3(view.eye)), 0};
}

SelectionLookup::SelectionLookup(const world::Settings& settings) : active_(settings.selected) {
  for (const world::Entity e : settings.also) {
    if (e.index >= also_.size()) also_.resize(e.index + 1, world::kNone);
    also_[e.index] = e;
  }
}

MarksOnScreen marks_on_screen(const world::Document& document, const sim::DerivedTrack& derived,
                              const world::Settings& settings, const View& view, const SelectionLookup& selected,
                              const MarkChoice& choice) {
  const MarkSearch search(document, settings, view, selected, choice);
  MarksOnScreen found;
  search.add_near_and_far(found.marks);
  if (choice.all || selected.several()) search.add_nearest(derived, found);
  return found;
}

bool covers(const PlacedMark& a, const PlacedMark& b) {
  if (is_handle(a.kind) != is_handle(b.kind)) return is_handle(a.kind);
  if (a.distance != b.distance) return a.distance < b.distance;
  return a.order < b.order;
}

}  // namespace coaster::view
