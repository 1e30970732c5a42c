// The integrators, and the ticks of trains. Stepped rows work in arc length on a train between two joints: ticks are
// split there.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/ride/ride.h"
#include "sim/ride/ride_detail.h"

namespace coaster::sim {
namespace {

// s' = v, v' = a(s) + b(v), W' = b v: gravity depends only on s, losses and equipment only on v.
TrainRates slopes(const TrainContext& context, const TrainState& state) {
  const double others = context.others(state.speed);
  return {state.speed, context.gravity(state.x) + others, others * state.speed};
}

TrainState rk4(const TrainContext& context, TrainState state, double dt) {
  return runge_kutta(state, slopes(context, state), dt, [&](const TrainState& at) { return slopes(context, at); });
}

// Velocity Verlet: symplectic without losses, so its energy error stays bounded.
TrainState verlet(const TrainContext& context, TrainState state, double dt) {
  const TrainRates k = slopes(context, state);
  const double x = state.x + dt * state.speed + 0.5 * dt * dt * k.acceleration;
  const double others = context.others(state.speed + dt * k.acceleration);
  const double speed = state.speed + 0.5 * dt * (k.acceleration + context.gravity(x) + others);
  return {x, speed, state.work + 0.5 * dt * (k.power + others * speed)};
}

// Semi-implicit Euler: the speed first, then the position with the new speed.
TrainState euler(const TrainContext& context, TrainState state, double dt) {
  const TrainRates k = slopes(context, state);
  const double speed = state.speed + dt * k.acceleration;
  return {state.x + dt * speed, speed, state.work + dt * k.power};
}

// Barrett 2012, section 4: the speed from the energy, then distance = speed x time. Paper erratum: a speed of 0 stays
// 0, so a cart at rest never starts and one that should roll back stops.
TrainState energy_method(const TrainContext& context, TrainState state, double dt) {
  const double kinetic =
      context.reference_energy + state.work - world::kGravity * (context.height(state.x) - context.datum);
  const double speed = kinetic > 0 ? std::copysign(std::sqrt(2.0 * kinetic), state.speed) : 0.0;
  return {state.x + speed * dt, speed, state.work + context.others(speed) * speed * dt};
}

constexpr std::array<Integrator, 6> kIntegrators{{
    {"rk4", "Runge-Kutta 4", "s'' = -g T_y(s), four slopes, twice a tick", IntegratorKind::stepped, rk4, 2, true},
    {"verlet", "Velocity Verlet", "s += v dt + a dt^2/2, v += (a_old + a_new) dt/2; equal steps, across joints",
     IntegratorKind::stepped, verlet, 1, false},
    {"energy", "Energy (the paper's)", "v = sqrt(2 (E - g h)), s += v dt; freezes at v = 0", IntegratorKind::stepped,
     energy_method, 1, true},
    {"euler", "Semi-implicit Euler", "v += a dt, s += v dt", IntegratorKind::stepped, euler, 1, true},
    {"precomputed", "Precomputed timetable", "s(t) and v(t) of the whole ride from tables, looked up each tick",
     IntegratorKind::timetable, nullptr, 1, true},
    {"vertices", "By polyline vertices", "from vertex to vertex in time chord / speed; as smooth as the resolution",
     IntegratorKind::vertices, nullptr, 1, true},
}};

// What equipment needs to know of a train during a tick.
struct TrainControl {
  TrainContacts contacts;
  ControlState state;
  bool way_free = true;
  Drive drive;  // the last one
};

struct TickContext {
  const RideInput& input;
  const Integrator& row;
  world::Losses resistance;  // of the current train
  TrainPlace train;          // its cars
  TrainControl& control;
};

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

double distance_of(const DerivedTrack& derived, TrackPlace place) { return derived.starts[place.index] + place.s; }

// Returns the drive from a moment within a part of a tick on. Updates `control`.
Drive drive_at(const TickContext& tick, const TrainContext& context, const Contacts& contacts, const TrainState& state,
               ControlState& control) {
  const std::function<double()> free = [&] {
    return free_acceleration(context.gravity(state.x), state.speed, context.resistance);
  };
  const double step = tick.row.kind == IntegratorKind::vertices ? world::kTick : 0.0;
  const TrainMoment now{distance_of(context.derived, context.cars.front()) + state.x, state.speed, free, step};
  return drive_of(contacts, tick.train, now, tick.control.way_free, control);
}

// Moves the cars by x; those that reach the joint at `reached` cross it. Returns false if the first car reaches an open
// end.
bool move_cars(const DerivedTrack& derived, double x, bool forward, bool at_joint, std::vector<TrackPlace>& places,
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

double driven_direction(const TrainContext& context, double speed) {
  return direction_of(speed, context.resistance, [&] { return context.gravity(0.0) + context.drive; });
}

bool stays_at_rest(const TrainContext& context, double speed) {
  return speed == 0 && context.resistance.rolling > 0 && driven_direction(context, 0.0) == 0.0;
}

// Advances a train by `dt` in one step across joints. Returns false and changes nothing if that is not possible: at
// open ends, and where losses stop it.
bool advance_across(const TickContext& tick, double dt, std::vector<TrackPlace>& places, world::TrainMotion& cart) {
  const DerivedTrack& derived = tick.input.derived;
  const world::Document& document = tick.input.document;
  TrainContext context{derived, places, document.datum, cart.reference_energy, tick.resistance, 0.0, 0.0, true};
  context.direction = driven_direction(context, cart.speed);
  const bool losses = !(tick.resistance == world::Losses{});
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
bool near_equipment(const TickContext& tick, const Contacts& contacts, const world::TrainMotion& cart) {
  constexpr double kMargin = 1;  // m
  const double reach = std::abs(cart.speed) * world::kTick + kMargin;
  const TrainContacts& next = tick.control.contacts;
  return !contacts.on.empty() || cart.travelled + reach > next.ahead() || cart.travelled - reach < next.behind();
}

// Updates the drive of a train in its present state. Returns the equipment that it is on.
const Contacts& update_drive(const TickContext& tick, const TrainContext& context, const world::TrainMotion& cart) {
  TrainControl& control = tick.control;
  const TrackExtent rails{tick.input.derived.length, tick.input.derived.closed};
  TrainPlace train = tick.train;
  train.front = distance_of(tick.input.derived, context.cars.front());
  const Contacts& contacts =
      control.contacts.update(tick.input.equipment, rails, train, cart.travelled, cart.speed < 0);
  control.drive = drive_at(tick, context, contacts, {0.0, cart.speed, cart.work}, control.state);
  return contacts;
}

// Advances a train by `dt` in parts that end at joints, where equipment switches and where losses stop it. Returns
// false at an open end.
bool advance_stepped(const TickContext& tick, double dt, std::vector<TrackPlace>& places, world::TrainMotion& cart) {
  const DerivedTrack& derived = tick.input.derived;
  const world::Document& document = tick.input.document;
  const bool losses = !(tick.resistance == world::Losses{});
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
    context.direction = drive.net ? 0.0 : driven_direction(context, cart.speed);
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

// The data of a train for integrators without a TrainContext.
struct TrainLoad {
  int cars = 1;
  double spacing = 3;        // m
  world::Losses resistance;  // for this train's mass
  double drive = 0;          // m/s^2 by equipment
};

// Returns the speed by the energy, with the first car at height `height` m (of a vertex: not exactly on the curve) and
// the others behind it on the curve.
double speed_at(const RideInput& input, const TrainLoad& load, const world::TrainMotion& cart, TrackPlace front,
                double height) {
  if (load.cars > 1) {
    std::vector<TrackPlace> places;
    place_cars(input.derived, front, load.cars, load.spacing, places);
    for (std::size_t i = 1; i < places.size(); ++i)
      height += rail_point(input.derived.shape_at(places[i].index), places[i].s).height;
    height /= load.cars;
  }
  const double kinetic = cart.reference_energy + cart.work - world::kGravity * (height - input.document.datum);
  return kinetic > 0 ? std::sqrt(2.0 * kinetic) : 0.0;
}

// Advances by the paper's conclusion: from vertex to vertex of the polyline, each chord / speed after the last. The
// speed follows from the energy at the vertex, with the cars' mean height, losses and equipment. A train at rest stays,
// as in the paper, unless equipment pushes it. The remaining time is kept in cart.carry. Returns false at an open end.
bool advance_by_vertices(const RideInput& input, const TrainLoad& load, double dt, world::TrainMotion& cart) {
  const DerivedTrack& derived = input.derived;
  constexpr int kMostVertices = 100'000;  // per tick
  double time = cart.carry + dt;
  const bool forward = cart.speed > 0 || (cart.speed == 0 && load.drive >= 0);
  const double sign = forward ? 1.0 : -1.0;
  std::size_t index = front_place(derived, cart).index;
  Polyline polyline;  // of that segment; empty: not yet evaluated
  for (int n = 0; n < kMostVertices; ++n) {
    const SegmentShape& shape = derived.shape_at(index);
    if (polyline.points.empty()) evaluate_polyline(shape, polyline);
    // A GPU evaluator has no polyline here: use as many steps of the exact curve.
    const int count = derived.steps + 1;
    const auto vertex = [&](int i) {
      return polyline.points.empty() ? curve::point(shape.key.cubic, static_cast<double>(i) / (count - 1))
                                     : glm::dvec3(polyline.points[static_cast<std::size_t>(i)]);
    };
    const double at = shape.arc.parameter(cart.s) * (count - 1);
    constexpr double kOnVertex = 1e-6;  // of a step
    const int from = std::clamp(static_cast<int>(std::lround(at)), 0, count - 1);
    const int here =
        std::abs(at - from) < kOnVertex ? from : static_cast<int>(forward ? std::floor(at) : std::ceil(at));
    const int to = here + (forward ? 1 : -1);
    if (to < 0 || to >= count) {
      const bool at_end = forward ? index + 1 == derived.order.size() : index == 0;
      if (at_end && !derived.closed) return false;
      if (at_end) cart.laps += forward ? 1 : -1;
      index = forward ? (index + 1) % derived.order.size() : (index + derived.order.size() - 1) % derived.order.size();
      settle_on(derived, {index, forward ? 0.0 : derived.shape_at(index).arc.length()}, cart);
      polyline.points.clear();
      continue;
    }
    const glm::dvec3 a = vertex(here), b = vertex(to);
    const double chord = glm::length(b - a), s = shape.arc.distance(static_cast<double>(to) / (count - 1));
    cart.speed = sign * speed_at(input, load, cart, {index, cart.s}, a.y);
    // From rest, equipment moves it over the first chord with v^2 = 2 a s, at half of that speed on average.
    const double pace =
        cart.speed != 0 ? std::abs(cart.speed) : 0.5 * std::sqrt(std::max(0.0, 2.0 * sign * load.drive * chord));
    if (!(pace > 0) || !(time >= chord / pace)) break;
    time -= chord / pace;
    cart.work += (sign * load.drive - loss(load.resistance, pace)) * std::abs(s - cart.s);
    cart.travelled += s - cart.s;
    settle_on(derived, {index, s}, cart);
    cart.speed = sign * speed_at(input, load, cart, {index, s}, b.y);
  }
  cart.carry = cart.speed != 0 || load.drive != 0 ? time : 0.0;
  return true;
}

bool way_free(const RideInput& input, std::span<const TrainPlace> trains, std::size_t train) {
  const TrackExtent rails{input.derived.length, input.derived.closed};
  return section_free(input.equipment, rails, trains[train], trains.first(train)) &&
         section_free(input.equipment, rails, trains[train], trains.subspan(train + 1));
}

// Returns whether a train ran off an open end with this speed. One that never moved was pulled out at its start.
world::FailureKind end_of_track(double arrival, world::TrainMotion& cart) {
  cart.furthest = std::max(cart.furthest, cart.travelled);
  return std::abs(arrival) > kStillSpeed || cart.travelled == 0 ? world::FailureKind::off_end
                                                                : world::FailureKind::none;
}

bool at_open_end(const DerivedTrack& derived, const world::TrainMotion& cart) {
  const bool first = cart.segment == derived.order.front(), last = cart.segment == derived.order.back();
  return !derived.closed && cart.speed == 0 && ((first && cart.s <= 0) || (last && cart.s >= cart.segment_length));
}

struct TickTrain {
  world::Entity entity;
  world::TrainMotion* motion;
  int cars;
  double spacing, length;
  world::Losses resistance;
  std::vector<TrackPlace> places;
  TrainControl control{};
};

std::vector<TickTrain> trains_of(const RideInput& input, world::Motion& motion) {
  std::vector<TickTrain> trains;
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    const world::Entity entity = motion.carts.entities()[i];
    const world::Train& design = input.document.entities.get<world::Train>(entity);
    TickTrain train{entity,
                    &motion.carts.items()[i],
                    cars_on(input.derived, design),
                    design.spacing,
                    design.body(),
                    resistance_of(input.document, design.mass),
                    {},
                    {}};
    train.control.state = {train.motion->dwell, train.motion->braking};
    place_cars(input.derived, front_place(input.derived, *train.motion), train.cars, train.spacing, train.places);
    trains.push_back(std::move(train));
  }
  return trains;
}

// Returns the acceleration by equipment alone, m/s^2.
double drive_force(const TickContext& tick, const TickTrain& train) {
  const Drive& drive = tick.control.drive;
  if (!drive.net) return drive.acceleration;
  return drive.acceleration -
         acceleration_of({tick.input.derived, train.places, 0, 0, train.resistance}, train.motion->speed);
}

// Advances one train by one tick. Returns false if it is at an open end.
bool advance_train(const TickContext& tick, TickTrain& train) {
  world::TrainMotion& cart = *train.motion;
  const DerivedTrack& derived = tick.input.derived;
  TrainControl& control = tick.control;
  count_down(control.way_free, control.state);
  update_drive(tick, {derived, train.places, 0, 0, train.resistance}, cart);
  if (control.drive.held) return halt(cart), true;
  if (at_open_end(derived, cart) && control.drive == Drive{}) {
    const TrainContext context{derived, train.places, 0, 0, {}, 0, 0};
    const double pull = context.gravity(0.0);
    // A train at rest at its start without a pull has not reached the end of a ride: it stalls.
    const bool stands = cart.travelled == 0 && std::abs(pull) <= world::kGravity * train.resistance.rolling;
    if (stands) return true;
    if (cart.s <= 0 ? pull <= 0 : pull >= 0) return false;
  }
  bool on_track = true;
  if (tick.row.kind == IntegratorKind::vertices) {
    on_track = advance_by_vertices(tick.input, {train.cars, train.spacing, train.resistance, drive_force(tick, train)},
                                   world::kTick, cart);
    place_cars(derived, front_place(derived, cart), train.cars, train.spacing, train.places);
  } else {
    for (int part = 0; part < tick.row.substeps && on_track; ++part)
      on_track = advance_stepped(tick, world::kTick / tick.row.substeps, train.places, cart);
    settle_on(derived, train.places.front(), cart);
  }
  return on_track;
}

}  // namespace

std::span<const Integrator> integrators() { return kIntegrators; }

void step_trains(const RideInput& input, const Integrator& row, int ticks, world::Motion& motion) {
  std::vector<TickTrain> trains = trains_of(input, motion);
  const TrackExtent rails{input.derived.length, input.derived.closed};
  std::vector<TrainPlace> places(trains.size());
  std::vector<char> left(trains.size());  // 1: at an open end
  const auto fail = [&](world::FailureKind kind, const TickTrain& train, double speed) {
    motion.failure = {kind, train.entity, train.motion->track_distance, speed};
    if (kind != world::FailureKind::off_end) motion.state = world::RideState::failed;
  };
  for (int n = 0; n < ticks && motion.state == world::RideState::running; ++n) {
    for (std::size_t i = 0; i < trains.size(); ++i)
      places[i] = {trains[i].motion->track_distance, trains[i].cars, trains[i].spacing, trains[i].length};
    bool any = false;
    const TickTrain* waiting = nullptr;  // the first for a block, while all wait
    bool all_wait = true;
    for (std::size_t i = 0; i < trains.size() && motion.state == world::RideState::running; ++i) {
      world::TrainMotion& cart = *trains[i].motion;
      TrainControl& control = trains[i].control;
      const TickContext tick{input, row, trains[i].resistance, places[i], control};
      const bool waits = control.state.dwell == 1;
      control.way_free = trains.size() < 2 || way_free(input, places, i);
      const bool on_track = advance_train(tick, trains[i]);
      const double arrival = cart.speed;
      if (!on_track) halt(cart);  // at the buffer stop
      cart.drive = drive_force(tick, trains[i]);
      cart.dwell = control.state.dwell, cart.braking = control.state.braking;
      cart.peak_kinetic = std::max(cart.peak_kinetic, 0.5 * cart.speed * cart.speed);
      any |= on_track;
      if (waits && control.state.dwell == 1 && waiting == nullptr) waiting = &trains[i];
      all_wait = all_wait && (!on_track || (waits && control.state.dwell == 1));
      const world::FailureKind end = on_track ? end_of_ride(input.document, cart.speed, cart.travelled,
                                                            control.drive.held, cart.furthest, cart.still)
                                              : end_of_track(arrival, cart);
      if (end != world::FailureKind::none) fail(end, trains[i], arrival);
      places[i].front = cart.track_distance;
    }
    if (motion.state == world::RideState::running && trains.size() > 1) {
      for (std::size_t i = 0; i < trains.size(); ++i) left[i] = at_open_end(input.derived, *trains[i].motion) ? 1 : 0;
      if (const auto i = first_collision(rails, places, left))
        fail(world::FailureKind::collision, trains[*i], trains[*i].motion->speed);
      else if (all_wait && waiting != nullptr) fail(world::FailureKind::deadlock, *waiting, 0);
    }
    if (!any && motion.state == world::RideState::running) motion.state = world::RideState::ended;
  }
}

}  // namespace coaster::sim
