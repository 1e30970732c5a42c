// The values that colour the track, at uniform positions of every segment: from the whole ride, the curve or the
// evaluator. Cached, so that a frame without changes costs a comparison.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/study/riders.h"

namespace coaster::sim {

inline constexpr int kValuesPerSegment = 32;   // uniform in arc length, both ends included
inline constexpr float kUnknownValue = 3e38f;  // where the ride does not arrive, or there is no curvature

struct TrackValues {
  world::Colouring colouring{};
  std::vector<float> values;  // kValuesPerSegment per segment of derived.order, in the unit of the colouring's row
  double low = 0, high = 1;   // of the legend: round numbers around the values, low < high
  std::span<const float> of(std::size_t index) const {
    return std::span(values).subspan(index * kValuesPerSegment, kValuesPerSegment);
  }
};

// Returns the value of the ride that colours the track; nothing for a colouring by another quantity.
std::optional<RideValue> ride_value_of(world::Colouring colouring);

class TrackValueCache {
 public:
  // Updates the values. `rider` is read only for colourings of the ride; without one their values are unknown. Ride
  // values: of that car's riders; if it passes several times, the value that differs most from rest. Height and
  // curvature: only changed segments are recomputed, 10 us each. Error: sim::error_profile() of
  // settings.evaluation->evaluator, the largest near each position. Plain: nothing.
  const TrackValues& update(const DerivedTrack& derived, const world::Settings& settings,
                            const std::optional<Rider>& rider);

 private:
  using Samples = std::array<float, kValuesPerSegment>;
  struct Key {
    world::Colouring colouring{};
    std::uint64_t ride = 0;  // its serial
    double cutoff = 0;
    std::uint64_t build = 0;
    curve::EvaluatorId evaluator{};
    int steps = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Entry {
    std::uint64_t build = 0;
    Samples samples{};
  };
  void fill_segments(const DerivedTrack& derived, const world::Settings& settings);

  Key key_;
  std::vector<world::Entity> order_;
  world::Pool<Entry> entries_;  // of height, curvature or error
  TrackValues result_;
};

}  // namespace coaster::sim
