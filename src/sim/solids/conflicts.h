// Conflicts: parts of a track that are closer to each other than a train on one of them requires. Cached per segment,
// and recomputed where the track changed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/ground/ground.h"
#include "sim/shape/derived_track.h"
#include "sim/solids/conflict_types.h"

namespace coaster::sim {

// A train needs the tube `train` of its kind's form, and track fills the tube `track`.
// Positions closer than this along the rails belong to one part of the track and never conflict.
inline constexpr double kSameStretch = 8;   // m
inline constexpr double kConflictStep = 2;  // m, length of the chords of the curve; longer beyond 1,000 per segment

// A point of the rails, m; `s` metres along the curve.
struct LinePoint {
  glm::vec3 position{0}, up{0, 1, 0};
  float s = 0;
};

// The conditions for a planned line: the track that it continues, and the required margin.
struct LineConditions {
  bool comes_home = false;  // it ends at the track's first knot
  double margin = 0;        // m of additional clearance
};

class Conflicts {
 public:
  // Segments that a picture checks at most; about 5 ms.
  static constexpr std::size_t kSlice = 1000;

  // Updates the conflicts from the same DerivedTrack as before and returns all of them in track order. If nothing
  // changed, it costs a comparison of the orders; else a few microseconds for each changed segment and those within
  // kSameStretch of it. On tracks with very many conflicts not all are found: at most kMostHits per chord of a segment.
  const std::vector<Conflict>& update(const DerivedTrack& derived) { return update(derived, derived.order.size()); }
  // The same, but checks at most `most` segments: returns the conflicts found so far, and later calls find the others.
  const std::vector<Conflict>& update(const DerivedTrack& derived, std::size_t most);
  // True if the last update found all.
  bool is_complete() const { return next_ == waiting_.size(); }
  // Returns where the line of rails would conflict with the track as of the last update, or with itself, if it
  // continued the track's open end.
  std::vector<LineConflict> against(const DerivedTrack& derived, std::span<const LinePoint> line,
                                    const LineConditions& terms = {}) const;
  int looked_at() const { return looked_at_; }  // segments checked in the last update

 private:
  struct Entry {
    std::uint64_t build = 0;
    std::size_t index = 0;  // index in the track
    curve::Box box;         // of the rails
    std::vector<LinePoint> places;
    double longest = 0;  // m, of the chords between them
    void take(const SegmentShape& shape);
  };
  // Chord `i` of segment a and chord `k` of segment b are too close.
  struct Hit {
    world::Entity a, b;
    std::size_t i = 0, k = 0;
    double missing = 0;
  };
  static constexpr std::size_t kMostHits = 16;
  void take_changes(const DerivedTrack& derived);
  std::vector<std::size_t> take_order(const DerivedTrack& derived);
  void wait_for(std::size_t index);
  void spread(const DerivedTrack& derived, std::span<const std::size_t> changed);
  const Entry& entry(const DerivedTrack& derived, std::size_t index);
  void look_around(const DerivedTrack& derived, std::size_t index);
  std::size_t look_at(const DerivedTrack& derived, world::Entity a, world::Entity b, std::size_t most);
  void gather(const DerivedTrack& derived);

  world::Pool<Entry> entries_;
  std::vector<Hit> hits_;
  std::vector<Conflict> found_;
  std::vector<world::Entity> order_;
  std::vector<bool> stale_;           // segments of this search, including those already checked
  std::vector<std::size_t> waiting_;  // their indices, ascending; those from next_ on are not checked yet
  std::size_t next_ = 0;
  std::uint64_t last_build_ = 0;
  int looked_at_ = 0;
};

// --- Track under water: a warning, as track that is too close to other track is

// Returns the stretches of track under the water of a land, in the track's order. Track in a tunnel below a lake is
// dry, and so is all without a land; an open cut below the water's level is flooded.
std::vector<FloodedTrack> flooded_track(const Ground& ground);

}  // namespace coaster::sim
