// Supports of the track, built automatically: columns from the spine to the ground, or bents of timber, which stay
// outside the clearance envelope of trains. Cached per segment and recomputed where the track or the ground near a
// support's possible positions changed. They depend only on the present track and ground, not on their history.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/ground/ground.h"
#include "sim/shape/detail_limits.h"
#include "sim/solids/clearance.h"

namespace coaster::sim {

inline constexpr double kMinSupportSpacing = 8,
                        kMaxSupportSpacing = 12;  // m, target of columns; closer where the track is curved or high
inline constexpr double kBentSpacing = 3;         // m, target of bents
inline constexpr int kMostSupports = 400;         // per segment: on very long segments the spacing is larger
inline constexpr double kLowestSupport = 0.5;     // m of the spine's axis above the ground
inline constexpr float kSupportReach = 8;         // m, largest sideways distance of a foot

// A square beam of a bent: a ledger, a brace or a ribbon.
struct Brace {
  glm::vec3 from{0}, to{0};  // m
  float half = 0;            // m, of its side
  bool from_afar = false;
  friend bool operator==(const Brace&, const Brace&) = default;
};

// The supports of one segment: bars from the spine on, `to` nearer to the ground.
struct SegmentSupports {
  SupportForm form{};
  std::vector<Bar> bars;      // columns, arms and struts, or the legs of bents
  std::vector<Brace> braces;  // of bents
  std::vector<Ring> holds;    // where the track is held, one per support
  int places = 0;             // positions tried
  std::uint64_t build = 0;    // a new number when the bars change; 0: never any
};

// The number of supports of a segment: `count`, evenly spaced, on every `every`-th segment of its kind. Depends only on
// the segment's shape: a change elsewhere moves none.
struct SupportSpacing {
  int count = 0, every = 1;
  int on(std::size_t index) const { return index % static_cast<std::size_t>(every) == 0 ? count : 0; }
};
SupportSpacing spacing_of(const SegmentShape& shape);

class Supports {
 public:
  // Updates the supports of near segments, and forgets the others; of all without `near`. If nothing changed, costs one
  // comparison per segment near them. Else recomputes the supports of changed segments and of those that they came near
  // to or left, about 10 microseconds per support. They stand on `ground` as it is cut to this track, piles on the bed
  // of a lake; none are in tunnels, or where the spine is less than kLowestSupport above the ground. Null: on the plane
  // y = 0.
  void update(const DerivedTrack& derived, const NearSegments& near = {}, const Ground* ground = nullptr);

  // Returns those of a near segment.
  const SegmentSupports* of(world::Entity segment) const;
  int count() const { return count_; }        // supports of near segments
  int rebuilds() const { return rebuilds_; }  // segments whose supports were recomputed in the last update
  // Segments as of the last update, in the track's order: the near ones, and those that their supports could meet.
  const std::vector<world::Entity>& order() const { return order_; }

 private:
  struct Entry {
    std::uint64_t shape_build = 0, stamp = 0;  // stamp: of the last update
    std::uint64_t ground = 0;                  // build of the ground under `reach`
    bool stale = true;
    SegmentClearance lane;
    curve::Box reach;  // contains all possible positions of bars
    SupportSpacing spacing;
    int count = -1;  // number wanted at its index in the track
    SegmentSupports found;
  };
  bool gather(const DerivedTrack& derived, const NearSegments& near);
  void take_shapes(const DerivedTrack& derived);
  void drop_others(const DerivedTrack& derived);
  void forget_far();
  void take_turns();
  bool take_ground(const Ground* ground);
  bool in_tunnel(double distance) const;
  void mark_disturbed();
  void find_if_stale(const DerivedTrack& derived, std::size_t index);
  SegmentSupports find_columns(const DerivedTrack& derived, std::size_t index, int count) const;
  SegmentSupports find_bents(const DerivedTrack& derived, std::size_t index, SupportSpacing spacing, int count) const;

  world::Pool<Entry> entries_;
  std::vector<world::Entity> order_;
  std::vector<std::size_t> places_;  // their indices in the track
  std::vector<std::size_t> near_;    // those that are near; none if all are
  std::vector<curve::Box> moved_;    // present and former boxes of moved track, in the current update
  std::vector<const SegmentClearance*>
      lanes_;  // by index in the track, in the current update; empty until one is needed
  static constexpr std::uint64_t kUnknown = UINT64_MAX;
  const Ground* ground_ = nullptr;                        // during an update; null: the plane
  std::uint64_t last_build_ = 0, build_ = 0, stamp_ = 0;  // build_: of the track
  std::uint64_t ground_build_ = 0;
  SolidsDetail detail_;  // without parts there are no supports
  bool closed_ = false;
  int count_ = 0, rebuilds_ = 0;
};

// Builds their solids: round bars with a plate and a footing on the ground, and a collar around the spine; square
// timber for bents. Replaces the contents of `mesh`.
void build_support_mesh(const SegmentSupports& supports, const CoasterForm& form, Mesh& mesh);

}  // namespace coaster::sim
