// The spans between chosen points of an element's ideal curve, and their errors. For element_fit.cpp; switch_curve.cpp
// takes the handle lengths.
#pragma once

#include <span>
#include <vector>

#include "sim/plan/element_fit.h"

namespace coaster::sim {

struct SpanCheck {
  double error = 0;       // m
  double roll_error = 0;  // rad
  bool sound = true;      // sensible handle lengths and less than half a turn of roll
};

struct Spans {
  std::vector<world::Knot> knots;
  std::vector<double> jumps;  // 1/m, one per knot; at the ends relative to the required curvature
};

// `at`: ascending indices into curve.points, including the first and the last.
Spans make_spans(const ElementCurve& curve, std::span<const std::size_t> at);

// Checks the span between two neighbouring knots against the points between them.
SpanCheck check_span(std::span<const ElementPoint> points, const world::Knot& from, const world::Knot& to);

// The handle lengths of one span, see element_fit.h; a third of the length if curvature does not determine them.
struct HandleLengths {
  double out = 0, in = 0;  // m
};
HandleLengths handle_lengths(const ElementPoint& from, const ElementPoint& to);

}  // namespace coaster::sim
