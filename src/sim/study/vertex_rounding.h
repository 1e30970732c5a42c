// Rounding errors of a polyline: each vertex against the exact point at the same t. A picture magnifies them, a plot
// shows their size.
#pragma once

#include <vector>

#include "curve/evaluators.h"

namespace coaster::sim {

// vertex - exact, m, of the steps+1 vertices of one segment as the evaluator computes them (a GPU row: its processor
// twin); exact: de Casteljau in long double at t = i/steps, rounded once to double. Both ends are pinned to the control
// points, so their error is 0, and the accumulated error appears as a seam in the last step. steps: 1..4096. Takes
// about 0.1 us per vertex.
struct Rounding {
  std::vector<glm::dvec3> exact, error;
};
Rounding rounding(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps);

// Returns the largest |error|, m.
double largest(const Rounding& rounding);
// Returns |error| of the last vertex that is not pinned, m: the jump of the last step. 0 with one step.
double seam(const Rounding& rounding);

struct ErrorSample {
  double t = 0, mm = 0;  // |vertex - exact| in millimetres
};
// Returns |error| along the segment, steps+1 samples, for a plot. 0 at both ends, and wherever a vertex is exact.
std::vector<ErrorSample> error_profile(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps);

}  // namespace coaster::sim
