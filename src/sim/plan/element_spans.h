// The spans between selected points of an element's ideal curve, and their errors. For element_fit.cpp;
// force_fit.cpp uses parts of it.
#pragma once

#include <span>
#include <vector>

#include "sim/plan/element_fit.h"

namespace coaster::sim {

struct SpanCheck {
  double error = 0;       // m
  double roll_error = 0;  // rad
  double roll = 0;        // rad, of the second knot's `up` relative to the frame there
  bool sound = true;      // sensible handle lengths and less than half a turn of roll
  bool slopes = true;     // slopes of roll and curvature at both ends are within ElementPoint::slope_error
};

struct Spans {
  std::vector<world::Knot> knots;
  std::vector<double> jumps;    // 1/m, one per knot; at the ends relative to the required curvature
  std::vector<double> strains;  // the jumps as multiples of the largest that is G2 (curve/continuity.h)
};

// `at`: ascending indices into curve.points, including the first and the last. The second knot and the last but one
// move sideways by at most `most_shift` m, which removes the errors of curvature at the ends.
inline constexpr double kMostShift = 0.5 * kElementDistance;
Spans make_spans(const ElementCurve& curve, std::span<const std::size_t> at, double most_shift = kMostShift);

// The position on a span next to a point of the curve: its parameter, and its rotation-minimising frame from the first
// knot.
struct SpanPlace {
  double t = 0;
  curve::Frame frame;
};

// Checks the span between two neighbouring knots against the points between them. `places` gets one entry per point.
SpanCheck check_span(std::span<const ElementPoint> points, const world::Knot& from, const world::Knot& to,
                     std::vector<SpanPlace>* places = nullptr);

}  // namespace coaster::sim
