// Places that no train can pass. Folds: the rails run backwards, because the curve bends towards them with a radius
// smaller than their distance from it. Tight bends: the curve bends too tightly, or reverses its direction.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "sim/shape/derived_track.h"

namespace coaster::sim {

struct Fold {
  double from = 0, to = 0;  // m along the track
  double at = 0;            // m along the track, where the curve bends most
  double radius = 0;        // m, radius of the curve there
  glm::vec3 place{0};       // m, on the rails there
};

// Returns the folds of the line `height` metres above the curve along `up`, in track order; none for height 0. About
// 10 us per segment, more where it nearly folds.
std::vector<Fold> folds_of(const DerivedTrack& derived, double height);

// Returns "at 12.3 m, where the curve's radius of 0.80 m is below the height of 1.10 m".
std::string fold_text(const Fold& fold, double height);

// Returns the folds of a segment's rails, m along it.
std::vector<Fold> rail_folds(const SegmentShape& shape);

// The folds of the rails, or what else is found segment by segment, cached: update() checks only segments with a new
// shape_build, and nothing if there are none.
class Folds {
 public:
  using Find = std::vector<Fold>(const SegmentShape&);
  explicit Folds(Find* find = rail_folds) : find_(find) {}
  const std::vector<Fold>& update(const DerivedTrack& derived);

 private:
  struct Entry {
    std::uint64_t build = 0;
    std::vector<Fold> found;  // m along the segment
  };
  Find* find_;
  std::vector<Entry> entries_;    // by index in the order
  std::set<std::size_t> folded_;  // indices of those with folds
  std::vector<Fold> all_;
  std::uint64_t last_build_ = 0;
  std::vector<world::Entity> order_;
};

inline constexpr double kLeastRadius = 0.5;  // m: tighter bends are marked

// A bend at its tightest place; radius 0: the direction reverses there. From `from` to `to` it stays as tight, as far
// as that reaches an end of a segment: so bends on both sides of a joint are one.
using TightBend = Fold;

// Returns the tight bends of a segment, m along it, and of a track, in order: all of them, to rounding
// (curve/tight_places.h). About 0.1 us for a gentle segment.
std::vector<TightBend> tight_bends_of(const SegmentShape& shape);
std::vector<TightBend> tight_bends_of(const DerivedTrack& derived);

// Returns the first one with the least radius, of one or more.
const TightBend& tightest(std::span<const TightBend> bends);

// Returns "2 tight bends: the direction reverses at 5.3 m", the tightest one.
std::string tight_text(std::span<const TightBend> bends);

// Returns the least radius of the curve, m; infinite for straights and an empty track.
double least_radius(const DerivedTrack& derived);

}  // namespace coaster::sim
