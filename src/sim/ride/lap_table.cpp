#include "sim/ride/lap_table.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/check.h"
#include "base/numerics.h"
#include "sim/ride/simulated_ride.h"

namespace coaster::sim {
namespace {

constexpr double kPerTick = world::kTick, kPerSecond = world::kTicksPerSecond;

// Hermite interpolation over one tick from (a, va) to (b, vb), m and m/s, u in [0, 1]; at u = 0 exactly (a, va).
inline void between(double a, double va, double b, double vb, double u, double& along, double& speed) {
  const double way = b - a, first = va * kPerTick, last = vb * kPerTick;
  const double p = first + last - 2.0 * way, q = 3.0 * way - 2.0 * first - last;
  along = a + u * (first + u * (q + u * p));
  speed = va + u * (2.0 * q + u * (3.0 * p)) * kPerSecond;
}

inline LapEntry look_up(const LapTable& table, double phase) {
  const auto i = static_cast<std::size_t>(phase);
  const LapEntry &a = table.entries()[i], &b = table.entries()[i + 1];
  LapEntry now;
  between(a.along, a.speed, b.along, b.speed, phase - static_cast<double>(i), now.along, now.speed);
  return now;
}

struct Columns {
  double *phase, *along, *speed, *laps;
};

constexpr std::size_t kBlock = 64;  // data passed between loops stay in the first-level cache

// Advances by one tick: the tick of the lap that each train is in, and the elapsed fraction of it.
inline void turn(double period, std::size_t count, double* __restrict phase, double* __restrict laps,
                 std::int32_t* __restrict entry, double* __restrict part) {
  for (std::size_t i = 0; i < count; ++i) {
    const double next = phase[i] + 1.0, rounds = static_cast<double>(next >= period), now = next - rounds * period;
    phase[i] = now;
    laps[i] += rounds;
    entry[i] = static_cast<std::int32_t>(now);
    part[i] = now - entry[i];
  }
}

struct Pair {
  double along, speed;
};

inline void place(std::size_t count, const Pair* __restrict before, const Pair* __restrict after,
                  const double* __restrict part, double* __restrict along, double* __restrict speed) {
  for (std::size_t i = 0; i < count; ++i) {
    const Pair a = before[i], b = after[i];
    between(a.along, a.speed, b.along, b.speed, part[i], along[i], speed[i]);
  }
}

// Separate loops, so that all but the look-up are vectorised. Every step is one rounded operation, so the bits do not
// depend on the vector width.
void advance_block(const LapTable& table, std::size_t count, const Columns& carts) {
  std::array<std::int32_t, kBlock> entry;
  std::array<double, kBlock> part;
  std::array<Pair, kBlock> before, after;
  turn(table.period(), count, carts.phase, carts.laps, entry.data(), part.data());
  const LapEntry* const entries = table.entries().data();
  for (std::size_t i = 0; i < count; ++i) {
    const LapEntry* const at = entries + entry[i];
    before[i] = {at[0].along, at[0].speed}, after[i] = {at[1].along, at[1].speed};
  }
  place(count, before.data(), after.data(), part.data(), carts.along, carts.speed);
}

}  // namespace

LapTable::LapTable(const SimulatedRide& simulated) {
  if (!simulated.lap || !(simulated.track_length > 0)) return;
  length_ = simulated.track_length;
  for (const RideSample& sample : simulated.samples) {
    entries_.push_back({sample.travelled, sample.speed});
    if (sample.travelled >= length_ && entries_.size() >= 2) break;
  }
  // The lap ends in the last tick. One more entry, so that a phase of exactly the period has a tick.
  entries_.push_back({entries_.back().along + entries_.back().speed * kPerTick, entries_.back().speed});
  period_ = static_cast<double>(entries_.size() - 2);
  period_ = phase_at(length_);
  if (period_ < 1.0) entries_.clear();  // a table cannot represent several laps per tick
}

double LapTable::phase_at(double along) const {
  return base::bisect({0, period_}, 80, [&](double phase) { return look_up(*this, phase).along < along; }).high;
}

LapTrain lap_cart(const LapTable& table, double phase) {
  const LapEntry place = look_up(table, std::clamp(phase, 0.0, table.period()));
  return {phase, place.along, place.speed, 0};
}

void LapTrains::add(const LapTrain& cart) {
  phase.push_back(cart.phase), along.push_back(cart.along), speed.push_back(cart.speed), laps.push_back(cart.laps);
}

void advance(const LapTable& table, LapTrain& cart) {
  COASTER_CHECK(table.valid(), "the table covers a whole lap");
  advance_block(table, 1, {&cart.phase, &cart.along, &cart.speed, &cart.laps});
}

void advance(const LapTable& table, LapTrains& carts) {
  COASTER_CHECK(table.valid(), "the table covers a whole lap");
  for (std::size_t i = 0; i < carts.size(); i += kBlock)
    advance_block(table, std::min(kBlock, carts.size() - i),
                  {&carts.phase[i], &carts.along[i], &carts.speed[i], &carts.laps[i]});
}

}  // namespace coaster::sim
