// The interpolating cubic spline with continuous first and second derivatives (C2) through given points, with natural,
// clamped or closed ends. After de Boor, A Practical Guide to Splines, 1978, chapter IV.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace coaster::curve {

struct SplinePoints {
  std::span<const glm::dvec3> points;  // n >= 2 (closed: n >= 3), m
  // > 0, parameter steps from each point to the next: n - 1, closed n (the last leads back to the first).
  std::span<const double> steps;
  // dP/du at the ends; if absent, the second derivative is 0 there (natural). Ignored when closed.
  std::optional<glm::dvec3> first, last;
  bool closed = false;
};

// Returns dP/du at each point, n values. Linear time without pivoting: the matrix is diagonally dominant, so errors
// stay at a few ulps. Uses only the four operations: the same bits on every machine.
std::vector<glm::dvec3> spline_derivatives(const SplinePoints& spline);

// Row i of a system of equations: below x[i-1] + middle x[i] + above x[i+1] = right.
struct TridiagonalRow {
  double below = 0, middle = 1, above = 0;
  glm::dvec3 right{0};
};
// Returns the solution x; closed: the first row's `below` belongs to the last x, and the last row's `above` to the
// first. The matrix is diagonally dominant or positive definite; closed ones have at least 2 rows.
std::vector<glm::dvec3> solve_tridiagonal(std::vector<TridiagonalRow> rows, bool closed);

}  // namespace coaster::curve
