// How far two tracks' curves are apart, whatever their knots.
#pragma once

#include <vector>

#include "sim/shape/derived.h"

namespace coaster::sim {

// Places of a track's centre line, close together and in order; a closed track's last one is its first.
struct ShapeTrace {
  std::vector<glm::dvec3> points;
  friend bool operator==(const ShapeTrace&, const ShapeTrace&) = default;
};
inline constexpr int kTracePoints = 1024;  // at most, and about, however long the track is

// At uniform parameters of each segment, at least 8 a segment up to kTracePoints segments. Exact points of the curves.
ShapeTrace trace_of(const world::Document& document);

// The larger of both directed Hausdorff distances between the traces as polygons, m: how far any place of one track is
// from the other track. A chord of c m over a radius r errs by c^2 / (8 r): below 1 mm for tracks of 150 m with bends
// above 5 m. Infinite when one is empty and the other is not, 0 for two empty ones. Cost: O(n^2), about 5 ms for two
// full traces.
double shape_distance(const ShapeTrace& a, const ShapeTrace& b);

}  // namespace coaster::sim
