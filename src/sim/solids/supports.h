// What holds the track up, found by itself: columns from the spine to the ground that stay out of the room that trains
// need. Kept by segment and found again where the track near a support's possible places changed; they follow from the
// track as it is alone, however it came to be so.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/shape/derived.h"
#include "sim/solids/clearance.h"

namespace coaster::sim {

inline constexpr double kMinSupportSpacing = 8,
                        kMaxSupportSpacing = 12;  // m that are aimed at; closer where the track is bent or high
inline constexpr int kMostSupports = 400;         // of a segment: of one of many kilometres they stand further apart
inline constexpr double kLowestSupport = 0.5;     // m of the spine's axis over the ground
inline constexpr float kSupportReach = 8;         // m, no foot is further off to the side

// Those of one segment: bars from the spine on, `to` nearer to the ground.
struct SegmentSupports {
  std::vector<Bar> bars;
  std::vector<Ring> holds;  // where the track is held, one for each support
  int places = 0;           // where one was looked for
  std::uint64_t build = 0;  // a fresh number when the bars changed; 0: never any
};

// How many supports a segment asks for: `count` evenly on every `turns`-th segment of its kind. By its own shape alone:
// a change further up the track moves none.
struct SupportRow {
  int count = 0, turns = 1;
  int on(std::size_t index) const { return index % static_cast<std::size_t>(turns) == 0 ? count : 0; }
};
SupportRow support_row(const SegmentShape& shape);

class Supports {
 public:
  // Brings them up to date. Cost while nothing changes: a comparison for each segment. Else the supports of the
  // segments that changed and of those that they came near to or left are found again, about 10 microseconds a support.
  void update(const Derived& derived);

  const SegmentSupports* of(world::Entity segment) const;
  int count() const { return count_; }        // supports
  int rebuilds() const { return rebuilds_; }  // segments whose supports were looked for in the last update
  // Segments as in the last update.
  const std::vector<world::Entity>& order() const { return order_; }

 private:
  struct Entry {
    std::uint64_t shape_build = 0;
    bool stale = true;
    Lane lane;
    curve::Box reach;  // about all places where a bar could stand
    SupportRow row;
    int count = -1;  // asked for at its place in the track
    SegmentSupports found;
  };
  void drop_vanished(const Derived& derived);
  void take_shapes(const Derived& derived);
  void take_turns();
  void mark_disturbed();
  void find_stale(const Derived& derived);

  world::Pool<Entry> entries_;
  std::vector<world::Entity> order_;
  std::vector<curve::Box> moved_;   // where track came to be or was, of the update in progress
  std::vector<const Lane*> lanes_;  // by place in the order
  std::uint64_t last_build_ = 0;
  bool closed_ = false;
  int count_ = 0, rebuilds_ = 0;
};

// Their solids: round bars with a plate and a footing where they stand, a collar about the spine where they hold it.
// Replaces what `mesh` holds.
void build_support_mesh(const SegmentSupports& supports, Mesh& mesh);

}  // namespace coaster::sim
