// The rolls and curvatures of a smooth track through rows, and the quintic between two of them.
#pragma once

#include <span>
#include <vector>

#include "curve/frames.h"

namespace coaster::sim {

// --- The rows that a track is fitted to: measured positions with frames, and properties derived from them alone

// A point on the track: position in m, unit direction of travel, unit `up` perpendicular to it.
struct FitRow {
  glm::dvec3 position{0}, forward{1, 0, 0}, up{0, 1, 0};
};

// The rows jump where the frame turns by more than kJumpAngle and more than kJumpRate from one row to the next, and
// more than kJumpTimes as fast as in the steps beside it: no smooth rail turns so suddenly.
inline constexpr double kJumpReach = 0.5;   // m along the rows
inline constexpr double kJumpAngle = 5.0;   // degrees
inline constexpr double kJumpRate = 100.0;  // degrees per m
inline constexpr double kJumpTimes = 2.0;

// Returns the angle of the rotation from one frame to the other, degrees.
double frame_angle_deg(const curve::Frame& a, const curve::Frame& b);

// Returns for each step from a row to the next (closed: from the last to the first too) the angle by which the frame
// jumps, degrees; 0 if it does not jump.
std::vector<double> row_jumps(std::span<const FitRow> rows, bool closed);

// Returns the angle between the step from one row to the next and the mean of their directions, degrees; 0 if it is at
// most kOffForward more than half the angle between these: what a bend explains.
inline constexpr double kOffForward = 30;  // degrees
double off_deg(const FitRow& a, const FitRow& b);

// True if the last row leads back to the first: a step no longer than the others, forwards and in about the same
// direction. `rounding` of positions, m.
bool rows_close(std::span<const FitRow> rows, double rounding = 1e-5);

// Returns the spacing of float numbers at the rows' largest coordinate of an axis, m.
double float_spacing(std::span<const FitRow> rows, int axis);

// Returns for each step from a row to the next the largest curvature (1/m) that a fitted curve may have there:
// kBendShare times the rows' largest within kBendReach along them, plus kBendSpare. The rows' curvature is the angle
// between the directions at both ends of a step over its length. In steps of at least kLongStep it is at least that at
// either end, if it changes linearly in between: a track may bend to either side within a step.
inline constexpr double kBendReach = 2.0;    // m
inline constexpr double kBendShare = 1.5;    // of the rows' own
inline constexpr double kBendSpare = 0.005;  // 1/m
inline constexpr double kLongStep = 1.0;     // m: in shorter ones Fronts are too inexact for it
std::vector<double> bend_limits(std::span<const FitRow> rows, bool closed);

// Returns for each row the squared speed over g, m, of a train that passes the highest row at kTopSpeed without losses.
inline constexpr double kTopSpeed = 10.0;  // m/s
std::vector<double> row_speeds(std::span<const FitRow> rows);

// Returns for each row whether it is within `reach` m of a jump.
std::vector<char> near_jumps(std::span<const FitRow> rows, bool closed, double reach);

// --- Curves between rows

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

// The curve over `length` m with places, directions and curvatures (1/m) of the rows at both ends; x in [0, 1].
struct RowQuintic {
  glm::dvec3 c[6];  // coefficients of the powers of x
  RowQuintic(const FitRow& a, glm::dvec3 bend_a, const FitRow& b, glm::dvec3 bend_b, double length) {
    c[0] = a.position, c[1] = length * a.forward, c[2] = 0.5 * length * length * bend_a;
    const glm::dvec3 d = b.position - c[0] - c[1] - c[2], v = length * b.forward - c[1] - 2.0 * c[2],
                     w = length * length * bend_b - 2.0 * c[2];
    c[3] = 10.0 * d - 4.0 * v + 0.5 * w, c[4] = -15.0 * d + 7.0 * v - w, c[5] = 6.0 * d - 3.0 * v + 0.5 * w;
  }
  glm::dvec3 point(double x) const { return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))); }
  glm::dvec3 derivative(double x) const {
    return c[1] + x * (2.0 * c[2] + x * (3.0 * c[3] + x * (4.0 * c[4] + x * 5.0 * c[5])));
  }
  glm::dvec3 direction(double x) const { return glm::normalize(derivative(x)); }
  // 1/m, perpendicular to the direction.
  glm::dvec3 curvature(double x) const {
    const glm::dvec3 d = derivative(x);
    return curve::across(2.0 * c[2] + x * (6.0 * c[3] + x * (12.0 * c[4] + x * 20.0 * c[5])), glm::normalize(d)) /
           glm::dot(d, d);
  }
};

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
