// Folds: parts of the track where the rails run backwards, because the curve bends towards them with a radius smaller
// than their distance from it. No train can pass there.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "sim/shape/derived.h"

namespace coaster::sim {

struct Fold {
  double from = 0, to = 0;  // m along the track
  double at = 0;            // m along the track, where the curve bends most
  double radius = 0;        // m, radius of the curve there
  glm::vec3 place{0};       // m, on the rails there
};

// Returns the folds of the line `height` metres above the curve along `up`, in track order; none for height 0. About
// 10 us per segment, more where it nearly folds.
std::vector<Fold> folds_of(const Derived& derived, double height);

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
  const std::vector<Fold>& update(const Derived& derived);

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

}  // namespace coaster::sim
