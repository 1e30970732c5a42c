// The ticks of the ride: trains advanced in parts between joints, equipment and losses, and the ends of a ride.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/ride/ride_parts.h"

namespace coaster::sim {
namespace {

// A tick that crosses more joints per car than this (segments of zero length) is cut short: the train waits for the
// next tick.
constexpr int kMaxJointsPerTick = 64;
// Least distance of a car beyond an open end, so that it does not cross its joint again.
constexpr double kOverhang = 1e-9;  // m

struct TickContext {
  const RideInput& input;
  const Integrator& row;
  world::Resistance resistance;  // of the current train
};

// Returns the time in (0, dt] at which `value` (of the state after that time) first reaches zero from below:
// alternating bisection and secants, on the far side, to 1e-15 s.
template <class Value>
double time_of(const TickContext& tick, const TrainContext& context, const TrainState& state, double dt,
               const Value& value) {
  double low = 0, high = dt, f_low = value(state), f_high = value(tick.row.advance(context, state, dt));
  for (int i = 0; i < 80 && high - low > 1e-15; ++i) {
    double t = 0.5 * (low + high);
    if (i % 3 != 2 && f_high > f_low)
      t = std::clamp(high - f_high * (high - low) / (f_high - f_low), low + 1e-3 * (high - low),
                     high - 1e-3 * (high - low));
    const double f = value(tick.row.advance(context, state, t));
    (f >= 0 ? high : low) = t;
    (f >= 0 ? f_high : f_low) = f;
  }
  return high;
}

// Moves the cars by x; those that reach the joint at `reached` cross it. Returns false if the first car reaches an open
// end.
bool move_cars(const Derived& derived, double x, bool forward, bool at_joint, std::vector<TrackPlace>& places,
               std::int64_t& laps) {
  constexpr double kReached = 1e-12;  // m
  const std::size_t count = derived.order.size();
  bool on_track = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    TrackPlace& car = places[i];
    const double length = derived.shape_at(car.index).arc.length();
    const bool crosses = at_joint && (forward ? car.s <= length && length - car.s <= x + kReached
                                              : car.s >= 0 && car.s <= -x + kReached);
    if (!crosses) {
      car.s += x;
      continue;
    }
    const bool at_end = forward ? car.index + 1 == count : car.index == 0;
    if (at_end && !derived.closed) {
      car.s = forward ? length + (i == 0 ? 0.0 : kOverhang) : (i == 0 ? 0.0 : -kOverhang);
      on_track = on_track && i != 0;
      continue;
    }
    if (at_end && i == 0) laps += forward ? 1 : -1;
    car.index = forward ? (car.index + 1) % count : (car.index + count - 1) % count;
    car.s = forward ? 0.0 : derived.shape_at(car.index).arc.length();
  }
  return on_track;
}

double direction_of(const TrainContext& context, double speed) {
  return sim::direction_of(speed, context.resistance, [&] { return context.gravity(0.0) + context.drive; });
}

bool stays_at_rest(const TrainContext& context, double speed) {
  return speed == 0 && context.resistance.rolling > 0 && direction_of(context, 0.0) == 0.0;
}

// Advances a train by `dt` in one step across joints. Returns false and changes nothing if that is not possible: at
// open ends, and where losses stop it.
bool advance_across(const TickContext& tick, double dt, double drive, std::vector<TrackPlace>& places,
                    world::CartMotion& cart) {
  const Derived& derived = tick.input.derived;
  const world::Document& document = tick.input.document;
  TrainContext context{derived, places, document.datum, cart.reference_energy, tick.resistance, 0.0, drive, true};
  context.direction = direction_of(context, cart.speed);
  const bool losses = !(tick.resistance == world::Resistance{});
  if (losses && stays_at_rest(context, cart.speed)) return false;
  const TrainState next = tick.row.advance(context, {0.0, cart.speed, cart.work}, dt);
  if (losses && next.speed * context.direction < 0) return false;
  const double from = derived.starts[places.front().index] + places.front().s, to = from + next.x;
  if (!derived.closed && !(to > 0 && to < derived.length)) return false;
  const TrackPlace before = places.front();
  for (TrackPlace& car : places) car = behind(derived, car, -next.x);
  // The train moved on and is nevertheless nearer to the track's start, so it completed a lap, unless the track is so
  // short that one step is several laps.
  const auto order = [](const TrackPlace& a, const TrackPlace& b) {
    return a.index != b.index ? a.index < b.index : a.s < b.s;
  };
  if (next.x > 0 && order(places.front(), before)) ++cart.laps;
  if (next.x < 0 && order(before, places.front())) --cart.laps;
  cart.travelled += next.x, cart.speed = next.speed, cart.work = next.work;
  return true;
}

// Advances a train by `dt` in parts that end at joints and where losses stop it. Returns false at an open end.
bool advance_stepped(const TickContext& tick, double dt, double drive, std::vector<TrackPlace>& places,
                     world::CartMotion& cart) {
  const Derived& derived = tick.input.derived;
  const world::Document& document = tick.input.document;
  const bool losses = !(tick.resistance == world::Resistance{});
  if (!tick.row.splits && advance_across(tick, dt, drive, places, cart)) return true;
  const int most_parts = kMaxJointsPerTick * static_cast<int>(places.size());
  for (int part = 0; dt > 0 && part < most_parts; ++part) {
    TrainContext context{derived, places, document.datum, cart.reference_energy, tick.resistance, 0.0, drive};
    context.direction = direction_of(context, cart.speed);
    if (losses && stays_at_rest(context, cart.speed)) return true;
    const TrainState state{0.0, cart.speed, cart.work};
    double used = dt;
    TrainState next = tick.row.advance(context, state, used);
    const double ahead = joint_ahead(context), back = joint_behind(context);
    const bool forward = next.x > ahead, backward = next.x < back;
    if (forward || backward) {
      used = time_of(tick, context, state, used,
                     [&](const TrainState& at) { return forward ? at.x - ahead : back - at.x; });
      next = tick.row.advance(context, state, used);
    }
    bool at_joint = forward || backward;
    if (losses && context.direction != 0 && next.speed * context.direction < 0) {
      used = time_of(tick, context, state, used, [&](const TrainState& at) { return -at.speed * context.direction; });
      next = tick.row.advance(context, state, used);
      next.speed = 0;
      at_joint = false;
    }
    const double x = at_joint ? (forward ? ahead : back) : next.x;
    const bool on_track = move_cars(derived, x, forward, at_joint, places, cart.laps);
    cart.travelled += x, cart.speed = next.speed, cart.work = next.work;
    if (!on_track) return false;
    dt -= used;
  }
  return true;
}

// Returns the effect of equipment in this tick; `held` is true if it keeps the train from moving.
Drive drive_for(const TickContext& tick, std::size_t train, std::span<const TrainPlace> trains,
                std::span<const TrackPlace> places, world::CartMotion& cart) {
  const RideInput& input = tick.input;
  if (input.equipment.empty()) return {};
  const Rails rails{input.derived.length, input.derived.closed};
  const double free = acceleration_of({input.derived, places, 0, 0, tick.resistance}, cart.speed);
  ControlState control{cart.dwell, cart.braking};
  const bool way_free = section_free(input.equipment, rails, trains[train], trains.first(train)) &&
                        section_free(input.equipment, rails, trains[train], trains.subspan(train + 1));
  const Drive drive =
      drive_of(input.equipment, rails, trains[train], cart.speed, free, way_free, world::kTick, control);
  cart.dwell = control.dwell, cart.braking = control.braking;
  return drive;
}

// Returns how a train's tick ended the ride, if it did.
std::optional<world::FailureKind> failure_of(const TickContext& tick, bool held, bool on_track, double arrival,
                                             world::CartMotion& cart) {
  cart.furthest = std::max(cart.furthest, cart.travelled);
  // A train that never moved was pulled out at its start.
  if (!on_track)
    return std::abs(arrival) > kStillSpeed || cart.travelled == 0 ? std::optional(world::FailureKind::off_end)
                                                                  : std::nullopt;
  if (rolls_back(tick.input.document, cart.speed, cart.travelled, cart.furthest)) return world::FailureKind::rollback;
  const bool still = std::abs(cart.speed) < kStillSpeed && !held;
  cart.still = still ? cart.still + 1 : 0;
  if (cart.still >= kStillTicks) return world::FailureKind::stall;
  return std::nullopt;
}

bool at_open_end(const Derived& derived, const world::CartMotion& cart) {
  const bool first = cart.segment == derived.order.front(), last = cart.segment == derived.order.back();
  return !derived.closed && cart.speed == 0 && ((first && cart.s <= 0) || (last && cart.s >= cart.segment_length));
}

struct Train {
  world::Entity entity;
  world::CartMotion* motion;
  int cars;
  double spacing, length;
  world::Resistance resistance;
  std::vector<TrackPlace> places;
};

std::vector<Train> trains_of(const RideInput& input, world::Motion& motion) {
  std::vector<Train> trains;
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    const world::Entity entity = motion.carts.entities()[i];
    const world::Cart& design = input.document.entities.get<world::Cart>(entity);
    Train train{entity,
                &motion.carts.items()[i],
                cars_on(input.derived, design),
                design.spacing,
                design.body(),
                resistance_of(input.document, design.mass),
                {}};
    place_cars(input.derived, front_place(input.derived, *train.motion), train.cars, train.spacing, train.places);
    trains.push_back(std::move(train));
  }
  return trains;
}

// Advances one train by one tick. Returns false if it is at an open end.
bool advance_train(const TickContext& tick, const Drive& drive, Train& train) {
  world::CartMotion& cart = *train.motion;
  if (drive.held) {
    halt(cart);
    return true;
  }
  if (at_open_end(tick.input.derived, cart) && drive.acceleration == 0) {
    const TrainContext context{tick.input.derived, train.places, 0, 0, {}, 0, 0};
    const double pull = context.gravity(0.0);
    // A train at rest at its start without a pull has not reached the end of a ride: it stalls.
    const bool stands = cart.travelled == 0 && std::abs(pull) <= world::kGravity * train.resistance.rolling;
    if (stands) return true;
    if (cart.s <= 0 ? pull <= 0 : pull >= 0) return false;
  }
  bool on_track = true;
  if (tick.row.kind == IntegratorKind::vertices) {
    on_track = advance_by_vertices(tick.input, {train.cars, train.spacing, train.resistance, drive.acceleration},
                                   world::kTick, cart);
    place_cars(tick.input.derived, front_place(tick.input.derived, cart), train.cars, train.spacing, train.places);
  } else {
    for (int part = 0; part < tick.row.substeps && on_track; ++part)
      on_track = advance_stepped(tick, world::kTick / tick.row.substeps, drive.acceleration, train.places, cart);
    settle_on(tick.input.derived, train.places.front(), cart);
  }
  return on_track;
}

}  // namespace

void step_trains(const RideInput& input, const Integrator& row, int ticks, world::Motion& motion) {
  std::vector<Train> trains = trains_of(input, motion);
  const Rails rails{input.derived.length, input.derived.closed};
  std::vector<TrainPlace> places(trains.size());
  std::vector<char> left(trains.size());  // 1: at an open end
  const auto fail = [&](world::FailureKind kind, const Train& train, double speed) {
    motion.failure = {kind, train.entity, train.motion->track_distance, speed};
    if (kind != world::FailureKind::off_end) motion.state = world::RideState::failed;
  };
  for (int n = 0; n < ticks && motion.state == world::RideState::running; ++n) {
    for (std::size_t i = 0; i < trains.size(); ++i)
      places[i] = {trains[i].motion->track_distance, trains[i].cars, trains[i].spacing, trains[i].length};
    bool any = false;
    for (std::size_t i = 0; i < trains.size() && motion.state == world::RideState::running; ++i) {
      world::CartMotion& cart = *trains[i].motion;
      const TickContext tick{input, row, trains[i].resistance};
      const Drive drive = drive_for(tick, i, places, trains[i].places, cart);
      cart.drive = drive.acceleration;
      const bool on_track = advance_train(tick, drive, trains[i]);
      const double arrival = cart.speed;
      if (!on_track) halt(cart);  // at the buffer stop
      cart.peak_kinetic = std::max(cart.peak_kinetic, 0.5 * cart.speed * cart.speed);
      any |= on_track;
      if (const auto failure = failure_of(tick, drive.held, on_track, arrival, cart))
        fail(*failure, trains[i], arrival);
      places[i].front = cart.track_distance;
    }
    if (motion.state == world::RideState::running && trains.size() > 1) {
      for (std::size_t i = 0; i < trains.size(); ++i) left[i] = at_open_end(input.derived, *trains[i].motion) ? 1 : 0;
      if (const auto i = first_collision(rails, places, left))
        fail(world::FailureKind::collision, trains[*i], trains[*i].motion->speed);
    }
    if (!any && motion.state == world::RideState::running) motion.state = world::RideState::ended;
  }
}

}  // namespace coaster::sim
