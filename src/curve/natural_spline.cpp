// Cubic splines by their first derivatives: one tridiagonal system with three right-hand sides.
#include "curve/natural_spline.h"

#include "base/check.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

// Continuity of the second derivative at a point between steps `before` and `after`, with the chords' slopes.
TridiagonalRow inner_row(double before, double after, dvec3 slope_before, dvec3 slope_after) {
  return {after, 2 * (before + after), before, 3.0 * (after * slope_before + before * slope_after)};
}

// Thomas' algorithm; T is the type of the unknowns.
template <class T>
std::vector<T> solve(const std::vector<TridiagonalRow>& rows, std::vector<T> right) {
  const std::size_t n = rows.size();
  std::vector<double> above(n);
  double middle = rows[0].middle;
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) {
      middle = rows[i].middle - rows[i].below * above[i - 1];
      right[i] -= rows[i].below * right[i - 1];
    }
    above[i] = rows[i].above / middle;
    right[i] = right[i] / middle;
  }
  for (std::size_t i = n - 1; i-- > 0;) right[i] -= above[i] * right[i + 1];
  return right;
}

std::vector<dvec3> solve_open(const std::vector<TridiagonalRow>& rows) {
  std::vector<dvec3> right;
  right.reserve(rows.size());
  for (const TridiagonalRow& row : rows) right.push_back(row.right);
  return solve(rows, std::move(right));
}

}  // namespace

// The two corners of the closed system are a rank-one correction (Sherman and Morrison, 1950).
std::vector<dvec3> solve_tridiagonal(std::vector<TridiagonalRow> rows, bool closed) {
  if (!closed) return solve_open(rows);
  const std::size_t n = rows.size();
  const double first_corner = rows[0].below, last_corner = rows[n - 1].above, gamma = -rows[0].middle;
  rows[0].middle -= gamma;
  rows[n - 1].middle -= first_corner * last_corner / gamma;
  std::vector<double> corner(n, 0.0);
  corner[0] = gamma, corner[n - 1] = last_corner;
  const std::vector<double> z = solve(rows, std::move(corner));
  std::vector<dvec3> x = solve_open(rows);
  const dvec3 factor = (x[0] + first_corner / gamma * x[n - 1]) / (1 + z[0] + first_corner / gamma * z[n - 1]);
  for (std::size_t i = 0; i < n; ++i) x[i] -= factor * z[i];
  return x;
}

std::vector<dvec3> spline_derivatives(const SplinePoints& spline) {
  const std::size_t n = spline.points.size();
  COASTER_CHECK(n >= (spline.closed ? 3u : 2u) && spline.steps.size() == (spline.closed ? n : n - 1),
                "a spline has one step between each two points");
  const auto step = [&](std::size_t i) { return spline.steps[i]; };
  const auto slope = [&](std::size_t i) { return (spline.points[(i + 1) % n] - spline.points[i]) / step(i); };
  const auto before = [n](std::size_t i) { return (i + n - 1) % n; };
  std::vector<TridiagonalRow> rows(n);
  for (std::size_t i = spline.closed ? 0 : 1; i + (spline.closed ? 0 : 1) < n; ++i)
    rows[i] = inner_row(step(before(i)), step(i), slope(before(i)), slope(i));
  if (spline.closed) return solve_tridiagonal(std::move(rows), true);
  rows[0] = spline.first ? TridiagonalRow{0, 1, 0, *spline.first} : TridiagonalRow{0, 2, 1, 3.0 * slope(0)};
  rows[n - 1] = spline.last ? TridiagonalRow{0, 1, 0, *spline.last} : TridiagonalRow{1, 2, 0, 3.0 * slope(n - 2)};
  return solve_open(rows);
}

}  // namespace coaster::curve
