// The spans between chosen points of an element's ideal curve, and how well they follow it. Private to element_fit.cpp
// and element_spans.cpp.
#pragma once

#include <span>
#include <vector>

#include "sim/plan/element_fit.h"

namespace coaster::sim {

struct SpanCheck {
  double error = 0;       // m
  double roll_error = 0;  // rad
  bool sound = true;      // handles of a sensible length, less than half a turn of roll
};

struct Spans {
  std::vector<world::Knot> knots;
  std::vector<double> jumps;  // 1/m, one for each knot: the ends against what they should have
};

// `at`: places in curve.points, rising, the first and the last point included.
Spans make_spans(const ElementCurve& curve, std::span<const std::size_t> at);

// The span between two neighbouring knots, which stand for the first and the last of these points.
SpanCheck check_span(std::span<const ElementPoint> points, const world::Knot& from, const world::Knot& to);

// The handle lengths of one span, see element_fit.h; a third of the length where curvature says nothing.
struct HandleLengths {
  double out = 0, in = 0;  // m
};
HandleLengths handle_lengths(const ElementPoint& from, const ElementPoint& to);

}  // namespace coaster::sim
