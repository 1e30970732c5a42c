// A track through measured rows: as few knots as keep it within bounds of them. Knots stand on rows; joints are G1.
#pragma once

#include <span>
#include <vector>

#include "sim/fit_span.h"
#include "world/document.h"

namespace coaster::sim {

// Bounds of the fit. A row near a jump (the frame turns by over kJumpAngle from one row to the next, and by over kJumpRate) may be off in its
// frame, not in its place: no smooth rail turns so fast.
inline constexpr double kFitDistance = 0.01;    // m
inline constexpr double kFitAngle = 0.5;        // degrees
inline constexpr double kJumpReach = 0.5;       // m along the rows
inline constexpr double kJumpAngle = 5.0;       // degrees
inline constexpr double kJumpRate = 100.0;      // degrees per m

// How well the document's own curve and frames (world::cubic_of, sim::frame_at) meet the rows; every row is measured.
struct FitReport {
  double max_error = 0;    // m, the largest distance of a row from the curve
  double frame_error = 0;  // degrees, the largest angle of the rotation between a row's frame and the track's there, but near jumps
  int knots = 0;
};

struct FittedTrack {
  world::Document document;
  FitReport report;
};

// Whether the last row leads back to the first one: a step that is no longer than the others, ahead and about the same way.
bool rows_close(std::span<const FitRow> rows);

// A document with knots, segments and nothing else. Needs at least 2 rows (3 when closed) with finite places within world::kMaxCoordinate,
// neighbours apart by more than 1e-6 m, and unit perpendicular frames. On a closed track the first row is not repeated, and is a knot.
// The bounds are kept whenever rows are 0.03 m apart or more and coordinates within 10 km: two rows that are neighbours always fit, and a
// span that the finished document misses is halved. Same rows, same bits, on every machine. Deterministic; about 25 us a row.
FittedTrack fit_track(std::span<const FitRow> rows, bool closed);

// For each row, whether it is within `reach` m of a jump.
std::vector<char> near_jumps(std::span<const FitRow> rows, bool closed, double reach);

}  // namespace coaster::sim
