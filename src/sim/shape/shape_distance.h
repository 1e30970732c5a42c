// Distances between curves: of two tracks, independent of their knots, and of a polyline from its curve.
#pragma once

#include <span>
#include <vector>

#include "curve/cubic.h"
#include "sim/shape/derived_track.h"
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

// --- The errors of a polyline: rounding, and the distance of its chords from the curve

// Returns the largest distance (m) of a vertex of a polyline from the exact point at the same parameter; the parameters
// are uniform.
double deviation_of(const curve::Cubic& cubic, std::span<const glm::vec3> points);

// Returns the chord error (m) of a polyline with `steps` equal steps of the parameter: the largest distance of the
// curve from its chords, each piece of the curve from its own chord as a segment; or `known` if that is larger. Exact
// to 1e-9 of the value, or to rounding, for every cubic. Looks closely only at pieces that may exceed the largest so
// far: about 1 us for 1 to 4096 steps, 0.1 us where `known` is larger.
double chord_error(const curve::Cubic& cubic, int steps, double known = 0);
// Returns the largest chord error of all segments.
double chord_error(const DerivedTrack& derived);

}  // namespace coaster::sim
