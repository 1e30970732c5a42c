// The level of detail of derived data, which bounds their memory on tracks far longer than any that was built. It is
// the finest on tracks of up to 300 km and 1,000 segments.
#pragma once

#include <string>

#include "sim/shape/derived.h"

namespace coaster::sim {

inline constexpr double kMaxDetailedLength = 300'000;  // m of track with ties, equipment and supports
inline constexpr int kMaxRings = 400;                  // per segment, of its solids
inline constexpr std::size_t kMaxAllRings = 400'000;   // for all segments: 0.5 GB of solids
inline constexpr double kTableStep = 0.25;             // m, largest distance of two entries of a rail table
inline constexpr double kMaxTableEntries = 2'000'000;  // for all segments: 0.1 GB

// Changes in few steps, so that an edit seldom changes it: a change rebuilds every segment.
struct Detail {
  int most_rings = kMaxRings;      // per segment; 0: no solids, only the curve
  bool parts = true;               // ties, equipment, supports
  double table_step = kTableStep;  // m
  friend bool operator==(const Detail&, const Detail&) = default;
};
Detail detail_of(const Derived& derived);

// Returns what is coarse, for a notice; empty if nothing is.
std::string detail_text(const Detail& detail);

}  // namespace coaster::sim
