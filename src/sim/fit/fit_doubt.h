// What riders may feel more or less on a fitted track than on the one that its rows were taken from, decided from the
// rows alone.
#pragma once

#include <span>
#include <vector>

#include "sim/fit/fit_smooth.h"

namespace coaster::sim {

// The functions return for each row what riders may feel more or less there, g, because track between the rows may
// differ from the smooth one through them. They take the squared speeds over g (row_speeds).

// Because the roll changes within a few rows, for riders `heartline` m above the rails: four times the first term of
// the error of the smooth roll's second derivative, h^2 / 12 of its fourth, because later terms can be larger. The
// error changes its sign within a step, so it counts as after a low-pass of 5 Hz at one wave in 2 steps, or in 3 where
// these are shorter than kMoment of the ride. At an open end, where a ride's first moment is felt without a low-pass:
// the first term of the error there, h^2 of its fourth derivative.
std::vector<double> roll_doubts(std::span<const FitRow> rows, bool closed, const RowRolls& rolls,
                                std::span<const double> speeds, double heartline);

// Because the curvature changes within a few rows: what they feel more or less on the curve of degree 5 through every
// second row than on that through all rows, at each row that is left out. Where rows are close enough, that is 16 times
// the error of the curve through all rows; where a bend begins and ends between two rows, it may be less than the
// error. 0 where steps are shorter than kMoment of the ride: there rows are close enough.
std::vector<double> bend_doubts(std::span<const FitRow> rows, bool closed, std::span<const double> speeds);

}  // namespace coaster::sim
