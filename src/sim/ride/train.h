// A train on the rails: the positions of its cars, the forces on it, and the rules that the live and the simulated ride
// share: losses, and when a ride ends by itself. One speed and one energy for the whole train; cars of equal mass.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "sim/shape/derived_track.h"
#include "world/motion.h"

namespace coaster::sim {

inline constexpr double kRollback = 2.0;     // m that a train may lose before it counts as rolling back
inline constexpr double kStillSpeed = 0.01;  // m/s, slower is at rest
inline constexpr int kStillTicks = 2 * world::kTicksPerSecond;  // at rest, not held, until a train is stalled

// Returns the deceleration by friction and drag, m/s^2.
inline double loss(const world::Losses& resistance, double speed) {
  return world::kGravity * resistance.rolling + resistance.drag * speed * speed;
}

// Returns the sign of the motion that losses oppose. At rest friction opposes pull(), the acceleration by gravity and
// equipment, up to its limit.
template <class Pull>
double direction_of(double speed, const world::Losses& resistance, const Pull& pull) {
  if (speed != 0) return speed > 0 ? 1.0 : -1.0;
  const double acceleration = pull();
  if (std::abs(acceleration) <= world::kGravity * resistance.rolling) return 0.0;
  return acceleration > 0 ? 1.0 : -1.0;
}

// Returns the acceleration by gravity, `pull`, and losses alone.
inline double free_acceleration(double pull, double speed, const world::Losses& resistance) {
  return pull - direction_of(speed, resistance, [&] { return pull; }) * loss(resistance, speed);
}

// Returns how a ride ends by itself after a tick, if it does. Updates `furthest` (m) and `still`, the ticks at rest.
inline world::FailureKind end_of_ride(const world::Document& document, double speed, double travelled, bool held,
                                      double& furthest, std::int32_t& still) {
  furthest = std::max(furthest, travelled);
  if (document.rollback_fails && furthest > kRollback && speed < 0 && travelled < furthest - kRollback)
    return world::FailureKind::rollback;
  still = std::abs(speed) < kStillSpeed && !held ? still + 1 : 0;
  return still >= kStillTicks ? world::FailureKind::stall : world::FailureKind::none;
}

// Returns the rails at arc length s of a segment; beyond its ends the rails continue straight.
RailPoint rail_point(const SegmentShape& shape, double s);

// Returns how many of a designed train's cars fit on the track: all, but on a closed track no more than its length
// allows.
int cars_on(const DerivedTrack& derived, const world::Train& design);

// Returns the position `back` metres behind another (negative: ahead), across any number of joints.
TrackPlace behind(const DerivedTrack& derived, TrackPlace place, double back);

// Returns a document's losses for one train: drag per kilogram is proportional to 1 / mass.
world::Losses resistance_of(const world::Document& document, double car_mass);

// Writes the positions of the middles of a train's cars, first to last, from that of its first car. Cars beyond the end
// of an open track have s outside [0, length] of its first or last segment.
void place_cars(const DerivedTrack& derived, TrackPlace front, int cars, double spacing,
                std::vector<TrackPlace>& places);

// The state of a train during a part of a tick in which no car crosses a joint. x is the distance moved since the part
// began, m.
struct TrainState {
  double x = 0;
  double speed = 0;  // m/s
  double work = 0;   // J/kg done by everything except gravity
};
// The derivative of the state by time.
struct TrainRates {
  double speed, acceleration, power;
};
inline TrainState moved(const TrainState& state, const TrainRates& k, double dt) {
  return {state.x + dt * k.speed, state.speed + dt * k.acceleration, state.work + dt * k.power};
}
// Takes a step of classical Runge-Kutta, order 4. `k1` is rates(state).
template <class Rates>
TrainState runge_kutta(const TrainState& state, const TrainRates& k1, double dt, const Rates& rates) {
  const TrainRates k2 = rates(moved(state, k1, 0.5 * dt)), k3 = rates(moved(state, k2, 0.5 * dt)),
                   k4 = rates(moved(state, k3, dt));
  const auto mean = [](double a, double b, double c, double d) { return (a + 2.0 * b + 2.0 * c + d) / 6.0; };
  return moved(state,
               {mean(k1.speed, k2.speed, k3.speed, k4.speed),
                mean(k1.acceleration, k2.acceleration, k3.acceleration, k4.acceleration),
                mean(k1.power, k2.power, k3.power, k4.power)},
               dt);
}

// Returns the time in (0, dt] at which `value` (of the state after that time, advance(time)) first reaches zero from
// below: alternating bisection and secants, on the far side, to `within` s.
template <class Advance, class Value>
double time_of(const TrainState& state, double dt, const Advance& advance, const Value& value, double within = 1e-15) {
  double low = 0, high = dt, f_low = value(state), f_high = value(advance(dt));
  for (int i = 0; i < 80 && high - low > within; ++i) {
    double t = 0.5 * (low + high);
    if (i % 3 != 2 && f_high > f_low)
      t = std::clamp(high - f_high * (high - low) / (f_high - f_low), low + 1e-3 * (high - low),
                     high - 1e-3 * (high - low));
    const double f = value(advance(t));
    (f >= 0 ? high : low) = t;
    (f >= 0 ? f_high : f_low) = f;
  }
  return high;
}

struct TrainContext {
  const DerivedTrack& derived;
  std::span<const TrackPlace> cars;  // at x = 0
  double datum = 0;                  // m
  double reference_energy = 0;       // J/kg, including the work so far
  world::Losses resistance;
  double direction = 0;  // sign of the motion that losses oppose: +1, -1, or 0 at rest
  double drive = 0;      // m/s^2 by equipment, constant during a tick
  bool across = false;   // x may cross joints; else the rails continue straight there

  TrackPlace moved(const TrackPlace& car, double x) const {
    return across ? behind(derived, car, -x) : TrackPlace{car.index, car.s + x};
  }
  double height(double x) const;   // m, the cars' mean
  double gravity(double x) const;  // m/s^2 along the rails: -g times the cars' mean slope
  // Returns the acceleration in m/s^2 by losses and equipment.
  double others(double speed) const { return drive - direction * loss(resistance, speed); }
};

// Returns the x at which a car first reaches a joint: +infinity or -infinity if there is none (no cars).
double joint_ahead(const TrainContext& context);
double joint_behind(const TrainContext& context);

}  // namespace coaster::sim
