// What the track is coloured by: a value at uniform places of every segment, of the whole ride, the curve or the
// evaluator. Kept, so that a frame in which nothing changed costs a comparison.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/ride/ghost.h"

namespace coaster::sim {

inline constexpr int kValuesPerSegment = 32;   // uniform in arc length, both ends included
inline constexpr float kUnknownValue = 3e38f;  // where the ride does not come

struct TrackValues {
  world::Colouring colouring{};
  std::vector<float> values;  // kValuesPerSegment for each segment of derived.order, in the unit of the colouring's row
  double low = 0, high = 1;   // of the legend: round numbers around what occurs, low < high
  std::span<const float> of(std::size_t index) const {
    return std::span(values).subspan(index * kValuesPerSegment, kValuesPerSegment);
  }
};

class TrackValueMemo {
 public:
  // `ghost` is read for rows of the ride alone; without one their values are unknown. Rides: riders of the middle car;
  // where it passes more than once, what differs most from rest. Height and curvature: only changed segments are
  // computed again, 10 us each; error as sim::error_profile() of settings.evaluator, the largest near each place.
  // Plain: nothing.
  const TrackValues& update(const Derived& derived, const world::Settings& settings, const Ghost* ghost);

 private:
  using Samples = std::array<float, kValuesPerSegment>;
  struct Key {
    world::Colouring colouring{};
    std::uint64_t ghost = 0, build = 0;
    curve::EvaluatorId evaluator{};
    int steps = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Entry {
    std::uint64_t build = 0;
    Samples samples{};
  };
  void fill_segments(const Derived& derived, const world::Settings& settings);

  Key key_;
  std::vector<world::Entity> order_;
  world::Pool<Entry> entries_;  // of height, curvature or error
  TrackValues result_;
};

}  // namespace coaster::sim
