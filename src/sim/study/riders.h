// What the riders of each car and seat feel along a simulated ride, one sample per entry of SimulatedRide::forces.
// Reads the finished ride, so that nothing is simulated twice.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/ride/simulated_ride.h"

namespace coaster::world {
enum class Seat : std::uint8_t;  // world/laboratory.h
}

namespace coaster::sim {

// The values along a ride. `name` is that of the query for a seat.
enum class RideValue : std::uint8_t {
  vertical,
  lateral,
  longitudinal,
  jerk,
  jerk_up,
  jerk_side,
  jerk_forward,
  roll_rate,
  roll_acceleration,
  speed,
  height
};
struct RideValueRow {
  std::string_view name, label, unit, help;
  double least_span;  // of a plot; less is noise
};
inline constexpr RideValueRow kRideValues[] = {
    {"seat.g_up", "Vertical g", "g", "Felt g towards the rider's head, not low-passed; 1 at rest on level track.", 0.5},
    {"seat.g_side", "Lateral g", "g", "Felt g to the rider's left, not low-passed.", 0.5},
    {"seat.g_forward", "Longitudinal g", "g", "Felt g forwards, not low-passed.", 0.5},
    {"seat.jerk", "Jerk", "g/s", "Magnitude of the change of the low-passed felt g per second.", 1},
    {"seat.jerk_up", "Vertical jerk", "g/s", "Change of the low-passed vertical g per second.", 1},
    {"seat.jerk_side", "Lateral jerk", "g/s", "Change of the low-passed lateral g per second.", 1},
    {"seat.jerk_forward", "Longitudinal jerk", "g/s", "Change of the low-passed longitudinal g per second.", 1},
    {"seat.roll_rate", "Roll rate", "deg/s",
     "Rate at which the car rolls about the rails against the rotation-minimising frame. Positive to the right.", 5},
    {"seat.roll_acceleration", "Roll acceleration", "deg/s^2", "Change of the roll rate per second.", 20},
    {"seat.speed", "Speed", "m/s", "Speed along the track, negative backwards.", 1},
    {"seat.height", "Height", "m", "Height (y) of the rails under the car.", 1}};
constexpr std::span<const RideValueRow> rows_of(RideValue) { return kRideValues; }
inline constexpr std::size_t kRideValueCount = std::size(kRideValues);

struct RiderSample {
  FeltAcceleration jerk{0, 0, 0};  // g/s on the seat's axes
  float roll_rate = 0;             // deg/s
  float roll_acceleration = 0;     // deg/s^2
  float height = 0;                // m, of the rails
};

// True for values that need samples; the others are the simulated ride's own.
constexpr bool needs_samples(RideValue value) {
  return (value >= RideValue::jerk && value <= RideValue::roll_acceleration) || value == RideValue::height;
}

// One car along a ride. Valid as long as the simulated ride and the samples.
struct Rider {
  const SimulatedRide* simulated = nullptr;
  int car = 0;
  std::span<const RiderSample> samples;  // may be empty where needs_samples() is false
  double cutoff = 0;                     // Hz, of the jerk's low-pass

  std::size_t entries() const { return simulated->entries(); }
  // Returns the car's distance along the track at entry k, m: on a closed track without subtracting laps.
  double place(std::size_t k) const {
    return simulated->start.front + simulated->samples[simulated->sample_of(k)].travelled -
           car * simulated->start.spacing;
  }
  double value(std::size_t k, RideValue value) const;
};

struct CarRange {
  int first = 0, last = 0;  // both included
  int middle() const { return first + (last - first + 1) / 2; }
};

// The samples of a ride's cars, computed for the requested cars.
// Jerk: the low-passed felt g of the force limits (low_passed_g() of study/envelope.h), and its central difference over
// two entries (1/30 s). It lags by the filter's delay, 0.08 s at 5 Hz. Unfiltered g steps where the curvature does, so
// its derivative would depend on the sampling.
// Roll rate: spin (rad/m) times speed. Roll acceleration: its exact derivative, spin' v^2 + spin a, within a segment.
class Riders {
 public:
  // Computes the samples of the cars. About 0.5 ms for a minute of one car.
  void update(const SimulatedRide& simulated, const RailTables& tables, const DerivedTrack& derived, double cutoff,
              CarRange cars);
  // Returns a car requested in the last update() or earlier in the same ride.
  Rider car(int index) const;
  std::vector<Rider> cars(CarRange range) const;
  std::vector<Rider> all() const { return cars({0, static_cast<int>(samples_.size()) - 1}); }

 private:
  const SimulatedRide* simulated_ = nullptr;
  std::uint64_t serial_ = 0;
  double cutoff_ = 0;
  std::vector<std::vector<RiderSample>> samples_;  // by car; empty: not computed
};

// Returns the cars of a seat in a train of `cars` cars. `own`: the car of Seat::car, from 1; beyond the last car it is
// the last one.
CarRange cars_of(world::Seat seat, int own, int cars);

// Curves along a ride. For several cars: the smallest and the largest value; for one car `most` is empty.
struct SeatCurves {
  std::vector<double> place, time;  // position of the middle car: m as by Rider::place, s since the start
  std::array<std::vector<double>, kRideValueCount> least, most;
};
// Returns the curves by position: each car's value when it first reaches the position, so `place` ascends even if the
// train stops, rolls back or starts backwards. Positions one lap apart on a closed track are equal. A car that does not
// reach a position does not count there.
SeatCurves curves_by_place(std::span<const Rider> riders);
// Returns the curves by time: all cars at the same moment. `time` ascends.
SeatCurves curves_by_time(std::span<const Rider> riders);

// Returns the car's value when it first reaches a distance along the track (m), linear between entries but for the
// speed (PassingLookup); nothing if it does not reach it.
std::optional<double> value_at(const Rider& rider, double distance, RideValue value);

// An extreme value, its time and its position.
struct Extreme {
  double value = 0;
  double seconds = 0;   // since the start
  double distance = 0;  // m along the track, of that car
  int car = 0;
};

// Returns the value with the largest magnitude of all these cars, with its sign.
Extreme most_of(std::span<const Rider> riders, RideValue value);

}  // namespace coaster::sim
