// Where a track is in its own way: stretches that come nearer to each other than a train on one of them needs. Kept by
// segment, and looked for again where the track changed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/shape/derived.h"

namespace coaster::sim {

// A train needs a tube about a line over the rails, half a metre more than riders and their elbows fill; track fills
// one about a line under them.
inline constexpr double kTrainRadius = 1.5, kTrainLift = 0.45;  // m
inline constexpr double kTrackRadius = 0.78, kTrackDrop = 0.3;  // m
// Places nearer than this along the rails are one stretch, and never in each other's way.
inline constexpr double kSameStretch = 8;   // m
inline constexpr double kConflictStep = 2;  // m of the chords that stand for the curve, longer beyond 1,000 a segment

// Two stretches that are too near to each other all along.
struct Conflict {
  double at = 0, other = 0;             // m along the track, at < other: where it is narrowest
  double from = 0, to = 0;              // m along the track, where the first stretch begins and ends
  double other_from = 0, other_to = 0;  // m, the same of the other
  double missing = 0;  // m of room that a train lacks there, above 0, at most kTrainRadius + kTrackRadius
  glm::vec3 at_place{0}, other_place{0};  // m, on the rails' line
  friend bool operator==(const Conflict&, const Conflict&) = default;
};

// A place of a line that chords join, m; `s` metres along it.
struct LinePoint {
  glm::vec3 position{0}, up{0, 1, 0};
  float s = 0;
};

// A stretch of a line that is no track yet, too near to track or to the line's own earlier part.
struct Narrow {
  double from = 0, to = 0;  // m along the line
  double missing = 0;       // m, as a conflict's
};

// The most that any of them lacks, m; 0 without any.
double worst(std::span<const Narrow> parts);

class Conflicts {
 public:
  // Brings them up to date with the same Derived as before: all conflicts in the track's order. Cost while nothing
  // changed: a comparison for each segment; else some microseconds for each that changed and for what is within
  // kSameStretch of it. Where a great many places are in each other's way, not all are found: no more than kMostHits
  // for each chord of a segment.
  const std::vector<Conflict>& update(const Derived& derived);
  // Where the line would be in the way of the track as last brought up to date, or in its own, if it went on from the
  // track's end, which is open.
  std::vector<Narrow> against(const Derived& derived, std::span<const LinePoint> line) const;
  int looked_at() const { return looked_at_; }  // segments in the last update

 private:
  struct Entry {
    std::uint64_t build = 0;
    std::size_t index = 0;  // in the track
    curve::Box box;         // about the curve
    std::vector<LinePoint> places;
  };
  // Chord `i` of segment a and chord `k` of segment b are too near.
  struct Hit {
    world::Entity a, b;
    std::size_t i = 0, k = 0;
    double missing = 0;
  };
  static constexpr std::size_t kMostHits = 16;
  void take_shapes(const Derived& derived, std::vector<bool>& stale);
  void spread(const Derived& derived, std::vector<bool>& stale) const;
  void look_around(const Derived& derived, std::size_t index, const std::vector<bool>& stale);
  std::size_t look_at(const Derived& derived, world::Entity a, world::Entity b, std::size_t most);
  void gather(const Derived& derived);

  world::Pool<Entry> entries_;
  std::vector<Hit> hits_;
  std::vector<Conflict> found_;
  std::vector<world::Entity> order_;
  std::uint64_t last_build_ = 0;
  bool closed_ = false;
  int looked_at_ = 0;
};

}  // namespace coaster::sim
