#include "sim/study/ratings.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "sim/study/jolt.h"
#include "sim/study/wheel_loads.h"

namespace coaster::sim {
namespace {

void take(Extreme& extreme, double value, bool first, bool larger, std::size_t sample, int car, const Ghost& ghost) {
  if (!first && !(larger ? value > extreme.value : value < extreme.value)) return;
  extreme = {value, static_cast<double>(sample) * world::kTick, ghost.distance(sample, car), car};
}

// Updates `extreme` with the largest of a car's low-passed values on one axis.
void take_force(const Ghost& ghost, int car, ForceAxis axis, double cutoff, double sign, Extreme& extreme) {
  const std::vector<float> values = pressed(ghost, car, axis, cutoff);
  for (std::size_t i = 0; i < values.size(); ++i)
    take(extreme, sign * values[i], car == 0 && i == 0, sign > 0, ghost.sample_of(i), car, ghost);
}

void take_forces(const Ghost& ghost, double cutoff, Ratings& r) {
  for (int car = 0; car < ghost.start.cars; ++car) {
    take_force(ghost, car, ForceAxis::down, cutoff, 1, r.up_most);
    take_force(ghost, car, ForceAxis::lift, cutoff, -1, r.up_least);
    take_force(ghost, car, ForceAxis::side, cutoff, 1, r.side_most);
    take_force(ghost, car, ForceAxis::forward, cutoff, 1, r.forward_most);
    take_force(ghost, car, ForceAxis::back, cutoff, 1, r.back_most);
  }
  const std::vector<float> lifted = pressed(ghost, ghost.start.cars / 2, ForceAxis::lift, cutoff);
  r.airtime = static_cast<double>(std::count_if(lifted.begin(), lifted.end(), [](float v) { return v > 0; })) *
              kForceEvery * world::kTick;
}

// The sums over a car's wheels depend on neither the side nor the direction of the force.
void take_wheels(const Ghost& ghost, double cutoff, Ratings& r) {
  const CarBody body{ghost.start.mass, ghost.start.length, ghost.heartline};
  for (int car = 0; car < ghost.start.cars; ++car) {
    const std::vector<float> up = pressed(ghost, car, ForceAxis::down, cutoff),
                             side = pressed(ghost, car, ForceAxis::side, cutoff),
                             forward = pressed(ghost, car, ForceAxis::forward, cutoff);
    for (std::size_t i = 0; i < up.size(); ++i) {
      const Wheels all = wheel_loads(Felt{up[i], side[i], forward[i]}, body).of(WheelSet::car);
      const bool first = car == 0 && i == 0;
      take(r.road_most, all.road, first, true, ghost.sample_of(i), car, ghost);
      take(r.up_stop_most, all.up_stop, first, true, ghost.sample_of(i), car, ghost);
      take(r.side_load_most, all.side, first, true, ghost.sample_of(i), car, ghost);
    }
  }
}

void take_jolts(const Ghost& ghost, double cutoff, Ratings& r) {
  const auto add = [&](const Passage& passage, const Jolt& jolt) {
    take(r.jolt_most, jolt.total, false, true, ghost.sample_of(passage.entry), passage.car, ghost);
  };
  const std::vector<Jolt> found = passage_jolts(ghost, cutoff);
  for (std::size_t i = 0; i < found.size(); ++i) add(ghost.passages[i], found[i]);
  for (const BendPassage& bend : ghost.bends) add(bend.peak, jolt_of(bend.peak, cutoff));
}

// Updates the heights under the first car: extremes, and descents from a top to the next bottom.
void take_heights(const Ghost& ghost, const RailTables& tables, Ratings& r) {
  std::size_t hint = 0;
  double top = 0, bottom = 0;
  const auto end_drop = [&] {
    const double drop = top - bottom;
    if (drop < kDrop) return;
    ++r.drops;
    r.highest_drop = std::max(r.highest_drop, drop);
  };
  for (std::size_t i = 0; i < ghost.samples.size(); i += kForceEvery) {
    const double s = tables.locate(ghost.distance(i), hint), height = rail_at(tables.segment(hint), s).height;
    take(r.highest, height, i == 0, true, i, 0, ghost), take(r.lowest, height, i == 0, false, i, 0, ghost);
    take(r.top_speed, std::abs(ghost.samples[i].speed), i == 0, true, i, 0, ghost);
    if (i == 0) top = bottom = height;
    constexpr double kNoise = 0.05;  // m of rise that does not end a descent
    if (height < bottom) bottom = height;
    if (height > bottom + kNoise) {
      end_drop();
      top = bottom = height;
    }
    if (height > top) top = bottom = height;
  }
  end_drop();
}

void count_inversions(const Ghost& ghost, const RailTables& tables, Ratings& r) {
  constexpr float kBelow = -0.2f,
                  kAbove = 0.2f;  // of the up vector's height, so that a rider on the side is not counted twice
  const int car = ghost.start.cars / 2;
  std::size_t hint = 0;
  bool inverted = false;
  for (std::size_t i = 0; i < ghost.samples.size(); i += kForceEvery) {
    const double s = tables.locate(ghost.distance(i, car), hint);
    const float up = felt_at(tables.segment(hint), s, 0.0f, 0.0f).z;
    if (!inverted && up < kBelow) ++r.inversions, inverted = true;
    if (up > kAbove) inverted = false;
  }
}

// Returns 0 at 0, 1/2 at `half`, and approaches 1.
double share(double value, double half) { return value > 0 ? value / (value + half) : 0.0; }

}  // namespace

double excitement_of(const Ratings& r) {
  constexpr double kMostUp = 5, kJoltFelt = 1, kJoltWeight = 0.25, kOverloadWeight = 2;
  const double thrill = 3.4 * share(r.highest_drop, 25) + 1.2 * share(r.top_speed.value, 25) +
                        2.2 * share(r.airtime, 3) + 1.2 * share(r.near_misses, 3) + 1.6 * share(r.inversions, 2) +
                        1.0 * share(r.drops, 5) + 1.0 * share(std::min(r.up_most.value, kMostUp) - 1, 2.5);
  const double pain = kJoltWeight * std::max(0.0, r.jolt_most.value - kJoltFelt) + kOverloadWeight * r.overload;
  return std::min(10.0, thrill / (1 + pain));
}

Ratings rate(const Ghost& ghost, const RailTables& tables, double cutoff, const RideMarks& marks) {
  Ratings r;
  r.complete = ghost.lap || ghost.end == world::FailureKind::off_end;
  r.seconds = ghost.lap ? ghost.lap_time : ghost.seconds();
  r.length = ghost.track_length;
  if (tables.size() == 0 || ghost.samples.empty()) return r;
  take_heights(ghost, tables, r);
  take_forces(ghost, cutoff, r);
  take_wheels(ghost, cutoff, r);
  take_jolts(ghost, cutoff, r);
  count_inversions(ghost, tables, r);
  double way = 0;
  for (std::size_t i = 1; i < ghost.samples.size(); ++i)
    way += std::abs(ghost.samples[i].travelled - ghost.samples[i - 1].travelled);
  r.mean_speed = ghost.seconds() > 0 ? way / ghost.seconds() : 0.0;
  const auto g = [](const Extreme& extreme) { return base::limited_figure(extreme.value, "g"); };
  const double p = g(r.up_most), n = g(r.up_least), l = g(r.side_most), d = r.drops, h = r.highest_drop;
  r.near_misses = marks.near_misses;
  for (const RedSpan& span : marks.overloads)
    r.overload += span.allowed > 0 ? std::max(0.0, span.worst / span.allowed - 1) : 1.0;
  r.excitement = excitement_of(r);
  r.intensity = 0.8 * p + 0.8 * (1 - n) + l + 0.14 * d + 0.0098 * h;
  r.nausea = 0.26 * p + 0.22 * (1 - n) + 0.33 * l + 0.10 * d + 0.0031 * h;
  return r;
}

}  // namespace coaster::sim
