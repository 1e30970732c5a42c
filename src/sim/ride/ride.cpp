// Trains at their start, after edits and after seek, their energy, and the poses of cars. Ticks are in ride_step.cpp.
#include "sim/ride/ride.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "sim/ride/ride_detail.h"
#include "sim/shape/frame_methods.h"
#include "sim/shape/rails.h"

namespace coaster::sim {
namespace {

// Returns the positions of a moving train's cars, first to last.
std::vector<TrackPlace> places_of(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                                  const world::TrainMotion& motion) {
  const world::Train* const design = document.entities.find<world::Train>(entity);
  std::vector<TrackPlace> places;
  place_cars(derived, front_place(derived, motion), design ? cars_on(derived, *design) : 1,
             design ? design->spacing : 1.0, places);
  return places;
}

// Returns a train's acceleration along the rails, m/s^2, with losses and the last tick's equipment.
double along_rails(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                   const world::TrainMotion& cart, std::span<const TrackPlace> places) {
  const world::Train* const design = document.entities.find<world::Train>(entity);
  const world::Losses resistance = resistance_of(document, design ? design->mass : world::kCarMass);
  return acceleration_of({derived, places, 0, 0, resistance, 0, cart.drive}, cart.speed);
}

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
void refine_nearest(const DerivedTrack& derived, const std::vector<TrackPlace>& places, glm::dvec3 eye,
                    std::size_t exact, std::vector<Pose>& poses) {
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

double mean_height(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                   const world::TrainMotion& cart) {
  const std::vector<TrackPlace> places = places_of(document, derived, entity, cart);
  return TrainContext{derived, places}.height(0.0);
}

void set_reference(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                   world::TrainMotion& cart) {
  cart.reference_energy = energy(document, derived, entity, cart);
  cart.work = 0;
  cart.peak_kinetic = 0.5 * cart.speed * cart.speed;
}

// The index of each segment in the order of travel. For many trains it is a table.
class SegmentIndices {
 public:
  SegmentIndices(const DerivedTrack& derived, std::size_t trains) : derived_(derived) {
    constexpr std::size_t kFew = 4;
    if (trains <= kFew) return;
    for (std::size_t i = 0; i < derived.order.size(); ++i) {
      const std::size_t at = derived.order[i].index;
      if (at >= table_.size()) table_.resize(at + 1, derived.order.size());
      table_[at] = i;
    }
  }
  std::optional<std::size_t> of(world::Entity segment) const {
    if (table_.empty()) return world::index_of(derived_.order, segment);
    const std::size_t i = segment.index < table_.size() ? table_[segment.index] : derived_.order.size();
    return i < derived_.order.size() && derived_.order[i] == segment ? std::optional(i) : std::nullopt;
  }

 private:
  const DerivedTrack& derived_;
  std::vector<std::size_t> table_;  // by entity index
};

world::TrainMotion begin(const world::Document& document, const DerivedTrack& derived, const SegmentIndices& order,
                         world::Entity entity, const world::Train& design) {
  world::TrainMotion motion;
  const auto index = order.of(design.segment);
  COASTER_CHECK(index, "a train starts on a segment of the track");
  settle_on(derived, {*index, design.fraction * derived.shape(design.segment).arc.length()}, motion);
  motion.speed = document.start_speed;
  set_reference(document, derived, entity, motion);
  return motion;
}

// Updates a moving train after an edit: the same segment and fraction, else the same distance along the track.
void follow_edit(const world::Document& document, const DerivedTrack& derived, const SegmentIndices& order,
                 world::Entity entity, world::TrainMotion& cart) {
  if (const auto index = order.of(cart.segment)) {
    const double length = derived.shape(cart.segment).arc.length();
    const bool scales = length != cart.segment_length && cart.segment_length > 0;
    settle_on(derived, {*index, scales ? cart.s * (length / cart.segment_length) : cart.s}, cart);
  } else {
    settle_on(derived, place_at(derived, std::min(cart.track_distance, derived.length)), cart);
  }
  const double drift = energy(document, derived, entity, cart) - cart.work - cart.reference_energy;
  if (std::abs(drift) <= 1e-4 * std::max(cart.peak_kinetic, 1e-6)) return;
  set_reference(document, derived, entity, cart);
  cart.timetable = {};
}

}  // namespace

double acceleration_of(TrainContext context, double speed) {
  context.direction = speed > 0 ? 1.0 : speed < 0 ? -1.0 : 0.0;
  return context.gravity(0.0) + context.others(speed);
}

Pose pose(const DerivedTrack& derived, TrackPlace place, world::FrameMethod method) {
  const SegmentShape& shape = derived.shape_at(place.index);
  const double length = shape.arc.length(), s = std::fmin(std::fmax(place.s, 0.0), length);
  const TrackFrame at = track_frame(derived, method, place.index, s);
  // A car beyond an open end is on the straight continuation.
  return {rails_at(shape, s) + (place.s - s) * at.frame.forward, at.frame, at.defined};
}

Pose pose(const DerivedTrack& derived, const world::TrainMotion& cart, world::FrameMethod method) {
  return pose(derived, front_place(derived, cart), method);
}

std::vector<Pose> car_poses(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                            const world::TrainMotion& motion, world::FrameMethod method) {
  std::vector<Pose> poses;
  const world::Train* const design = document.entities.find<world::Train>(entity);
  for (const TrackPlace& place : places_of(document, derived, entity, motion)) {
    poses.push_back(pose(derived, place, method));
    poses.back().leads = poses.size() == 1;
    if (design) poses.back().length = design->body();
  }
  return poses;
}

FeltAcceleration felt(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                      const world::TrainMotion& cart, int car) {
  const std::vector<TrackPlace> places = places_of(document, derived, entity, cart);
  COASTER_CHECK(car >= 0 && static_cast<std::size_t>(car) < places.size(), "the train has this car");
  const TrackPlace place = places[static_cast<std::size_t>(car)];
  const SegmentShape& shape = derived.shape_at(place.index);
  const double s = std::clamp(place.s, 0.0, shape.arc.length());
  const double t = shape.arc.parameter(s);
  const FeltEntry here = felt_entry(shape, s, t, frame_at(shape, s, t), world::riders_height(document));
  const double along = along_rails(document, derived, entity, cart, places);
  const glm::vec3 g = here.felt(static_cast<float>(along / world::kGravity),
                                static_cast<float>(cart.speed * cart.speed / world::kGravity));
  return {g.x, g.y, g.z};
}

CarRoll rolling(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                const world::TrainMotion& cart, int car) {
  const std::vector<TrackPlace> places = places_of(document, derived, entity, cart);
  COASTER_CHECK(car >= 0 && static_cast<std::size_t>(car) < places.size(), "the train has this car");
  const TrackPlace place = places[static_cast<std::size_t>(car)];
  const SegmentShape& shape = derived.shape_at(place.index);
  if (!(place.s >= 0 && place.s <= shape.arc.length())) return {};  // on the straight continuation of an open end
  const double spin = shape.roll.spin(place.s), v = cart.speed;
  return {spin * v, shape.roll.slope(place.s) * v * v + spin * along_rails(document, derived, entity, cart, places)};
}

std::vector<Pose> shown_cars(const world::Document& document, const DerivedTrack& derived, const world::Motion& motion,
                             world::FrameMethod method, glm::dvec3 eye, std::size_t exact) {
  std::vector<Pose> poses;
  if (derived.order.empty()) return poses;
  std::vector<TrackPlace> places, train;
  places.reserve(motion.carts.size()), poses.reserve(motion.carts.size());
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    const world::Train& design = document.entities.get<world::Train>(motion.carts.entities()[i]);
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

TrackPlace front_place(const DerivedTrack& derived, const world::TrainMotion& cart) {
  const std::size_t index = index_of_segment(derived, cart.segment, cart.track_distance);
  COASTER_CHECK(index < derived.order.size(), "a train is on a segment of the track");
  return {index, cart.s};
}

void halt(world::TrainMotion& cart) {
  cart.work -= 0.5 * cart.speed * cart.speed;
  cart.speed = 0;
}

void settle_on(const DerivedTrack& derived, TrackPlace front, world::TrainMotion& cart) {
  const SegmentShape& shape = derived.shape_at(front.index);
  cart.segment = derived.order[front.index];
  cart.segment_length = shape.arc.length();
  cart.s = std::clamp(front.s, 0.0, cart.segment_length);
  cart.track_distance = derived.starts[front.index] + cart.s;
}

void reset(const world::Document& document, const DerivedTrack& derived, world::Motion& motion) {
  motion.carts.keep_those_of(world::Pool<world::Train>{});  // empties it and keeps its memory
  motion = {.carts = std::move(motion.carts)};
  const auto& pool = document.entities.pool<world::Train>();
  const SegmentIndices order(derived, pool.size());
  for (std::size_t i = 0; i < pool.size(); ++i)
    motion.carts.put(pool.entities()[i], begin(document, derived, order, pool.entities()[i], pool.items()[i]));
}

void reconcile(const world::Document& document, const DerivedTrack& derived, world::Motion& motion) {
  const auto& designed = document.entities.pool<world::Train>();
  motion.carts.keep_those_of(designed);
  const SegmentIndices order(derived, designed.size());
  for (std::size_t i = 0; i < designed.size(); ++i) {
    const world::Entity e = designed.entities()[i];
    world::TrainMotion* const cart = motion.carts.find(e);
    if (!cart) motion.carts.put(e, begin(document, derived, order, e, designed.items()[i]));
    else if (motion.state == world::RideState::stopped)
      *cart =
          begin(document, derived, order, e, designed.items()[i]);  // before the ride begins, trains follow the design
    else follow_edit(document, derived, order, e, *cart);
  }
  if (motion.carts.size() == 0) motion.state = world::RideState::stopped, motion.failure = {};
}

void step(const world::Document& document, const DerivedTrack& derived, world::IntegratorId integrator, int ticks,
          RideCache& cache, world::Motion& motion) {
  if (motion.state != world::RideState::running || derived.order.empty()) return;
  const Integrator& row = base::row_of(integrator);
  const std::vector<EquipmentSpan> equipment = equipment_spans(document, derived);
  const RideInput input{document, derived, equipment};
  if (row.kind == IntegratorKind::timetable && step_by_timetable(input, ticks, cache, motion)) return;
  for (world::TrainMotion& cart : motion.carts.items()) cart.timetable = {};
  if (row.kind != IntegratorKind::vertices)
    for (world::TrainMotion& cart : motion.carts.items()) cart.carry = 0;
  const bool stepped = row.kind != IntegratorKind::timetable;
  step_trains(input, stepped ? row : base::row_of(world::IntegratorId{}), ticks, motion);
}

void seek(const world::Document& document, const DerivedTrack& derived, world::Entity entity, double distance,
          world::Motion& motion) {
  world::TrainMotion& cart = motion.carts.get(entity);
  const double sign = cart.speed < 0 ? -1.0 : 1.0, total = cart.reference_energy + cart.work;
  settle_on(derived, place_at(derived, distance), cart);
  const double kinetic = total - world::kGravity * (mean_height(document, derived, entity, cart) - document.datum);
  cart.speed = kinetic > 0 ? sign * std::sqrt(2.0 * kinetic) : 0.0;
  cart.timetable = {};
  cart.furthest = cart.travelled;
  set_reference(document, derived, entity, cart);
}

double energy(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
              const world::TrainMotion& cart) {
  return 0.5 * cart.speed * cart.speed +
         world::kGravity * (mean_height(document, derived, entity, cart) - document.datum);
}

double energy_drift(const world::Document& document, const DerivedTrack& derived, world::Entity entity,
                    const world::TrainMotion& cart) {
  if (!(cart.peak_kinetic > 0)) return 0.0;
  return std::abs(energy(document, derived, entity, cart) - cart.work - cart.reference_energy) / cart.peak_kinetic;
}

}  // namespace coaster::sim
