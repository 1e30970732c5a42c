// The level of detail of derived data, which bounds their memory on tracks far longer than any that was built: the
// finest on tracks of up to 300 km and 1,000 segments. Only track near the eye has parts where a track is longer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/shape/derived_track.h"

namespace coaster::sim {

inline constexpr double kMaxDetailedLength = 300'000;  // m of track with ties, equipment and supports
inline constexpr int kMaxRings = 400;                  // per segment, of its solids
inline constexpr std::size_t kMaxAllRings = 400'000;   // for all segments: 0.5 GB of solids
inline constexpr double kTableStep = 0.25;             // m, largest distance of two entries of a rail table
inline constexpr double kMaxTableEntries = 2'000'000;  // for all segments: 0.1 GB

// Changes in few steps, so that an edit seldom changes it: a change rebuilds every segment.
struct SolidsDetail {
  int most_rings = kMaxRings;      // per segment; 0: no solids, only the curve
  bool parts = true;               // ties, equipment, supports
  double table_step = kTableStep;  // m
  friend bool operator==(const SolidsDetail&, const SolidsDetail&) = default;
};
SolidsDetail detail_of(const DerivedTrack& derived);

// Returns what is coarse, for a notice; empty if nothing is.
std::string detail_text(const SolidsDetail& detail);

// A track of at most so many segments and so long (m) has parts everywhere; of any other, so much is near. Chains, the
// largest parts, take 36 MB a km.
inline constexpr std::size_t kMostFitted = 20'000;
inline constexpr double kMaxNearLength = 15'000;
inline constexpr int kNearRings = 20;  // of a near segment, at most, unless all have more

// Where the eye is, and how far from it (m) anyone sees ties, equipment and supports.
struct EyeSurroundings {
  glm::vec3 eye{0};
  float reach = 0;
  friend bool operator==(const EyeSurroundings&, const EyeSurroundings&) = default;
};

// Which segments of a very long track are near the eye: they alone have ties, equipment and supports. A track that is
// not very long has them everywhere.
class NearSegments {
 public:
  void look_from(const EyeSurroundings& around);
  // Finds what is within reach of an eye that moves in steps of 16 m: the reach is shortened by quarters until that is
  // at most kMaxNearLength of track. Costs a comparison if neither track nor eye changed, else some time for each near
  // segment, none for the others.
  void update(const DerivedTrack& derived);

  bool everywhere() const { return everywhere_; }
  // Indices into derived.order, ascending; none if everything is near.
  const std::vector<std::size_t>& indices() const { return indices_; }
  // Returns the detail of near segments, where that of all is `detail`.
  SolidsDetail detail(SolidsDetail detail) const;

 private:
  bool gather(const DerivedTrack& derived, float reach);

  EyeSurroundings around_;
  std::vector<std::size_t> indices_;
  bool everywhere_ = true;
  std::uint64_t build_ = 0;
  bool stale_ = true;
};

}  // namespace coaster::sim
