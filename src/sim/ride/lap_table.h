// One lap as a table over time: the ride of the paper's conclusion, computed once and looked up afterwards. Trains of
// the same energy and length share a table, each at a different phase.
#pragma once

#include <span>
#include <vector>

namespace coaster::sim {

struct SimulatedRide;

struct LapEntry {
  double along = 0;  // m into the lap
  double speed = 0;  // m/s
};

// Position and speed by time: cubic Hermite in time between ticks (the speed is the exact derivative of the position
// there). At whole ticks it equals the simulated ride's samples bit for bit, between them it is within 1e-7 m of the
// curve through them.
class LapTable {
 public:
  LapTable() = default;
  // Builds the table of a simulated ride that completed a lap. Invalid for other simulated rides, and if a lap takes
  // less than a tick. The caller must know that laps repeat: they do without losses and equipment.
  explicit LapTable(const SimulatedRide& simulated);

  bool valid() const { return entries_.size() >= 2; }
  double period() const { return period_; }  // ticks per lap, not a whole number
  double length() const { return length_; }  // m
  // Returns the time, in ticks, at which the train is `along` m into its lap, in [0, length()]: bisection to the last
  // bit.
  double phase_at(double along) const;
  // Returns one entry per tick, the last two at and after the end of the lap.
  std::span<const LapEntry> entries() const { return entries_; }

 private:
  std::vector<LapEntry> entries_;
  double period_ = 0, length_ = 0;
};

// A train on a table.
struct LapTrain {
  double phase = 0;  // ticks into the lap, [0, period)
  double along = 0;  // m into the lap
  double speed = 0;  // m/s
  double laps = 0;   // completed laps, a whole number: the distance so far is laps * length + along - start
  friend bool operator==(const LapTrain&, const LapTrain&) = default;
};
// Returns a train at a phase in [0, period], with no lap completed.
LapTrain lap_cart(const LapTable& table, double phase);

// Many trains, member by member: 32 bytes per train, so that ten thousand fit into the second-level cache.
struct LapTrains {
  std::vector<double> phase, along, speed, laps;
  std::size_t size() const { return phase.size(); }
  void add(const LapTrain& cart);
  LapTrain at(std::size_t i) const { return {phase[i], along[i], speed[i], laps[i]}; }
};

// Advance by one tick; the table must be valid. A train's bits depend only on its own state, not on the number of
// trains.
void advance(const LapTable& table, LapTrain& cart);
void advance(const LapTable& table, LapTrains& carts);

}  // namespace coaster::sim
