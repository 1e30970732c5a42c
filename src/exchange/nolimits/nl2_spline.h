// The curve of a NoLimits 2 element as cubic Béziers: runs of vertices between strict ones are clamped uniform cubic
// B-splines.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "curve/cubic.h"
#include "sim/shape/derived.h"

namespace coaster::exchange {

struct SplineVertex {
  glm::dvec3 position{0};  // m
  bool strict = false;     // ends a run of vertices: the curve passes through it
  double weight = 1;       // > 0; of a rational B-spline
};

using Bezier = std::array<glm::dvec3, 4>;  // control points, m

glm::dvec3 point(const Bezier& b, double t);
glm::dvec3 slope(const Bezier& b, double t);  // the derivative
// Returns the part between two parameters, 0 <= from < to <= 1. An end that is not cut stays exactly the same.
Bezier part(const Bezier& b, double from, double to);
// Return the unit direction of travel at the start and at the end; zero if the control points are within 0.1 mm.
glm::dvec3 start_direction(const Bezier& b);
glm::dvec3 end_direction(const Bezier& b);
// Returns the curve as a cubic of the document, rounded to float.
curve::Cubic in_float(const Bezier& b);

struct SplinePiece {
  Bezier curve;
  std::size_t vertex = 0;  // the vertex at or near the start, for messages
  double off = 0;          // m, from the rational curve
};

using RationalBezier = std::array<glm::dvec4, 4>;  // control points times their weights (m), and the weights (> 0)
inline constexpr double kRationalOff = 0.0005;     // m

// Appends cubics within kRationalOff of a rational one, halved until they are (nl2_rational.cpp). They have its points
// and directions at their ends and, where possible, its curvature within its plane there, which makes plane joints G2.
void append_cubics(const RationalBezier& rational, std::size_t vertex, std::vector<SplinePiece>& pieces);

// Returns the curve in the order of travel, exact to rounding in double, or within kRationalOff where
// the weights of a run differ. A run of vertices goes from one strict vertex
// to the next; the first and the last vertex always end one. A run of n vertices is a uniform B-spline of degree
// min(3, n - 1) with clamped ends: two vertices are a straight line, three a parabola, four a Bézier. Needs 2 vertices.
std::vector<SplinePiece> spline_pieces(std::span<const SplineVertex> vertices);

// The rails at a distance along the track, for both NoLimits 2 formats.
struct PlaceOnTrack {
  glm::dvec3 position;
  curve::Frame frame;
};
PlaceOnTrack place_on(const sim::Derived& derived, double distance);

}  // namespace coaster::exchange
