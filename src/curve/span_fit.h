// Fits cubic spans to a path that is known at some of its points: handles that match the path's curvature, and tangents
// that make the joints G2. The caller selects the points; it measures the spans' distance from the path and adds points
// where that is too large.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

// A point of the path.
struct PathPoint {
  double s = 0;                 // m, arc length from any origin, ascending along the path
  glm::dvec3 position{0};       // m
  glm::dvec3 tangent{1, 0, 0};  // unit
  glm::dvec3 curvature{0};      // 1/m, derivative of the tangent by length: towards the centre
};

struct HandleLengths {
  double out = 0, in = 0;  // m
};

// Returns the handle lengths of the span between two points that match the path's curvature at both within the plane of
// the bend: two quadratic equations, by Gauss-Newton (de Boor, Höllig, Sabin 1987, doi 10.1016/0167-8396(87)90002-1).
// For plane paths without inflections the distance from the path falls with the sixth power of the span's length. A
// third of the length where curvature does not determine them, as on a straight. Always between 1/15 of the length and
// the length; at most 16 steps. Uses only + - * / and sqrt: the same bits everywhere.
HandleLengths handle_lengths(const PathPoint& from, const PathPoint& to);

// The knots of spans in double precision.
struct SpanKnots {
  std::vector<glm::dvec3> place, tangent;  // m, unit
  std::vector<double> out, in;             // m, by knot: the handle after it and the one before it; 0 at the ends
};

// Returns a knot per point, at least 2, with the points' tangents and handle_lengths(). Joints are G1; for a plane path
// also G2.
SpanKnots span_nodes(std::span<const PathPoint> points);

// Turns the inner tangents by one Newton step towards joints with one curvature, which torsion prevents without.
// Returns the largest jump of the curvature vector before the step, 1/m. Converges quadratically: a few steps from
// span_nodes() reach 1e-11, and further steps do no harm. Linear time: the system is block-tridiagonal. Turning a
// tangent changes the jump at its own knot four times as much as at its neighbours', so elimination needs no pivots.
double turn_tangents(SpanKnots& nodes);

// Returns span k, between knots k and k + 1; control points are rounded to float.
Cubic span_cubic(const SpanKnots& nodes, std::size_t k);

}  // namespace coaster::curve
