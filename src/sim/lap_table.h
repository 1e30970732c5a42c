// One lap as a table over time: the ride of the paper's conclusion, computed once and looked up ever after. Any number of trains that share an
// energy and a length run on one table, each at its own place in it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace coaster::sim {

struct Ghost;

struct LapEntry {
  double along = 0;  // m since the lap began
  double speed = 0;  // m/s
};

// Place and speed at a time: cubic Hermite in time between ticks (the speed is the place's exact derivative there), so that at whole ticks it
// is the ghost's own samples, bit by bit, and between them within 1e-7 m of the curve through them.
class LapTable {
 public:
  LapTable() = default;
  // Of a ghost that came round; otherwise, or where a lap takes less than a tick, the table is not valid. Whether laps repeat is
  // for the caller to say: without losses and equipment they do.
  explicit LapTable(const Ghost& ghost);

  bool valid() const { return entries_.size() >= 2; }
  double period() const { return period_; }  // ticks a lap takes, not a whole number
  double length() const { return length_; }  // m
  // `phase` in ticks since the lap began, [0, period()].
  LapEntry at(double phase) const;
  // The time, in ticks, at which the train is `along` m into its lap, in [0, length()]: bisection to the last bit.
  double phase_at(double along) const;
  // For loops over many trains: one entry each tick, the last two at and after the end of the lap.
  std::span<const LapEntry> entries() const { return entries_; }

 private:
  std::vector<LapEntry> entries_;
  double period_ = 0, length_ = 0;
};

// A train on a table. 40 bytes: ten thousand stay in the processor's second cache.
struct LapCart {
  double phase = 0;      // ticks into the lap, [0, period)
  double along = 0;      // m into the lap
  double speed = 0;      // m/s
  double travelled = 0;  // m, sum of the way of each tick
  std::int64_t laps = 0;  // completed
  friend bool operator==(const LapCart&, const LapCart&) = default;
};
// At a phase in [0, period), nothing travelled yet.
LapCart lap_cart(const LapTable& table, double phase);

// All trains by one tick. Each train's bits depend on its own state alone, however many there are. Needs a valid table.
void advance(const LapTable& table, std::span<LapCart> carts);

}  // namespace coaster::sim
