#include "sim/ride/shown_cars.h"

#include <algorithm>

#include "sim/ride/ride_parts.h"

namespace coaster::sim {
namespace {

// Returns a parameter near arc.parameter(s), linear between the knots of its table: at most max |B''| / 8192 m away.
double near_parameter(const curve::ArcLengthMap& arc, double s) {
  constexpr int kKnots = 32;
  const double length = arc.length();
  if (!(s > 0) || !(length > 0)) return 0;
  if (s >= length) return 1;
  const auto at = [&](int knot) { return arc.distance(static_cast<double>(knot) / kKnots); };
  int knot = std::clamp(static_cast<int>(s / length * kKnots), 0, kKnots - 1);
  double from = at(knot), to = at(knot + 1);
  for (; from > s; to = from, from = at(--knot)) {
  }
  for (; to <= s; from = to, to = at(++knot + 1)) {
  }
  return (knot + (s - from) / (to - from)) / kKnots;
}

// One pass of de Casteljau's scheme gives place and direction.
void approximate(const SegmentShape& shape, double s, Pose& pose) {
  using glm::dvec3;
  const curve::Cubic& c = shape.key.cubic;
  const double t = near_parameter(shape.arc, s), beyond = s - std::clamp(s, 0.0, shape.arc.length());
  const dvec3 p0(c.p0), p1(c.p1), p2(c.p2), p3(c.p3);
  const dvec3 a = p0 + t * (p1 - p0), b = p1 + t * (p2 - p1), d = p2 + t * (p3 - p2);
  const dvec3 from = a + t * (b - a), along = b + t * (d - b) - from;
  const double length = glm::length(along);
  pose.frame.forward = length > 0 ? along / length : curve::unit_tangent(c, t);
  const dvec3 up = curve::across(shape.ups[static_cast<std::size_t>(t * kFrameIntervals + 0.5)], pose.frame.forward);
  const double high = glm::length(up);
  pose.frame.up = high > 0.5 ? up / high : curve::perpendicular(pose.frame.forward, up);
  pose.position = from + t * along + shape.key.rails * pose.frame.up + beyond * pose.frame.forward;
}

void take(const Pose& here, Pose& pose) {
  pose.position = here.position, pose.frame = here.frame, pose.defined = here.defined;
}

// Makes the poses of the cars nearest to the eye exact.
void refine_nearest(const Derived& derived, const std::vector<TrackPlace>& places, glm::dvec3 eye, std::size_t exact,
                    std::vector<Pose>& poses) {
  std::vector<double> away(poses.size());  // m^2
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const glm::dvec3 way = poses[i].position - eye;
    away[i] = glm::dot(way, way);
  }
  std::vector<double> sorted = away;
  const auto limit = sorted.begin() + static_cast<std::ptrdiff_t>(exact);
  std::nth_element(sorted.begin(), limit, sorted.end());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (away[i] > *limit) continue;
    take(pose(derived, places[i], world::FrameMethod::knots), poses[i]);
  }
}

}  // namespace

std::vector<Pose> shown_cars(const world::Document& document, const Derived& derived, const world::Motion& motion,
                             world::FrameMethod method, glm::dvec3 eye, std::size_t exact) {
  std::vector<Pose> poses;
  if (derived.order.empty()) return poses;
  std::vector<TrackPlace> places, train;
  places.reserve(motion.carts.size()), poses.reserve(motion.carts.size());
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    const world::Cart& design = document.entities.get<world::Cart>(motion.carts.entities()[i]);
    place_cars(derived, front_place(derived, motion.carts.items()[i]), cars_on(derived, design), design.spacing, train);
    for (std::size_t car = 0; car < train.size(); ++car) {
      places.push_back(train[car]);
      Pose& made = poses.emplace_back();
      made.length = design.body(), made.leads = car == 0;
    }
  }
  const bool all_exact = poses.size() <= exact || method != world::FrameMethod::knots;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (all_exact) take(pose(derived, places[i], method), poses[i]);
    else approximate(derived.shape_at(places[i].index), places[i].s, poses[i]);
  if (!all_exact) refine_nearest(derived, places, eye, exact, poses);
  return poses;
}

}  // namespace coaster::sim
