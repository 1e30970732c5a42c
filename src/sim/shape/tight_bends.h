// Tight bends: places where the curve of the knots bends with a radius that no train takes, or reverses its direction.
#pragma once

#include "sim/shape/folds.h"

namespace coaster::sim {

inline constexpr double kLeastRadius = 0.5;  // m: tighter bends are marked

// A bend at its tightest place; radius 0: the direction reverses there. From `from` to `to` it stays as tight, as far
// as that reaches an end of a segment: so bends on both sides of a joint are one.
using TightBend = Fold;

// Returns the tight bends of a segment, m along it, and of a track, in order: all of them, to rounding
// (curve/tight_places.h). About 0.1 us for a gentle segment.
std::vector<TightBend> tight_bends_of(const SegmentShape& shape);
std::vector<TightBend> tight_bends_of(const Derived& derived);

// Returns the first one with the least radius, of one or more.
const TightBend& tightest(std::span<const TightBend> bends);

// Returns "2 tight bends: the direction reverses at 5.3 m", the tightest one.
std::string tight_text(std::span<const TightBend> bends);

// Returns the least radius of the curve, m; infinite for straights and an empty track.
double least_radius(const Derived& derived);

}  // namespace coaster::sim
