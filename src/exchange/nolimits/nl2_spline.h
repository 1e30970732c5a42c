// The curve of a NoLimits 2 element as cubic Béziers: runs of vertices between strict ones are clamped uniform cubic
// B-splines.
#pragma once

#include <array>
#include <optional>
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

inline constexpr double kRationalOff = 0.0005;  // m

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
inline constexpr double kCornerOff = 0.03;    // m, the largest distance of a fillet from the corner it replaces
inline constexpr double kSharpest = 90;       // degrees; sharper corners are rejected
inline constexpr double kTurnedOff = 0.0001;  // m; handles are turned if that moves the curve by no more

struct Corner {
  std::size_t vertex = 0;
  double angle = 0;  // rad between the directions before and after it
  double off = 0;    // m, the largest distance of the fillet from the original curve
};

// Replaces each corner by a fillet, a cubic with the directions of its two ends. It takes at most 45 % of the length of
// either neighbour. On a closed track the joint of the last piece and the first is also checked. Adds the corners to
// `corners`; those sharper than kSharpest are unchanged.
std::vector<SplinePiece> round_corners(const std::vector<SplinePiece>& pieces, bool closed,
                                       std::vector<Corner>& corners);

// Returns the first place where the curve turns by more than kSharpest within kCornerOff on either side, between
// corners: a cusp, or nearly one. Vertices that lead back on one line make cusps.
std::optional<Corner> find_fold(const std::vector<SplinePiece>& pieces, bool closed);

}  // namespace coaster::exchange
