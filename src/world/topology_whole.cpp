// Changes of the whole track: its direction of travel, and closing by merging the ends.
#include <algorithm>

#include "world/topology.h"

namespace coaster::world {

void reverse(Document& document) {
  Track& track = document.track;
  for (const Entity e : track.knots) {
    Knot& knot = document.entities.get<Knot>(e);
    knot.tangent = -knot.tangent;
    std::swap(knot.in_length, knot.out_length);
  }
  for (const Entity e : track.segments) {
    Segment& segment = document.entities.get<Segment>(e);
    std::swap(segment.from, segment.to);
  }
  // A closed track still begins at its first knot.
  std::reverse(track.knots.begin() + (track.closed ? 1 : 0), track.knots.end());
  std::reverse(track.segments.begin(), track.segments.end());
}

bool weld_ends(Document& document) {
  Track& track = document.track;
  if (track.closed || track.knots.size() < 3) return false;
  const Entity first = track.knots.front(), last = track.knots.back();
  Knot& joint = document.entities.get<Knot>(first);
  joint.in_length = knot(document, last).in_length;
  if (joint.in_length != joint.out_length || joint.joint == JointKind::automatic) joint.joint = JointKind::aligned;
  document.entities.get<Segment>(track.segments.back()).to = first;
  document.entities.destroy(last);
  track.knots.pop_back();
  track.closed = true;
  return true;
}

}  // namespace coaster::world
