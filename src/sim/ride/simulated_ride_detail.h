// Tables that the simulated ride reads at every tick: the train's mean slope, and what riders feel. For simulated
// ride.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "sim/ride/simulated_ride.h"

namespace coaster::sim {

// The train's mean slope as a function of its first car's position, on a uniform grid. Within a cell the slope is the
// derivative of a cubic Hermite height, so that the ride's gains and losses of energy add up to the heights. Cells are
// computed in blocks when first needed: a ride on a very long track reaches few of them. Refers to its arguments.
class MeanSlopeTable {
 public:
  MeanSlopeTable(const RailTables& tables, std::span<const SegmentTable* const> segments, int cars, double spacing);

  // On a closed track `at` may be up to one lap outside.
  double slope(double at) {
    if (closed_ && at >= length_) at -= length_;
    if (closed_ && at < 0) at += length_;
    const double place = at * per_metre_;
    const std::int64_t i = place > 0 ? std::min(static_cast<std::int64_t>(place), last_) : 0;
    const double u = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
    const std::vector<Cell>& cells = blocks_[static_cast<std::size_t>(i) / kBlock];
    if (cells.empty()) fill(static_cast<std::size_t>(i) / kBlock);
    const Cell& cell = cells[static_cast<std::size_t>(i) % kBlock];
    return cell.a + u * (cell.b + u * cell.c);
  }

 private:
  struct Cell {
    double a, b, c;
  };
  // A car on the grid: at grid point i it is at step * i + offsets[k] in the k-th segment from `first` on, m. The
  // offsets are known as far as they were needed.
  struct Car {
    std::size_t first;
    std::vector<double> offsets;
  };
  static constexpr std::size_t kBlock = 256;  // cells

  void fill(std::size_t block);
  void add_car(Car& car, std::size_t point, std::span<RailPoint> sums) const;
  // True if the car is behind its k-th segment at a grid point and another one follows.
  bool is_past(const Car& car, std::size_t k, std::size_t point) const;
  std::size_t segment(const Car& car, std::size_t k) const { return (car.first + k) % segments_.size(); }
  double length_of(std::size_t segment) const { return tables_.start(segment + 1) - tables_.start(segment); }

  const RailTables& tables_;
  std::span<const SegmentTable* const> segments_;
  bool closed_;
  double length_, step_ = 0, per_metre_ = 0;
  std::vector<Car> cars_;
  std::vector<std::vector<Cell>> blocks_;  // empty: not computed yet
  std::int64_t last_ = 0;                  // signed: converts faster to and from double
};

typedef float Float4 __attribute__((vector_size(16)));
inline Float4 four(float value) { return Float4{value, value, value, value}; }
inline Float4 four(const float* from) {
  Float4 values;
  std::memcpy(&values, from, sizeof(values));
  return values;
}

// Returns FeltEntry::felt() in the first three lanes.
inline Float4 felt_lanes(const FeltEntry& entry, Float4 a, Float4 v2) {
  static_assert(sizeof(FeltEntry) == 9 * sizeof(float), "along, bend, weight");
  const float* const from = reinterpret_cast<const float*>(&entry);
  const Float4 weight = four(from + 5);  // the last four floats of the entry
  return a * four(from) + v2 * four(from + 3) + __builtin_shufflevector(weight, weight, 1, 2, 3, 3);
}

// Returns felt_at(), bit for bit, in less time: a lap with 8 cars takes 75,000 of them.
inline FeltAcceleration force_at(const SegmentTable& table, double s, Float4 a, Float4 v2) {
  Float4 felt;
  if (table.step > 0) {
    const auto last = static_cast<std::int64_t>(table.felt.size()) - 1;
    const double at = std::clamp(s * table.per_metre, 0.0, static_cast<double>(last));
    const std::int64_t i = std::min(static_cast<std::int64_t>(at), last - 1);
    const FeltEntry* const entry = table.felt.data() + i;
    felt = felt_lanes(entry[0], a, v2);
    felt += four(static_cast<float>(at - static_cast<double>(i))) * (felt_lanes(entry[1], a, v2) - felt);
  } else {
    felt = felt_lanes(table.felt.front(), a, v2);
  }
  return {felt[0], felt[1], felt[2]};
}

class TightBendMotion {
 public:
  // Speed and acceleration of the train change linearly from `then` to `now`.
  TightBendMotion(const RideSample& then, const RideSample& now, double seconds)
      : then_(then), now_(now), seconds_(seconds) {}

  // Adds the part of the way within one segment, from s0 to s1 m along it: shares u0 to u1 of the time.
  void add(const SegmentTable& table, double s0, double s1, double u0, double u1);
  // True if the way leads over cells, and a straight line between the entries `before` and `after` (felt g) misses more
  // than noise; over a joint always.
  bool is_needed(const glm::dvec3& before, const glm::dvec3& after, bool joint) const;
  // Returns the passage without car and entry; its time counts from the entry before.
  BendPassage passage() const;

 private:
  struct Moment {
    double speed, a;  // m/s, m/s^2
  };
  Moment at(double share) const;
  // Notes what the bend around a place adds, if that is most so far.
  void take_peak(const SegmentTable& table, double peak, double share);

  const RideSample &then_, &now_;
  double seconds_;
  bool tight_ = false;
  glm::dvec3 before_{0}, after_{0};  // g s
  glm::dvec3 impulse_{0};            // g s, of the peak
  double peak_share_ = 1;
};

}  // namespace coaster::sim
