// Trains at their start, after edits, and after seek; their energy. Ticks are in ride_step.cpp.
#include "sim/ride/ride.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "sim/ride/ride_parts.h"
#include "sim/shape/frame_methods.h"

namespace coaster::sim {
namespace {

double mean_height(const world::Document& document, const Derived& derived, world::Entity entity,
                   const world::CartMotion& cart) {
  const std::vector<TrackPlace> places = places_of(document, derived, entity, cart);
  return TrainContext{derived, places}.height(0.0);
}

void set_reference(const world::Document& document, const Derived& derived, world::Entity entity,
                   world::CartMotion& cart) {
  cart.reference_energy = energy(document, derived, entity, cart);
  cart.work = 0;
  cart.peak_kinetic = 0.5 * cart.speed * cart.speed;
}

// The index of each segment in the order of travel. For many trains it is a table.
class Order {
 public:
  Order(const Derived& derived, std::size_t trains) : derived_(derived) {
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
  const Derived& derived_;
  std::vector<std::size_t> table_;  // by entity index
};

world::CartMotion begin(const world::Document& document, const Derived& derived, const Order& order,
                        world::Entity entity, const world::Cart& design) {
  world::CartMotion motion;
  const auto index = order.of(design.segment);
  COASTER_CHECK(index, "a train starts on a segment of the track");
  settle_on(derived, {*index, design.fraction * derived.shape(design.segment).arc.length()}, motion);
  motion.speed = document.start_speed;
  set_reference(document, derived, entity, motion);
  return motion;
}

// Updates a moving train after an edit: the same segment and fraction, else the same distance along the track.
void follow_edit(const world::Document& document, const Derived& derived, const Order& order, world::Entity entity,
                 world::CartMotion& cart) {
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

TrackPlace front_place(const Derived& derived, const world::CartMotion& cart) {
  const std::size_t index = index_of_segment(derived, cart.segment, cart.track_distance);
  COASTER_CHECK(index < derived.order.size(), "a train is on a segment of the track");
  return {index, cart.s};
}

void halt(world::CartMotion& cart) {
  cart.work -= 0.5 * cart.speed * cart.speed;
  cart.speed = 0;
}

void settle_on(const Derived& derived, TrackPlace front, world::CartMotion& cart) {
  const SegmentShape& shape = derived.shape_at(front.index);
  cart.segment = derived.order[front.index];
  cart.segment_length = shape.arc.length();
  cart.s = std::clamp(front.s, 0.0, cart.segment_length);
  cart.track_distance = derived.starts[front.index] + cart.s;
}

void reset(const world::Document& document, const Derived& derived, world::Motion& motion) {
  motion.carts.keep_those_of(world::Pool<world::Cart>{});  // empties it and keeps its memory
  motion = {.carts = std::move(motion.carts)};
  const auto& pool = document.entities.pool<world::Cart>();
  const Order order(derived, pool.size());
  for (std::size_t i = 0; i < pool.size(); ++i)
    motion.carts.put(pool.entities()[i], begin(document, derived, order, pool.entities()[i], pool.items()[i]));
}

void reconcile(const world::Document& document, const Derived& derived, world::Motion& motion) {
  const auto& designed = document.entities.pool<world::Cart>();
  motion.carts.keep_those_of(designed);
  const Order order(derived, designed.size());
  for (std::size_t i = 0; i < designed.size(); ++i) {
    const world::Entity e = designed.entities()[i];
    world::CartMotion* const cart = motion.carts.find(e);
    if (!cart) motion.carts.put(e, begin(document, derived, order, e, designed.items()[i]));
    else if (motion.state == world::RideState::stopped)
      *cart =
          begin(document, derived, order, e, designed.items()[i]);  // before the ride begins, trains follow the design
    else follow_edit(document, derived, order, e, *cart);
  }
  if (motion.carts.size() == 0) motion.state = world::RideState::stopped, motion.failure = {};
}

void step(const world::Document& document, const Derived& derived, world::IntegratorId integrator, int ticks,
          GhostMemo& memo, world::Motion& motion) {
  if (motion.state != world::RideState::running || derived.order.empty()) return;
  const Integrator& row = base::row_of(integrator);
  const std::vector<EquipmentSpan> equipment = equipment_spans(document, derived);
  const RideInput input{document, derived, equipment};
  if (row.kind == IntegratorKind::timetable && step_by_timetable(input, ticks, memo, motion)) return;
  for (world::CartMotion& cart : motion.carts.items()) cart.timetable = {};
  if (row.kind != IntegratorKind::vertices)
    for (world::CartMotion& cart : motion.carts.items()) cart.carry = 0;
  const bool stepped = row.kind != IntegratorKind::timetable;
  step_trains(input, stepped ? row : base::row_of(world::IntegratorId{}), ticks, motion);
}

void seek(const world::Document& document, const Derived& derived, world::Entity entity, double distance,
          world::Motion& motion) {
  world::CartMotion& cart = motion.carts.get(entity);
  const double sign = cart.speed < 0 ? -1.0 : 1.0, total = cart.reference_energy + cart.work;
  settle_on(derived, place_at(derived, distance), cart);
  const double kinetic = total - world::kGravity * (mean_height(document, derived, entity, cart) - document.datum);
  cart.speed = kinetic > 0 ? sign * std::sqrt(2.0 * kinetic) : 0.0;
  cart.timetable = {};
  cart.furthest = cart.travelled;
  set_reference(document, derived, entity, cart);
}

double energy(const world::Document& document, const Derived& derived, world::Entity entity,
              const world::CartMotion& cart) {
  return 0.5 * cart.speed * cart.speed +
         world::kGravity * (mean_height(document, derived, entity, cart) - document.datum);
}

double energy_drift(const world::Document& document, const Derived& derived, world::Entity entity,
                    const world::CartMotion& cart) {
  if (!(cart.peak_kinetic > 0)) return 0.0;
  return std::abs(energy(document, derived, entity, cart) - cart.work - cart.reference_energy) / cart.peak_kinetic;
}

}  // namespace coaster::sim
