// The rows that a track is fitted to: measured positions with frames, and properties derived from them alone.
#pragma once

#include <span>
#include <vector>

#include "curve/frames.h"

namespace coaster::sim {

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

}  // namespace coaster::sim
