// What rounding does to a polyline: each vertex against the exact point at the same t. A picture magnifies it, a plot
// draws its size.
#pragma once

#include <vector>

#include "curve/evaluators.h"

namespace coaster::sim {

// vertex - exact, m, of the steps+1 vertices of one segment as the evaluator gives them (a GPU row: as its twin on the
// processor does); exact: de Casteljau in long double at t = i/steps, rounded once to double. Both ends are pinned to
// the control points, so their error is 0: what an evaluator has gathered on its way opens as a seam in the last step.
// steps: 1..4096. About 0.1 us a vertex.
struct Rounding {
  std::vector<glm::dvec3> exact, error;
};
Rounding rounding(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps);

// Largest |error|, m.
double largest(const Rounding& rounding);
// |error| of the last vertex that is not pinned, m: what the last step jumps by. 0 with one step.
double seam(const Rounding& rounding);

struct ErrorSample {
  double t = 0, mm = 0;  // |vertex - exact| in millimetres
};
// |error| along the segment, steps+1 samples: for a plot. 0 at both ends, and wherever a vertex happens to be exact.
std::vector<ErrorSample> error_profile(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps);

}  // namespace coaster::sim
