// The simulated ride: a whole ride of one train, simulated at once over tables of the rails. It predicts the ride while
// the track is being dragged, and is the timetable of the integrator `precomputed`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "sim/ride/equipment.h"
#include "sim/ride/lap_table.h"
#include "sim/shape/rail_tables.h"
#include "world/document.h"

namespace coaster::sim {

// The start position and speed of a train.
struct TrainStart {
  double front = 0;  // m from the track's start, of the first car
  double speed = 0;  // m/s
  int cars = 1;
  double spacing = 3;  // m
  ControlState control;
  double length = world::kCarLength;  // m, of a car
  double mass = world::kCarMass;      // kg, of a car
  friend bool operator==(const TrainStart&, const TrainStart&) = default;
};

struct RideSample {
  double travelled = 0;     // m since the start, signed
  double speed = 0;         // m/s
  double acceleration = 0;  // m/s^2 along the rails
  double work = 0;          // J/kg by losses and equipment
};

// An instant within a tick at which equipment switches.
struct RideSwitch {
  std::size_t sample = 0;                                  // the one at the tick's end
  double travelled = 0, speed = 0;                         // as above
  double acceleration_before = 0, acceleration_after = 0;  // m/s^2 along the rails
};

// Felt acceleration in g on the seat's axes, for riders on the heartline.
struct FeltAcceleration {
  float forward = 0, left = 0, up = 1;
};
// Ticks between two entries of SimulatedRide::forces: 60 a second. The last one may be nearer to the one before.
inline constexpr int kForceEvery = 2;

// A car's passage of a joint: the sudden changes caused by the jumps of curvature and roll there, on the seat's axes.
// Both follow from the ends of the tables next to the joint: for riders on h(s), the velocity steps by s' (h'(s+) -
// h'(s-)), felt g by (s'' (h'(s+) - h'(s-)) + s'^2 (h''(s+) - h''(s-))) / g.
struct JointPassage {
  std::size_t knot = 0;  // index in the track
  int car = 0;
  std::size_t entry = 0;              // the first of the forces after it, per car
  double time = 0;                    // s since the start
  double speed = 0;                   // m/s there
  FeltAcceleration impulse{0, 0, 0};  // g s: the step of velocity by g
  FeltAcceleration before{0, 0, 0};   // g, felt just before it
  FeltAcceleration step{0, 0, 0};     // g
  // g s: the integral of felt g from the entry before to that after it, without impulses, less the mean of both entries
  // over that time: what happens between them. Of several passages between the same entries the last has it.
  FeltAcceleration missed{0, 0, 0};
};

// A car's way through a tight bend or a reversal (FeltCell) from the entry before to that of `peak`: instead of the two
// entries, it feels the integrals of felt g over the time between them (g s), each moment counted for the two by how
// near it is. The impulse, 0 unless the sharpest place is passed, is what the bend adds within kSharpSeconds to a
// straight line between felt g at both ends of that time; it is part of the integrals.
struct BendPassage {
  JointPassage peak;  // of the sharpest place; no knot
  FeltAcceleration for_before{0, 0, 0}, for_entry{0, 0, 0};
};
inline constexpr double kSharpSeconds = 0.05;

struct SimulatedRide {
  TrainStart start;
  double track_length = 0;
  bool closed = false;
  double heartline = 0;                               // m, of the riders above the rails
  std::vector<RideSample> samples;                    // one per tick of 1/120 s, the first at the start
  std::vector<RideSwitch> switches;                   // in order
  std::vector<FeltAcceleration> forces;               // entry k of car c at [k * cars + c], at sample_of(k)
  std::vector<JointPassage> passages;                 // of all cars over all joints, in order
  std::vector<BendPassage> bends;                     // of all cars, in order
  world::FailureKind end = world::FailureKind::none;  // none: a whole lap, or the time limit was reached
  bool lap = false;                                   // completed a lap
  std::uint64_t serial = 0;                           // number of the simulation, from 1: a new ride has a new number
  double lap_time = 0;                                // s, duration of the lap, if `lap`

  double seconds() const { return samples.empty() ? 0.0 : static_cast<double>(samples.size() - 1) * world::kTick; }
  // Returns the number of entries of the forces, of each car, and what its riders feel at one.
  std::size_t entries() const { return forces.size() / static_cast<std::size_t>(start.cars); }
  const FeltAcceleration& felt(std::size_t entry, int car) const {
    return forces[entry * static_cast<std::size_t>(start.cars) + static_cast<std::size_t>(car)];
  }
  // Returns the time of a sample, s since the start.
  static double time_of(std::size_t sample) { return static_cast<double>(sample) * world::kTick; }
  // Returns the sample of an entry of the forces.
  std::size_t sample_of(std::size_t entry) const { return std::min(entry * kForceEvery, samples.size() - 1); }
  // Returns how far the train gets from its start, m.
  double furthest() const {
    double most = 0;
    for (const RideSample& sample : samples) most = std::max(most, sample.travelled);
    return most;
  }
  // Returns the track distance (m) of car `car` (0: the first) after the train has travelled that far from its start,
  // minus whole laps on a closed track.
  double place(double travelled, int car = 0) const {
    return within_lap(start.front + travelled - car * start.spacing, track_length, closed);
  }
  double distance(std::size_t sample, int car = 0) const { return place(samples[sample].travelled, car); }
};

struct RideLimits {
  double seconds = 900;  // of simulated time
  bool stop_after_lap = true;
};

// Simulates by Runge-Kutta 4 over the train's mean height, one step per tick: on a frictionless 2 km circuit the energy
// stays within 1e-6 of the largest kinetic energy, and a lap takes under 4 ms with 8 cars. The train is alone on the
// track. An empty track gives one sample. Reuses `memory` for the result.
SimulatedRide simulate(const RailTables& tables, std::span<const EquipmentSpan> equipment,
                       const world::Document& document, const TrainStart& start, const RideLimits& limits = {},
                       SimulatedRide memory = {});

// Return the start of a designed train: with its present motion, and at its start position.
TrainStart start_at(const DerivedTrack& derived, const world::Train& design, double front, double speed,
                    ControlState control);
TrainStart start_of(const world::Document& document, const DerivedTrack& derived, const world::Train& design);

// Caches the tables and the simulated rides of a document's trains, and simulates on demand after changes. A result
// stays valid until kMostEntries other rides have been requested.
class RideCache {
 public:
  // Returns the ride of a designed train from its start; null if there is no such train or no track.
  const SimulatedRide* ride(const world::Document& document, const DerivedTrack& derived, world::Entity cart);
  // Returns a ride from any start: the timetable of a moving train.
  const SimulatedRide& from(const world::Document& document, const DerivedTrack& derived, const TrainStart& start);
  // Returns the same ride as a table of one lap, valid as long as from()'s result. The table is invalid if laps do not
  // repeat (with losses or equipment) or none is completed.
  const LapTable& lap(const world::Document& document, const DerivedTrack& derived, const TrainStart& start);
  // Caches at least as many rides (up to kMostEntries * 16), so that many trains do not evict each other's.
  void keep(std::size_t rides);
  // Returns the tables, up to date.
  const RailTables& tables(const world::Document& document, const DerivedTrack& derived);
  // Returns the number of simulations, for tests.
  std::uint64_t simulations() const { return simulations_; }

 private:
  // Everything that a ride depends on.
  struct Key {
    std::uint64_t tables = 0;  // their serial
    TrainStart start;
    world::Losses resistance;
    bool rollback_fails = false;
    std::vector<EquipmentSpan> equipment;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Entry {
    Key key;
    SimulatedRide simulated;
    std::uint64_t used = 0;
    bool has_lap = false;  // `lap` is up to date with the simulated ride
    LapTable lap;
  };
  Entry& find(const world::Document& document, const DerivedTrack& derived, const TrainStart& start);

  RailTables tables_;
  std::deque<Entry> entries_;  // at most most_; the least recently used is evicted
  std::uint64_t simulations_ = 0, clock_ = 0;
  static constexpr std::size_t kMostEntries = 16;
  std::size_t most_ = kMostEntries;
};

struct PassingState {
  double speed = 0, along = 0;  // m/s, negative backwards; m/s^2 along the track
};

// Returns true if a ride goes farther backwards than forwards.
bool runs_backwards(const SimulatedRide& ride);

// Looks up many positions of one ride. Valid as long as the simulated ride.
class PassingLookup {
 public:
  explicit PassingLookup(const SimulatedRide& ride);
  // Returns the state when the point `back` m behind the first car first passes `distance` m from the track's start;
  // nothing if it does not. v^2 between two samples, or a sample and an instant where equipment switches, is the cubic
  // of the way with their speeds and accelerations: within 2e-6 m/s of the energy's.
  std::optional<PassingState> at(double distance, double back = 0) const;

 private:
  const SimulatedRide& ride_;
  bool backwards_;
  std::vector<double> furthest_;  // by sample: how far it has been until then, in that direction
};

// Returns the state at the first car's first pass; nothing if the ride does not reach the position.
inline std::optional<PassingState> passing(const SimulatedRide& ride, double distance) {
  return PassingLookup(ride).at(distance);
}

// Returns a start speed (m/s) with which the first train completes its lap, or reaches the end of an open track: the
// smallest whole number that does, plus 1 so that no top is passed too slowly; at most world::kMaxSpeed. Nothing if
// none does, or without a train. Bisects, because higher speeds also complete the ride. Takes about 9 simulations.
std::optional<double> completing_speed(world::Document document);

}  // namespace coaster::sim
