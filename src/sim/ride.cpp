#include "sim/ride.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace coaster::sim {
namespace {

// A tick that meets more joints than this (segments of no length) is cut short: the cart waits for the next tick.
constexpr int kMaxJointsPerTick = 64;

std::size_t index_of_segment(const Derived& derived, world::Entity segment) {
  return static_cast<std::size_t>(std::find(derived.order.begin(), derived.order.end(), segment) - derived.order.begin());
}

double height_at(const Derived& derived, const world::CartMotion& cart) {
  return rail_point(derived.shape(cart.segment), cart.s).height;
}

void set_reference(const world::Document& document, const Derived& derived, world::CartMotion& cart) {
  cart.reference_energy = energy(document, derived, cart);
  cart.peak_kinetic = 0.5 * cart.speed * cart.speed;
}

void settle_on(const Derived& derived, std::size_t index, double s, world::CartMotion& cart) {
  const SegmentShape& shape = derived.shape(derived.order[index]);
  cart.segment = derived.order[index];
  cart.segment_length = shape.arc.length();
  cart.s = std::clamp(s, 0.0, cart.segment_length);
  cart.track_distance = derived.starts[index] + cart.s;
}

// The part of `dt` after which the cart is at the boundary it crosses: bisection on the step itself.
double time_to_boundary(const Integrator& row, const RailContext& context, RailState state, double dt, bool forward, double length) {
  double low = 0, high = dt;
  for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
    const double middle = 0.5 * (low + high);
    const double s = row.advance(context, state, middle).s;
    ((forward ? s >= length : s <= 0.0) ? high : low) = middle;
  }
  return high;
}

struct Step {
  const world::Document& document;
  const Derived& derived;
  const Integrator& row;
};

// Goes over the joint ahead (or behind); false at an open end.
bool cross_joint(const Step& step, bool forward, std::size_t& index, RailState& state, world::CartMotion& cart) {
  const std::size_t count = step.derived.order.size();
  const bool at_end = forward ? index + 1 == count : index == 0;
  if (at_end && !step.derived.closed) return false;
  if (at_end) cart.laps += forward ? 1 : -1;
  index = forward ? (index + 1) % count : (index + count - 1) % count;
  state.s = forward ? 0.0 : step.derived.shape(step.derived.order[index]).arc.length();
  return true;
}

// One tick of one cart, split at joints. Returns false when it stands at an open end.
bool advance_cart(const Step& step, std::size_t index, double dt, world::CartMotion& cart) {
  RailState state{cart.s, cart.speed};
  bool on_track = true;
  for (int joints = 0; dt > 0 && joints < kMaxJointsPerTick; ++joints) {
    const SegmentShape& shape = step.derived.shape(step.derived.order[index]);
    const double length = shape.arc.length();
    const RailContext context{shape, step.document.datum, cart.reference_energy};
    RailState next = step.row.advance(context, state, dt);
    const bool forward = next.s > length, backward = next.s < 0.0;
    if (!forward && !backward) {
      cart.travelled += next.s - state.s;
      state = next;
      break;
    }
    const double part = time_to_boundary(step.row, context, state, dt, forward, length);
    next = step.row.advance(context, state, part);
    cart.travelled += (forward ? length : 0.0) - state.s;
    state = {forward ? length : 0.0, next.speed};
    dt -= part;
    if (!cross_joint(step, forward, index, state, cart)) {
      state.speed = 0;
      on_track = false;
      break;
    }
  }
  cart.speed = state.speed;
  settle_on(step.derived, index, state.s, cart);
  // One that lies still at an open end has come to it, be it in this tick or before.
  const bool at_start = index == 0 && cart.s <= 0.0, at_end = index + 1 == step.derived.order.size() && cart.s >= cart.segment_length;
  if (!step.derived.closed && cart.speed == 0.0 && (at_start || at_end)) on_track = false;
  cart.peak_kinetic = std::max(cart.peak_kinetic, 0.5 * cart.speed * cart.speed);
  return on_track;
}

world::CartMotion start_of(const world::Document& document, const Derived& derived, const world::Cart& cart) {
  world::CartMotion motion;
  const std::size_t index = index_of_segment(derived, cart.segment);
  COASTER_CHECK(index < derived.order.size(), "a cart starts on a segment of the track");
  settle_on(derived, index, cart.fraction * derived.shape(cart.segment).arc.length(), motion);
  motion.speed = document.start_speed;
  set_reference(document, derived, motion);
  return motion;
}

}  // namespace

void reset(const world::Document& document, const Derived& derived, world::Motion& motion) {
  motion = {};
  const auto& pool = document.entities.pool<world::Cart>();
  for (std::size_t i = 0; i < pool.size(); ++i)
    motion.carts.put(pool.entities()[i], start_of(document, derived, pool.items()[i]));
}

void reconcile(const world::Document& document, const Derived& derived, world::Motion& motion) {
  const auto& designed = document.entities.pool<world::Cart>();
  std::vector<world::Entity> gone;
  for (const world::Entity e : motion.carts.entities())
    if (!designed.contains(e)) gone.push_back(e);
  for (const world::Entity e : gone) motion.carts.erase(e);
  for (std::size_t i = 0; i < designed.size(); ++i) {
    const world::Entity e = designed.entities()[i];
    world::CartMotion* cart = motion.carts.find(e);
    if (!cart) {
      motion.carts.put(e, start_of(document, derived, designed.items()[i]));
      continue;
    }
    if (motion.state == world::RideState::stopped) {
      *cart = start_of(document, derived, designed.items()[i]);  // a ride that has not begun follows the design
      continue;
    }
    std::size_t index = index_of_segment(derived, cart->segment);
    double s = cart->s;
    if (index < derived.order.size()) {
      const double length = derived.shape(cart->segment).arc.length();
      if (length != cart->segment_length && cart->segment_length > 0) s *= length / cart->segment_length;
    } else {
      const TrackPlace place = place_at(derived, std::min(cart->track_distance, derived.length));
      index = place.index;
      s = place.s;
    }
    settle_on(derived, index, s, *cart);
    const double now = energy(document, derived, *cart);
    const double tolerance = 1e-4 * std::max(cart->peak_kinetic, 1e-6);
    if (std::abs(now - cart->reference_energy) > tolerance) set_reference(document, derived, *cart);
  }
  if (motion.carts.size() == 0) motion.state = world::RideState::stopped;
}

void step(const world::Document& document, const Derived& derived, int integrator, int ticks, world::Motion& motion) {
  if (motion.state != world::RideState::running || derived.order.empty()) return;
  const auto rows = integrators();
  COASTER_CHECK(integrator >= 0 && static_cast<std::size_t>(integrator) < rows.size(), "the integrator is a row of the table");
  const Step context{document, derived, rows[static_cast<std::size_t>(integrator)]};
  std::vector<std::size_t> at;
  for (const world::CartMotion& cart : motion.carts.items()) at.push_back(index_of_segment(derived, cart.segment));
  for (int tick = 0; tick < ticks && motion.state == world::RideState::running; ++tick) {
    bool any = false;
    for (std::size_t i = 0; i < motion.carts.items().size(); ++i) {
      world::CartMotion& cart = motion.carts.items()[i];
      bool on_track = true;
      for (int part = 0; part < context.row.substeps && on_track; ++part) {
        on_track = advance_cart(context, at[i], world::kTick / context.row.substeps, cart);
        if (derived.order[at[i]] != cart.segment) at[i] = index_of_segment(derived, cart.segment);
      }
      any |= on_track;
    }
    if (!any) motion.state = world::RideState::ended;
  }
}

void seek(const world::Document& document, const Derived& derived, world::Entity entity, double distance, world::Motion& motion) {
  world::CartMotion& cart = motion.carts.get(entity);
  const TrackPlace place = place_at(derived, distance);
  const double sign = cart.speed < 0 ? -1.0 : 1.0;
  settle_on(derived, place.index, place.s, cart);
  const double kinetic = cart.reference_energy - world::kGravity * (height_at(derived, cart) - document.datum);
  cart.speed = kinetic > 0 ? sign * std::sqrt(2.0 * kinetic) : 0.0;
  set_reference(document, derived, cart);
}

double energy(const world::Document& document, const Derived& derived, const world::CartMotion& cart) {
  return 0.5 * cart.speed * cart.speed + world::kGravity * (height_at(derived, cart) - document.datum);
}

double energy_drift(const world::Document& document, const Derived& derived, const world::CartMotion& cart) {
  if (!(cart.peak_kinetic > 0)) return 0.0;
  return std::abs(energy(document, derived, cart) - cart.reference_energy) / cart.peak_kinetic;
}

}  // namespace coaster::sim
