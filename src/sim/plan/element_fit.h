// Fits cubic Bézier spans to the ideal curve of an element: as few as stay within the tolerances, with continuous
// curvature at every joint (G2). Force sections judge the same spans by what riders feel (force_fit.cpp).
#pragma once

#include <span>
#include <vector>

#include "sim/plan/element_path.h"
#include "world/document.h"

namespace coaster::sim {

// Tolerances of a fit, where float coordinates are fine enough (to 2 km from the origin): distance from the ideal
// curve, angle between the up vectors, and jump of the curvature vector at joints, which is
// also at most 0.6 of what is G2 (curve/continuity.h): being carried rounds knots again. At the last knot it is less,
// so that the next element finds a straight end (kStraightEnd).
inline constexpr double kElementDistance = 0.01;  // m
inline constexpr double kElementRoll_deg = 1.0;
inline constexpr double kElementJump = 2e-4, kElementEnd = 3e-5;  // 1/m

struct ElementFit {
  // From the start of the curve to its end: one more than the number of spans. The first has the start's position and
  // tangent, and an outgoing length; the last ends straight. Joints are aligned (G1 by construction, G2 by their
  // shape). No segment needs whole turns of roll.
  std::vector<world::Knot> knots;
  double error = 0;       // m, the largest distance of the ideal curve's points from the spans
  double roll_error = 0;  // rad, the largest angle about the tangent between the spans' frames and the ideal curve's up
  // 1/m, the largest jump of curvature at joints; at the start relative to the ideal curve, at the end to a straight.
  double jump = 0;
  bool within = false;  // all three are within the tolerances, to float accuracy
};

// Fits spans to the ideal curve. Knots lie on it, at the ends of its pieces and evenly between them; then those that
// are not needed are removed. Each span gets the handle lengths that match the curve's curvature at both ends within
// the plane of the bend: two quadratic equations, by Gauss-Newton (de Boor, Hollig, Sabin 1987, "High accuracy
// geometric Hermite interpolation", doi 10.1016/0167-8396(87)90002-1: sixth order for plane curves). The jump of
// curvature that torsion leaves at the joints is removed by turning the inner tangents: a block-tridiagonal Newton
// iteration. Needs at least 2 points. Takes a few ms; the same bits everywhere.
ElementFit fit_element(const ElementCurve& curve);
// Does the same, but first tries one span for each of the lengths, m, of which the longest absorbs the difference from
// the curve's length, and halves spans beyond the tolerances, up to twice. If that suffices, it takes a millisecond.
ElementFit fit_element(const ElementCurve& curve, std::span<const double> lengths);

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
