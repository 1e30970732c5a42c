// Picking: marks by their shapes on screen, trains by a ray against their boxes, the curve by a beam.
#include "view/pick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/ride/ride.h"
#include "sim/shape/derived_track.h"
#include "view/gizmo.h"
#include "view/marks.h"
#include "view/pick_cone.h"
#include "world/appearance_settings.h"

namespace coaster::view {
namespace {

using glm::dvec2;
using glm::dvec3;

float target_scale(const world::Settings& settings, const View& view) {
  return mark_scale(settings, view) * view.reach;
}

bool inside(const PlacedMark& mark, dvec2 pixel, double scale) {
  const dvec2 off = pixel - mark.pixel;
  if (mark.kind != PickKind::knot) return std::max(std::abs(off.x), std::abs(off.y)) <= kHandleHalf * scale;
  return glm::dot(off, off) <= kKnotRadius * scale * kKnotRadius * scale;
}

// Returns the topmost of marks_on_screen() under a pixel. Finds knots by the segment tree, not one by one.
std::optional<Pick> pick_mark(const world::Document& document, const sim::DerivedTrack& derived,
                              const world::Settings& settings, const View& view, glm::vec2 pixel) {
  const Projector projector(view);
  const std::vector<world::Entity>& knots = document.track.knots;
  std::optional<PlacedMark> best;
  const auto try_mark = [&](PickKind kind, world::Entity knot, glm::vec3 position, const auto& order) {
    auto mark = placed_mark(projector, view, kind, knot, position);
    if (!mark || !inside(*mark, pixel, target_scale(settings, view))) return;
    mark->order = order();
    if (!best || covers(*mark, *best)) best = mark;
  };
  const auto try_knot = [&](std::size_t i) {
    try_mark(PickKind::knot, knots[i], world::knot(document, knots[i]).position, [i] { return i; });
  };
  for (const world::Entity e : knots_with_handles(document, settings)) {
    const world::Knot& knot = world::knot(document, e);
    const auto order = [&] { return 2 * world::index_of(knots, e).value_or(0); };
    try_mark(PickKind::handle_in, e, world::in_handle(knot), order);
    try_mark(PickKind::handle_out, e, world::out_handle(knot), [&] { return order() + 1; });
  }
  if (const auto ring = spin_ring_of(document, settings, view))
    try_mark(PickKind::spin, ring->knot, glm::vec3(ring->handle()), [&] { return 2 * knots.size(); });
  if (!best && derived.order.empty()) {
    for (std::size_t i = 0; i < knots.size(); ++i) try_knot(i);
  } else if (!best) {  // handles are over knots
    // Segment i goes from knot i to the next one.
    const double reach = 1.001 * static_cast<double>(kKnotRadius * target_scale(settings, view));
    (void)visit_near(
        derived.tree, PixelBeam(view, pixel), [reach] { return reach; },
        [&](std::size_t i) {
          if (i < knots.size()) try_knot(i), try_knot((i + 1) % knots.size());
        });
  }
  if (!best) return std::nullopt;
  return Pick{best->kind, best->knot, 0, best->position};
}

glm::vec3 cart_middle(const sim::Pose& pose) {
  constexpr double kMiddle = 0.55;  // m above the rails
  return glm::vec3(pose.position + kMiddle * pose.frame.up);
}

// A box of a car (sim/solids/train_mesh.cpp), m ahead, up and to the left of its position on the rails.
struct CarBox {
  std::array<double, 3> low, high;
};
constexpr CarBox kCarBoxes[] = {{{-1.1, 0.0, -0.65}, {1.1, 1.1, 0.65}},   // body, wheels, riders up to the chin
                                {{-1.1, 1.1, -0.4}, {0.25, 1.45, 0.4}}};  // heads and headrests

// Returns the distances along the ray at which it enters and leaves a box; the first is greater if it misses.
std::pair<double, double> through_box(const CarBox& box, const dvec3& origin, const dvec3& direction) {
  double enter = -kNowhere, leave = kNowhere;
  for (int i = 0; i < 3; ++i) {
    const double low = box.low[static_cast<std::size_t>(i)] - origin[i],
                 high = box.high[static_cast<std::size_t>(i)] - origin[i];
    if (std::abs(direction[i]) < 1e-12) {
      if (low > 0 || high < 0) return {kNowhere, -kNowhere};
      continue;
    }
    const double a = low / direction[i], b = high / direction[i];
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

// Returns the distance along the ray to a car, kNowhere if it misses or starts inside.
double distance_to_car(const Ray& ray, const sim::Pose& pose) {
  constexpr double kInside = 0.05;  // m: the rider's eye is where the two boxes meet; hits closer than this are inside
  const auto in_car = [&](const dvec3& v) {
    return dvec3(glm::dot(v, pose.frame.forward), glm::dot(v, pose.frame.up), glm::dot(v, pose.frame.left()));
  };
  const dvec3 origin = in_car(dvec3(ray.origin) - pose.position), direction = in_car(dvec3(ray.direction));
  double nearest = kNowhere;
  for (const CarBox& box : kCarBoxes) {
    const auto [enter, leave] = through_box(box, origin, direction);
    if (enter > leave || (leave < 0 && !ray.endless)) continue;
    if (enter <= kInside && !ray.endless) return kNowhere;
    nearest = std::min(nearest, enter);
  }
  return nearest;
}

// A car under a pixel.
struct CarHit {
  double distance;  // m from the eye; negative: behind it, in an orthographic view
  glm::vec3 position;
};

// Returns the nearest of the cars for which hit(pose) gives a hit.
template <class HitCar>
std::optional<Pick> nearest_cart(const world::Document& document, const sim::DerivedTrack& derived,
                                 const world::Motion& motion, const world::Settings& settings, const HitCar& hit_car) {
  double nearest = kNowhere;
  std::optional<Pick> best;
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    const world::TrainMotion& cart = motion.carts.items()[i];
    const world::Entity entity = motion.carts.entities()[i];
    if (!derived.segments.contains(cart.segment)) continue;
    for (const sim::Pose& car : sim::car_poses(document, derived, entity, cart, settings.frames)) {
      const std::optional<CarHit> hit = hit_car(car);
      if (!hit || !(hit->distance < nearest)) continue;
      nearest = hit->distance;
      best = Pick{PickKind::cart, entity, 0, hit->position};
    }
  }
  return best;
}

// Picks a car by its boxes; if none is hit, by a few pixels around its middle, because a distant car is smaller than
// the knot below it.
std::optional<Pick> pick_cart(const world::Document& document, const sim::DerivedTrack& derived,
                              const world::Motion& motion, const world::Settings& settings, const View& view,
                              glm::vec2 pixel) {
  constexpr double kNotTheRiders = 2.5;  // m from the eye
  const Ray ray = ray_through(view, pixel);
  const float reach = kCartReach * target_scale(settings, view);
  const auto by_box = [&](const sim::Pose& car) {
    const double distance = distance_to_car(ray, car);
    return std::optional(CarHit{distance, ray.origin + static_cast<float>(distance) * ray.direction});
  };
  const auto by_middle = [&](const sim::Pose& car) -> std::optional<CarHit> {
    const glm::vec3 middle = cart_middle(car);
    const auto seen = project(view, middle);
    const bool ridden = !ray.endless && glm::distance(glm::dvec3(view.eye), car.position) < kNotTheRiders;
    if (!seen || std::abs(seen->z) > 1 || ridden || glm::distance(glm::vec2(seen->x, seen->y), pixel) > reach)
      return std::nullopt;
    const dvec3 away = dvec3(middle) - dvec3(view.eye);
    return CarHit{ray.endless ? glm::dot(away, dvec3(ray.direction)) : glm::length(away), middle};
  };
  if (const auto cart = nearest_cart(document, derived, motion, settings, by_box)) return cart;
  return nearest_cart(document, derived, motion, settings, by_middle);
}

// Returns the selected segment if the pixel is on the mark of its picked position.
std::optional<Pick> pick_place(const sim::DerivedTrack& derived, const world::Settings& settings, const View& view,
                               glm::vec2 pixel) {
  const sim::SegmentShape* const shape = derived.segments.find(settings.selected);
  if (shape == nullptr) return std::nullopt;
  const auto place = Projector(view)(curve::point(shape->key.cubic, settings.selected_t));
  if (!place || glm::length(*place - dvec2(pixel)) > static_cast<double>(kCurveReach * target_scale(settings, view)))
    return std::nullopt;
  return pick_segment(derived, view, pixel, settings.selected);
}

std::optional<Pick> pick_section_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                        const world::Settings& settings, const View& view, glm::vec2 pixel) {
  if (!section_handles_show(settings)) return std::nullopt;
  const Projector projector(view);
  const auto under = [&](dvec3 place) {
    const auto at = projector(place);
    const dvec2 off = at ? glm::abs(dvec2(pixel) - *at) : dvec2(1e9);
    return std::max(off.x, off.y) <= kSectionHandleHalf * target_scale(settings, view);
  };
  const auto handle = section_handle(document, derived, settings.selected);
  if (handle && under(handle->at)) return Pick{PickKind::section, handle->section, 0, glm::vec3(handle->at)};
  for (const AngleHandle& ring : angle_handles(document, derived, settings.selected))
    if (const dvec3 at = ring.at(ring.angle); under(at)) return Pick{ring.kind, ring.section, 0, glm::vec3(at)};
  return std::nullopt;
}

constexpr double kSameDepth = 1e-3;  // of the depth: closer positions do not hide each other
constexpr double kSamePlace = 1e-4;  // px: accuracy of pixel coordinates in float

struct CurveCandidate {
  std::size_t index = 0;  // index of the segment in the track
  double t = 0;
  double distance = 0;  // px
  double depth = 0;     // m
};

bool is_earlier(const CurveCandidate& a, const CurveCandidate& b) {
  return a.index != b.index ? a.index < b.index : a.t < b.t;
}

// The end of a segment counts only if the neighbour does not come nearer beyond it.
bool is_nearest_at_joint(const sim::DerivedTrack& derived, const PixelBeam& beam, const CurveCandidate& at) {
  const std::size_t count = derived.order.size();
  if (at.t == 0) {
    if (at.index == 0 && !derived.closed) return true;
    const std::size_t before = at.index == 0 ? count - 1 : at.index - 1;
    return slope_at_end(sighted(derived.tree.cubics[before], beam), 1) <= 0;
  }
  if (at.t == 1) {
    if (at.index + 1 == count && !derived.closed) return true;
    const std::size_t after = at.index + 1 == count ? 0 : at.index + 1;
    return slope_at_end(sighted(derived.tree.cubics[after], beam), 0) >= 0;
  }
  return true;
}

// Collects the candidates while segments are visited in any order.
class PickSearch {
 public:
  PickSearch(const sim::DerivedTrack& derived, const PixelBeam& beam, const View& view, double reach)
      : derived_(derived),
        beam_(beam),
        least_(kNowhere),
        reach_(reach),
        one_behind_another_(kOneBehindAnother * static_cast<double>(view.density)) {}

  // Positions farther away than this cannot win, px.
  double limit() const { return std::min(reach_, least_ + one_behind_another_); }

  void look_at(std::size_t index) {
    const SightedControls controls = sighted(derived_.tree.cubics[index], beam_);
    if (!may_come_near(controls, limit())) return;
    for (const SightedPlace& place : nearest_places(controls)) {
      const double distance = std::sqrt(place.square);
      if (!(distance <= limit())) continue;
      least_ = std::min(least_, distance);
      candidates_.push_back(
          {index, place.t, distance, beam_.depth(place.depth, curve::point(derived_.tree.cubics[index], place.t))});
    }
  }

  // Returns the winner by the rule in pick.h, independent of the order of the visits.
  const CurveCandidate* meant() {
    std::erase_if(candidates_, [&](const CurveCandidate& c) {
      return c.distance > limit() || !is_nearest_at_joint(derived_, beam_, c);
    });
    double front = kNowhere, nearest = kNowhere;
    for (const CurveCandidate& c : candidates_) front = std::min(front, c.depth);
    const double farthest = beam_.same_depth() > 0 ? front + beam_.same_depth() : front * (1 + kSameDepth);
    const auto in_front = [&](const CurveCandidate& c) { return c.depth <= farthest; };
    for (const CurveCandidate& c : candidates_)
      if (in_front(c)) nearest = std::min(nearest, c.distance);
    const CurveCandidate* best = nullptr;
    for (const CurveCandidate& c : candidates_)
      if (in_front(c) && c.distance <= nearest + kSamePlace && (!best || is_earlier(c, *best))) best = &c;
    return best;
  }

 private:
  const sim::DerivedTrack& derived_;
  const PixelBeam& beam_;
  double least_, reach_, one_behind_another_;  // px
  std::vector<CurveCandidate> candidates_;
};

std::optional<Pick> picked(const sim::DerivedTrack& derived, const CurveCandidate* place) {
  if (!place) return std::nullopt;
  return Pick{PickKind::curve, derived.order[place->index], place->t,
              glm::vec3(curve::point(derived.tree.cubics[place->index], place->t))};
}

}  // namespace

float mark_scale(const world::Settings& settings, const View& view) { return settings.look->ui_scale * view.density; }

Pick pick(const world::Document& document, const sim::DerivedTrack& derived, const world::Motion& motion,
          const world::Settings& settings, const View& view, glm::vec2 pixel) {
  if (!view.viewport.contains(pixel)) return {};
  if (const auto handle = pick_section_handle(document, derived, settings, view, pixel)) return *handle;
  if (const auto mark = pick_mark(document, derived, settings, view, pixel)) return *mark;
  if (const auto gizmo = gizmo_of(document, settings, view))
    if (const PickKind part = pick_gizmo(*gizmo, view, mark_scale(settings, view), pixel); part != PickKind::none)
      return {part, world::kNone, 0, gizmo->at};
  if (const auto cart = pick_cart(document, derived, motion, settings, view, pixel)) return *cart;
  if (const auto place = pick_place(derived, settings, view, pixel)) return *place;
  return pick_curve(derived, view, pixel, kCurveReach * target_scale(settings, view)).value_or(Pick{});
}

std::optional<glm::vec3> position_of(const world::Document& document, const sim::DerivedTrack& derived,
                                     const world::Motion& motion, PickKind kind, world::Entity entity, double t) {
  const world::Knot* const knot = document.entities.find<world::Knot>(entity);
  switch (kind) {
    case PickKind::knot: return knot ? std::optional(knot->position) : std::nullopt;
    case PickKind::handle_in: return knot ? std::optional(world::in_handle(*knot)) : std::nullopt;
    case PickKind::handle_out: return knot ? std::optional(world::out_handle(*knot)) : std::nullopt;
    case PickKind::cart: {
      const world::TrainMotion* const cart = motion.carts.find(entity);
      if (!cart || !derived.segments.contains(cart->segment)) return std::nullopt;
      return cart_middle(sim::pose(derived, *cart, world::FrameMethod::knots));
    }
    case PickKind::curve: {
      const sim::SegmentShape* const shape = derived.segments.find(entity);
      return shape ? std::optional(glm::vec3(curve::point(shape->key.cubic, t))) : std::nullopt;
    }
    case PickKind::section: {
      const auto handle = section_handle(document, derived, entity);
      return handle ? std::optional(glm::vec3(handle->at)) : std::nullopt;
    }
    case PickKind::turn:
    case PickKind::bank: {
      const auto handle = angle_handle(document, derived, entity, kind);
      return handle ? std::optional(glm::vec3(handle->at(handle->angle))) : std::nullopt;
    }
    default: return std::nullopt;  // nothing, and parts of the gizmo
  }
}

std::optional<Pick> pick_curve(const sim::DerivedTrack& derived, const View& view, glm::vec2 pixel, float reach) {
  const PixelBeam beam(view, pixel);
  PickSearch search(derived, beam, view, reach);
  (void)visit_near(
      derived.tree, beam, [&] { return search.limit(); }, [&](std::size_t index) { search.look_at(index); });
  return picked(derived, search.meant());
}

std::optional<Pick> pick_curve_of_all(const sim::DerivedTrack& derived, const View& view, glm::vec2 pixel,
                                      float reach) {
  const PixelBeam beam(view, pixel);
  if (!beam.has_eye()) return std::nullopt;
  PickSearch search(derived, beam, view, reach);
  for (std::size_t i = 0; i < derived.order.size(); ++i) search.look_at(i);
  return picked(derived, search.meant());
}

std::optional<Pick> pick_segment(const sim::DerivedTrack& derived, const View& view, glm::vec2 pixel,
                                 world::Entity segment) {
  const sim::SegmentShape* const shape = derived.segments.find(segment);
  const PixelBeam beam(view, pixel);
  if (shape == nullptr || !beam.has_eye()) return std::nullopt;
  const SightedPlaces places = nearest_places(sighted(shape->key.cubic, beam));
  const SightedPlace* const best =
      std::min_element(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.square < b.square; });
  if (best == places.end()) return std::nullopt;
  return Pick{PickKind::curve, segment, best->t, glm::vec3(curve::point(shape->key.cubic, best->t))};
}

}  // namespace coaster::view
