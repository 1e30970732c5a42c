// The ticks of the ride: its trains, blocks, and the ends of a ride.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/ride/ride_parts.h"

namespace coaster::sim {
namespace {

bool way_free(const RideInput& input, std::span<const TrainPlace> trains, std::size_t train) {
  const Rails rails{input.derived.length, input.derived.closed};
  return section_free(input.equipment, rails, trains[train], trains.first(train)) &&
         section_free(input.equipment, rails, trains[train], trains.subspan(train + 1));
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
  Control control{};
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
                {},
                {}};
    train.control.state = {train.motion->dwell, train.motion->braking};
    place_cars(input.derived, front_place(input.derived, *train.motion), train.cars, train.spacing, train.places);
    trains.push_back(std::move(train));
  }
  return trains;
}

// Returns the acceleration by equipment alone, m/s^2.
double drive_force(const TickContext& tick, const Train& train) {
  const Drive& drive = tick.control.drive;
  if (!drive.net) return drive.acceleration;
  return drive.acceleration -
         acceleration_of({tick.input.derived, train.places, 0, 0, train.resistance}, train.motion->speed);
}

// Advances one train by one tick. Returns false if it is at an open end.
bool advance_train(const TickContext& tick, Train& train) {
  world::CartMotion& cart = *train.motion;
  const Derived& derived = tick.input.derived;
  Control& control = tick.control;
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
    const Train* waiting = nullptr;  // the first for a block, while all wait
    bool all_wait = true;
    for (std::size_t i = 0; i < trains.size() && motion.state == world::RideState::running; ++i) {
      world::CartMotion& cart = *trains[i].motion;
      Control& control = trains[i].control;
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
      if (const auto failure = failure_of(tick, on_track && control.drive.held, on_track, arrival, cart))
        fail(*failure, trains[i], arrival);
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
