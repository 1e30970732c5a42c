// The room that trains need: an envelope swept along the rails, asked whether a straight bar stays out of it. Found by
// the track's hierarchy of boxes; the curve between rings counts as its chord, which is off by kSagitta.
#pragma once

#include <span>
#include <vector>

#include "sim/shape/derived.h"
#include "sim/solids/mesh.h"

namespace coaster::sim {

// Elsewhere on the track: a tube about a line over the rails, from under the spine to over the riders' heads.
inline constexpr double kEnvelopeRadius = 1.6, kEnvelopeLift = 0.45;  // m
// Where the bar's own support holds the track, within kHeldReach of it along the rails: a tube about the riders, and
// the rails with the wheels on them.
inline constexpr double kHeldReach = 4.0, kRiderRadius = 1.1, kRiderLift = 1.05;  // m
inline constexpr double kBarMargin = 0.03;  // m more than all of these, for the chords

struct Bar {
  glm::vec3 from{0}, to{0};              // m
  float from_radius = 0, to_radius = 0;  // m
  bool grounded = false;                 // stands at `to` on a footing
  friend bool operator==(const Bar&, const Bar&) = default;
};

// One segment as clearance sees it.
struct Lane {
  std::vector<Ring> rings;  // as rings_of()
  curve::Box box;           // about the curve
};

// The place whose support the bar belongs to.
struct Held {
  std::size_t index = 0;  // in derived.order
  double s = 0;           // m within the segment
};

// Whether the bar stays out of the room that trains need. `lanes` has one for each segment of derived.order. Cost:
// logarithmic in the segments plus those near the bar, about a microsecond each.
bool is_clear(const Derived& derived, std::span<const Lane* const> lanes, const Bar& bar, Held held);

// The least distance of two lines between their ends, m. Points are lines without length.
double distance_between(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d);

bool meet(const curve::Box& a, const curve::Box& b);
curve::Box widened(curve::Box box, float by);

}  // namespace coaster::sim
