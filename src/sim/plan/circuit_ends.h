// The leads of a way home: from the open end of the track, and backwards from its first knot, to where the track is
// straight and no steeper than kGentle.
#pragma once

#include <string>
#include <vector>

#include "sim/plan/circuit_turns.h"
#include "sim/plan/element_shapes.h"

namespace coaster::sim {

inline constexpr double kGentle_deg = 32;

// A piece of curve in its own axes, as ElementPath adds it.
struct LeadPiece {
  glm::dvec3 forward, up, left;
  double length;  // m
  ElementPiece rate;
};

struct Lead {
  std::vector<LeadPiece> pieces;
  PlanPose pose;                 // where the pieces end; for the first knot: where they begin, in the train's direction
  double height = 0, slope = 0;  // m; m per metre in plan
  double length = 0;             // m, along the track
  bool steep = false;            // up follows the pieces instead of the felt direction
};

// Returns the pieces after an end: its curvature falls to 0, then a steep end bends to a gentler slope with that
// radius, m. A vertical end bends towards the riders' heads if it points down, away from them if it points up, so that
// the track becomes upright.
Lead lead_from(const TrackEnd& end, double radius);
// Returns the pieces before the first knot, `home`, whose direction is the train's.
Lead lead_to(TrackEnd home, double radius);

void add_lead(const Lead& lead, ElementPath& path);

}  // namespace coaster::sim
