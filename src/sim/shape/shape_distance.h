// The distance between the curves of two tracks, independent of their knots.
#pragma once

#include <vector>

#include "world/document.h"

namespace coaster::sim {

// Dense points of a track's centre line, in order; a closed track's last one is its first.
struct ShapeTrace {
  std::vector<glm::dvec3> points;
  friend bool operator==(const ShapeTrace&, const ShapeTrace&) = default;
};
inline constexpr int kTracePoints = 1024;  // maximum and typical number, for tracks of any length

// Returns exact points of the curves at uniform parameters of each segment, at least 8 per segment up to kTracePoints
// segments.
ShapeTrace trace_of(const world::Document& document);

// Returns the larger of both directed Hausdorff distances between the traces as polygons, m. A chord of c m over a
// radius r has an error of c^2 / (8 r): below 1 mm for tracks of 150 m with bends above 5 m. Infinite if only one is
// empty, 0 if both are. Costs O(n^2), about 5 ms for two full traces.
double shape_distance(const ShapeTrace& a, const ShapeTrace& b);

}  // namespace coaster::sim
