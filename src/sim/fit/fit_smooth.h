// The rolls and curvatures of a smooth track through rows.
#pragma once

#include <span>
#include <vector>

#include "sim/fit/fit_rows.h"

namespace coaster::sim {

// How rows turn about their direction against rotation-minimising frames, per row.
struct RowRolls {
  std::vector<double> spins;   // rad/m
  std::vector<double> slopes;  // rad/m^2: their rate of change, of the spline
  std::vector<double> leans;   // rad: of a smooth roll with these spins against the row
};

// Returns the rolls of the rows. Where steps are shorter than kSpinReach, a smooth roll is the mean of the rows' rolls
// nearby, with weights that fall linearly to 0 within kSpinReach, or within less where that would lean it by over
// kMostLean: rolls may start at once. Where it leans still more, the rows jump: the spin is the median of the rates
// within the reach. Where steps are longer, the smooth roll is the cubic spline through all rows. At open
// ends the spin is that of the polynomial through the four rows there, and goes on changing as before them.
inline constexpr double kSpinReach = 0.6;   // m
inline constexpr double kMostLean = 0.006;  // rad, 0.34 degrees
RowRolls row_rolls(std::span<const FitRow> rows, bool closed);

// Returns the curvature vector at each row, 1/m, perpendicular to its `forward`: that of the spline of degree 5 through
// the positions with their directions whose third derivative is continuous, and 0 at open ends. On each side of a row
// it leads to the nearest row at least kCurvatureReach away, because positions are rounded.
inline constexpr double kCurvatureReach = 1.0;  // m
std::vector<glm::dvec3> row_curvatures(std::span<const FitRow> rows, bool closed);

// Rows with more rows of the smooth track between them where they are far apart.
struct FilledRows {
  std::vector<FitRow> rows;
  std::vector<std::size_t> from;  // per row: the given row that it is, or follows
  bool given(std::size_t i) const { return i == 0 || from[i] != from[i - 1]; }
};

// Divides steps of kLeastFill to kMostFill into equal parts of at most kFillStep. The curve is of degree 5 with
// the positions, directions and curvatures of both rows, the roll the cubic with their spins. A step stays whole where
// that curve would bend more than a fit may: a bend begins or ends within it.
inline constexpr double kFillStep = 2.5;                    // m
inline constexpr double kLeastFill = 3.75, kMostFill = 10;  // m
FilledRows fill_rows(std::span<const FitRow> rows, bool closed);

// s: second differences over this time act as a low-pass of 5 Hz.
inline constexpr double kMoment = 0.064;

}  // namespace coaster::sim
