#include "sim/lap_table.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "sim/ghost.h"

namespace coaster::sim {
namespace {

// Hermite on one tick from `a` to `b`, u in [0, 1]; at u = 0 exactly `a`.
inline LapEntry between(const LapEntry& a, const LapEntry& b, double u) {
  const double way = b.along - a.along, va = a.speed * world::kTick, vb = b.speed * world::kTick;
  const double p = va + vb - 2.0 * way, q = 3.0 * way - 2.0 * va - vb;
  return {a.along + u * (va + u * (q + u * p)), a.speed + u * (2.0 * q + u * (3.0 * p)) * world::kTicksPerSecond};
}

inline LapEntry look_up(const LapEntry* entries, double phase) {
  const auto i = static_cast<std::int64_t>(phase);
  return between(entries[i], entries[i + 1], phase - static_cast<double>(i));
}

}  // namespace

LapTable::LapTable(const Ghost& ghost) {
  if (!ghost.lap || !(ghost.track_length > 0)) return;
  length_ = ghost.track_length;
  for (const GhostSample& sample : ghost.samples) {
    entries_.push_back({sample.travelled, sample.speed});
    if (sample.travelled >= length_ && entries_.size() >= 2) break;
  }
  // The lap ends in the last tick; one more entry, so that a phase of exactly the period has a tick to be in.
  entries_.push_back({entries_.back().along + entries_.back().speed * world::kTick, entries_.back().speed});
  period_ = static_cast<double>(entries_.size() - 2);
  period_ = phase_at(length_);
  if (period_ < 1.0) entries_.clear();  // several laps a tick are no table's work
}

LapEntry LapTable::at(double phase) const { return look_up(entries_.data(), std::clamp(phase, 0.0, static_cast<double>(entries_.size() - 2))); }

double LapTable::phase_at(double along) const {
  double low = 0, high = period_;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) break;
    (at(middle).along < along ? low : high) = middle;
  }
  return high;
}

LapCart lap_cart(const LapTable& table, double phase) {
  const LapEntry entry = table.at(phase);
  return {phase, entry.along, entry.speed, 0, 0};
}

void advance(const LapTable& table, std::span<LapCart> carts) {
  COASTER_CHECK(table.valid(), "trains run on a table of a whole lap");
  const LapEntry* const entries = table.entries().data();
  const double period = table.period(), length = table.length();
  for (LapCart& cart : carts) {
    double phase = cart.phase + 1.0, from = cart.along;
    const bool round = phase >= period;
    phase -= round ? period : 0.0;
    from -= round ? length : 0.0;
    cart.laps += round;
    const LapEntry now = look_up(entries, phase);
    cart.travelled += now.along - from;
    cart.phase = phase, cart.along = now.along, cart.speed = now.speed;
  }
}

}  // namespace coaster::sim
