// One lap as a table over time: the ride of the paper's conclusion, computed once and looked up ever after. Any number
// of trains that share an energy and a length run on one table, each at its own place in it.
#pragma once

#include <span>
#include <vector>

namespace coaster::sim {

struct Ghost;

struct LapEntry {
  double along = 0;  // m into the lap
  double speed = 0;  // m/s
};

// Place and speed at a time: cubic Hermite in time between ticks (the speed is the place's exact derivative there), so
// that at whole ticks it is the ghost's own samples, bit by bit, and between them within 1e-7 m of the curve through
// them.
class LapTable {
 public:
  LapTable() = default;
  // Of a ghost that came round; otherwise, or where a lap takes less than a tick, the table is not valid. Whether laps
  // repeat is for the caller to say: without losses and equipment they do.
  explicit LapTable(const Ghost& ghost);

  bool valid() const { return entries_.size() >= 2; }
  double period() const { return period_; }  // ticks a lap takes, not a whole number
  double length() const { return length_; }  // m
  // The time, in ticks, at which the train is `along` m into its lap, in [0, length()]: bisection to the last bit.
  double phase_at(double along) const;
  // One each tick, the last two at and after the end of the lap.
  std::span<const LapEntry> entries() const { return entries_; }

 private:
  std::vector<LapEntry> entries_;
  double period_ = 0, length_ = 0;
};

// A train on a table.
struct LapCart {
  double phase = 0;  // ticks into the lap, [0, period)
  double along = 0;  // m into the lap
  double speed = 0;  // m/s
  double laps = 0;   // completed, a whole number: the way so far is laps * length + along - where it began
  friend bool operator==(const LapCart&, const LapCart&) = default;
};
// At a phase in [0, period], no lap completed.
LapCart lap_cart(const LapTable& table, double phase);

// Many of them, member by member: 32 bytes a train, so that ten thousand stay in the processor's second cache.
struct LapCarts {
  std::vector<double> phase, along, speed, laps;
  std::size_t size() const { return phase.size(); }
  void add(const LapCart& cart);
  LapCart at(std::size_t i) const { return {phase[i], along[i], speed[i], laps[i]}; }
};

// By one tick; needs a valid table. A train's bits depend on its own state alone, not on how many move with it.
void advance(const LapTable& table, LapCart& cart);
void advance(const LapTable& table, LapCarts& carts);

}  // namespace coaster::sim
