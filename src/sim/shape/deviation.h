// The errors of a polyline: rounding, and the distance of its chords from the curve.
#pragma once

#include <span>

#include "curve/cubic.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

// Returns the largest distance (m) of a vertex of a polyline from the exact point at the same parameter; the parameters
// are uniform.
double deviation_of(const curve::Cubic& cubic, std::span<const glm::vec3> points);

// Returns the chord error (m) of a polyline with `steps` equal steps of the parameter: the largest distance of the
// curve from its chords, measured in the middle of at most 16 of them.
double chord_error(const curve::Cubic& cubic, int steps);
// Returns the largest chord error of all segments. About 1 us a segment.
double chord_error(const Derived& derived);

}  // namespace coaster::sim
