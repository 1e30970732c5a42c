// Places where track, or a planned line, lacks clearance or is under water (sim/solids/conflicts.h).
#pragma once

#include <span>

#include <glm/glm.hpp>

namespace coaster::sim {

// Two stretches that are too close to each other over their whole length.
struct Conflict {
  double at = 0, other = 0;             // m along the track, at < other: the narrowest point
  double from = 0, to = 0;              // m along the track, start and end of the first stretch
  double other_from = 0, other_to = 0;  // m, the same for the other stretch
  double missing = 0;  // m of clearance missing there, above 0, at most the radii of a train and of track (CoasterForm)
  glm::vec3 at_place{0}, other_place{0};  // m, on the rails' centre line
  friend bool operator==(const Conflict&, const Conflict&) = default;
};

// A part of a planned line that is too close to track or to an earlier part of the line.
struct LineConflict {
  double from = 0, to = 0;  // m along the line
  double missing = 0;       // m, as in a conflict
  double other = -1;        // m along the track, narrowest position; below 0: an earlier part of the line
};

// A stretch whose rails are under the water of a land. Where it passes the start of a closed track it is two.
struct FloodedTrack {
  double from = 0, to = 0;  // m along the track, within 1.5 m
  double depth = 0;         // m, the largest
  glm::vec3 place{0};       // m, of the rails there
  friend bool operator==(const FloodedTrack&, const FloodedTrack&) = default;
};

// Returns the largest missing clearance, m; 0 if there is none.
double worst(std::span<const LineConflict> parts);

}  // namespace coaster::sim
