// What the riders of each car and seat feel along a simulated ride, one sample per entry of SimulatedRide::forces.
// Reads the finished ride, so that nothing is simulated twice.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/enum_names.h"
#include "sim/ride/ride.h"
#include "sim/ride/simulated_ride.h"
#include "world/sections.h"

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

// --- Loads of a car's wheels, by statics: the forces with which the rails give the car its felt g (docs/ride.md). A
// car has two bogies. Each side of a bogie has a road wheel above the rail, an up-stop wheel below it and a side wheel
// outside it

inline constexpr double kBogieShare = 0.6;  // distance between the bogies over the car's length

// A car as a rigid body. Its centre of mass is on the heartline, where felt g is given.
struct CarBody {
  double mass = world::kCarMass;      // kg, with riders
  double length = world::kCarLength;  // m
  double height = 0;                  // m, of the centre of mass above the rails; below 0: under them
};

// Loads in kN, never negative: the rails push road wheels up, up-stop wheels down, side wheels outwards.
struct LoadsByWheelKind {
  double road = 0, up_stop = 0, side = 0;
};

// Sets of wheels: the whole car, a bogie, a side, or one side of a bogie.
enum class WheelSet : std::uint8_t { car, front, rear, left, right, front_left, front_right, rear_left, rear_right };
inline constexpr base::NameRow kWheelSets[] = {{"car", "Car"},
                                               {"front", "Front"},
                                               {"rear", "Rear"},
                                               {"left", "Left"},
                                               {"right", "Right"},
                                               {"front_left", "Front left"},
                                               {"front_right", "Front right"},
                                               {"rear_left", "Rear left"},
                                               {"rear_right", "Rear right"}};
constexpr std::span<const base::NameRow> rows_of(WheelSet) { return kWheelSets; }

struct WheelLoads {
  std::array<LoadsByWheelKind, 4> corners;  // front left, front right, rear left, rear right
  // Returns the sum over a set.
  LoadsByWheelKind of(WheelSet set) const;
};

// Returns the loads of a car: forces sum to mass times felt g up and to the left, and all moments about the centre of
// mass vanish. Forces along the track act at the height of the rails. Both bogies take half of the lateral force.
WheelLoads wheel_loads(const FeltAcceleration& felt, const CarBody& car);
// Return the loads of a train's first car in its present motion, and of a simulated ride's car at an entry of
// SimulatedRide::forces.
WheelLoads wheel_loads(const world::Document& document, const DerivedTrack& derived, world::Entity train,
                       const world::TrainMotion& motion);
WheelLoads wheel_loads(const SimulatedRide& simulated, std::size_t entry, int car);

// --- Figures of each section of the track: length, heights, and of a ride the speeds and g

struct SectionFigures {
  world::SectionRun run;
  double length = 0;                   // m
  double start = 0, end = 0, top = 0;  // m, heights of the curve: at both ends, and the largest
  // For a seat's riders at their first pass; nothing where they do not arrive. Speeds at both ends (m/s); the largest
  // and the least vertical g; the largest lateral g, absolute.
  std::optional<double> speed_in, speed_out, g_most, g_least, g_side;
};

// The sections in track order.
struct SectionTable {
  std::vector<SectionFigures> rows;
  std::uint64_t serial = 0;  // new for each change
  const SectionFigures& of(const world::SectionRun& run) const;
};

// Returns the figures of all sections. `riders`: of the seat; none without a ride. Linear in segments and entries.
std::vector<SectionFigures> section_figures(const world::Document& document, const DerivedTrack& derived,
                                            std::span<const Rider> riders);

}  // namespace coaster::sim
