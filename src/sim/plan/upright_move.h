// Moves track by a translation and a rotation about the vertical, so that gravity acts on it as before.
#pragma once

#include "base/status.h"
#include "world/document.h"

namespace coaster::sim {

struct UprightMove {
  glm::dvec3 from{0}, to{0};  // m, a point and its new position
  double cos = 1, sin = 0;    // of the angle about +Y, right-handed
  glm::dvec3 direction(glm::dvec3 v) const { return {cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x}; }
  glm::dvec3 point(glm::dvec3 p) const { return to + direction(p - from); }
  // Returns the knot in its new position, rounded once to float.
  world::Knot knot(world::Knot k) const;
};

// Returns the carry that takes one point and heading to another. Headings are the horizontal parts of directions; if
// one of them has none, there is no rotation.
UprightMove move_between(glm::dvec3 from, glm::dvec3 from_heading, glm::dvec3 to, glm::dvec3 to_heading);

// Returns the carry that takes one knot to another. Refused, with what differs at the joint, if their slopes or rolls
// differ by more than float rounding.
base::Result<UprightMove> move_between(const world::Knot& from, const world::Knot& to);

}  // namespace coaster::sim
