// The parts of a tick: a train advanced between joints, ends of equipment, and the instants where equipment switches.
#include <algorithm>
#include <cmath>

#include "sim/ride/ride_parts.h"

namespace coaster::sim {
namespace {

// A tick that crosses more joints per car than this (segments of zero length) is cut short: the train waits for the
// next tick.
constexpr int kMaxJointsPerTick = 64;
// Least distance of a car beyond an open end, so that it does not cross its joint again.
constexpr double kOverhang = 1e-9;  // m

// Advances by a row of the table, or with the acceleration that equipment sets: its work follows from the energy.
TrainState advance(const TickContext& tick, const TrainContext& context, const TrainState& state, double dt) {
  if (!tick.control.drive.net) return tick.row.advance(context, state, dt);
  const double a = context.drive, x = state.x + dt * (state.speed + 0.5 * dt * a), v = state.speed + dt * a;
  const double climb = context.height(x) - context.height(state.x);
  return {x, v, state.work + 0.5 * (v * v - state.speed * state.speed) + world::kGravity * climb};
}

double distance_of(const Derived& derived, TrackPlace place) { return derived.starts[place.index] + place.s; }

// Returns the drive from a moment within a part of a tick on. Updates `control`.
Drive drive_at(const TickContext& tick, const TrainContext& context, const Contacts& contacts, const TrainState& state,
               ControlState& control) {
  const std::function<double()> free = [&] {
    const double pull = context.gravity(state.x);
    return pull - sim::direction_of(state.speed, context.resistance, [&] { return pull; }) *
                      loss(context.resistance, state.speed);
  };
  const double step = tick.row.kind == IntegratorKind::vertices ? world::kTick : 0.0;
  const TrainMoment now{distance_of(context.derived, context.cars.front()) + state.x, state.speed, free, step};
  return drive_of(contacts, tick.train, now, tick.control.way_free, control);
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
bool advance_across(const TickContext& tick, double dt, std::vector<TrackPlace>& places, world::CartMotion& cart) {
  const Derived& derived = tick.input.derived;
  const world::Document& document = tick.input.document;
  TrainContext context{derived, places, document.datum, cart.reference_energy, tick.resistance, 0.0, 0.0, true};
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

// Returns true if a step of a tick may reach equipment.
bool near_equipment(const TickContext& tick, const Contacts& contacts, const world::CartMotion& cart) {
  constexpr double kMargin = 1;  // m
  const double reach = std::abs(cart.speed) * world::kTick + kMargin;
  const TrainContacts& next = tick.control.contacts;
  return !contacts.on.empty() || cart.travelled + reach > next.ahead() || cart.travelled - reach < next.behind();
}

}  // namespace

const Contacts& update_drive(const TickContext& tick, const TrainContext& context, const world::CartMotion& cart) {
  Control& control = tick.control;
  const Rails rails{tick.input.derived.length, tick.input.derived.closed};
  TrainPlace train = tick.train;
  train.front = distance_of(tick.input.derived, context.cars.front());
  const Contacts& contacts =
      control.contacts.update(tick.input.equipment, rails, train, cart.travelled, cart.speed < 0);
  control.drive = drive_at(tick, context, contacts, {0.0, cart.speed, cart.work}, control.state);
  return contacts;
}

bool advance_stepped(const TickContext& tick, double dt, std::vector<TrackPlace>& places, world::CartMotion& cart) {
  const Derived& derived = tick.input.derived;
  const world::Document& document = tick.input.document;
  const bool losses = !(tick.resistance == world::Resistance{});
  const int most_parts = kMaxJointsPerTick * static_cast<int>(places.size());
  for (int part = 0, switched = 0; dt > 0 && part < most_parts; ++part) {
    TrainContext context{derived, places, document.datum, cart.reference_energy, tick.resistance};
    const Contacts& contacts = update_drive(tick, context, cart);
    const Drive drive = tick.control.drive;
    if (drive.held) return halt(cart), true;
    if (!tick.row.splits && part == 0 && !near_equipment(tick, contacts, cart) &&
        advance_across(tick, dt, places, cart))
      return true;
    context.drive = drive.acceleration;
    context.direction = drive.net ? 0.0 : direction_of(context, cart.speed);
    if (losses && !drive.net && stays_at_rest(context, cart.speed)) return true;
    const TrainState state{0.0, cart.speed, cart.work};
    double used = dt;
    const auto after = [&](double time) { return advance(tick, context, state, time); };
    TrainState next = after(used);
    const auto cut = [&](const auto& value, double within = 1e-15) {
      used = time_of(state, used, after, value, within), next = after(used);
    };
    const double ahead = joint_ahead(context), back = joint_behind(context);
    const bool forward = next.x > ahead, backward = next.x < back;
    if (forward || backward) cut([&](const TrainState& at) { return forward ? at.x - ahead : back - at.x; });
    bool at_joint = forward || backward;
    if (losses && context.direction != 0 && next.speed * context.direction < 0) {
      cut([&](const TrainState& at) { return -at.speed * context.direction; });
      next.speed = 0;
      at_joint = false;
    }
    const auto switches = [&](const TrainState& at) {
      ControlState then = tick.control.state;
      return drive_at(tick, context, contacts, at, then) == drive && then == tick.control.state ? -1.0 : 1.0;
    };
    if (!contacts.on.empty() && switched < kMostSwitches && switches(next) > 0) {
      cut(switches, kSwitchWithin);
      ++switched, at_joint = false;
    }
    const double x = at_joint ? (forward ? ahead : back) : next.x;
    const bool on_track = move_cars(derived, x, forward, at_joint, places, cart.laps);
    cart.travelled += x, cart.speed = next.speed, cart.work = next.work;
    if (!on_track) return false;
    dt -= used;
  }
  return true;
}

}  // namespace coaster::sim
