// The values that colour the track, at uniform positions of every segment: of the whole ride, the curve or the
// evaluator. Cached, so that a frame without changes costs a comparison.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/ride/ghost.h"

namespace coaster::sim {

inline constexpr int kValuesPerSegment = 32;   // uniform in arc length, both ends included
inline constexpr float kUnknownValue = 3e38f;  // where the ride does not arrive

struct TrackValues {
  world::Colouring colouring{};
  std::vector<float> values;  // kValuesPerSegment per segment of derived.order, in the unit of the colouring's row
  double low = 0, high = 1;   // of the legend: round numbers around the values, low < high
  std::span<const float> of(std::size_t index) const {
    return std::span(values).subspan(index * kValuesPerSegment, kValuesPerSegment);
  }
};

class TrackValueMemo {
 public:
  // Updates the values. `ghost` is read only for colourings of the ride; without one their values are unknown. Ride
  // values: riders of the middle car; if it passes several times, the value that differs most from rest. Height and
  // curvature: only changed segments are recomputed, 10 us each. Error: sim::error_profile() of
  // settings.evaluation->evaluator, the largest near each position. Plain: nothing.
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
