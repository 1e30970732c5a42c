// The clearance envelope of trains, swept along the rails, and the test whether a straight bar stays outside it. Uses
// the track's hierarchy of boxes; the curve between rings counts as its chord, with an error of kSagitta.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/derived_track.h"
#include "sim/solids/coaster_form.h"

namespace coaster::sim {

// The envelope in general is the form's `envelope`; within kHeldReach along the rails of the bar's own support it is
// its `riders`, and the rails with the wheels on them.
inline constexpr double kHeldReach = 4.0;   // m
inline constexpr double kBarMargin = 0.03;  // m added to all of these, for the error of chords

struct Bar {
  glm::vec3 from{0}, to{0};              // m
  float from_radius = 0, to_radius = 0;  // m
  bool grounded = false;                 // ends in a footing at `to`
  friend bool operator==(const Bar&, const Bar&) = default;
};

// The data of one segment for clearance.
struct SegmentClearance {
  std::vector<Ring> rings;  // as rings_of()
  curve::Box box;           // about the rails
};

// Returns true if the bar stays outside the clearance envelope; `held` is the position whose support it belongs to.
// `lanes` has one entry per segment of derived.order, which is null for track that is certainly far. Costs the
// logarithm of the segments plus about a microsecond for each one near the bar.
bool is_clear(const DerivedTrack& derived, std::span<const SegmentClearance* const> lanes, const Bar& bar,
              TrackPlace held);

// Returns the smallest distance of two line segments, m. Points are segments of zero length.
double distance_between(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d);

bool meet(const curve::Box& a, const curve::Box& b);
curve::Box widened(curve::Box box, float by);

}  // namespace coaster::sim
