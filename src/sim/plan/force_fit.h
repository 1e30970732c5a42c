// Fits Bezier spans to the path of a force section: as few as keep what riders feel within the program's tolerance.
#pragma once

#include "sim/plan/element_fit.h"
#include "sim/plan/force_path.h"

namespace coaster::sim {

struct ForceFit {
  ElementFit spans;
  double felt_error = 0;  // g, the largest difference between what is felt on the spans and the program
  double felt_at = 0;     // m from the section's start, position of that difference
  bool within = false;    // felt_error is within the tolerance, and the spans are within those of every element
};

// Fits spans to the path. Each is as long as its distance from the path, its roll and what is felt on it stay within
// the tolerances. Then the joints are made G2 as for elements (element_fit.h), and spans that no longer do are halved.
// Takes about 20 us per metre; the same bits everywhere.
ForceFit fit_force(const ForceTask& task, const ForcePath& path);

// Returns the largest difference in g, vertical or lateral, between what riders feel on the span between two knots and
// the program at the path's points `first` to `last` next to it; a huge one if the span does not follow the path.
struct FeltError {
  double error = 0;
  std::size_t at = 0;  // index of the point
};
FeltError felt_error(const ForceTask& task, const ForcePath& path, std::size_t first, std::size_t last,
                     const world::Knot& from, const world::Knot& to);

}  // namespace coaster::sim
