// A track through measured rows: as few knots as keep it within bounds of them. Knots stand on rows; joints are G1.
#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "sim/plan/fit_span.h"
#include "world/document.h"

namespace coaster::sim {

// Bounds of the fit. A row within kJumpReach of a jump may be off in its frame, not in its place.
inline constexpr double kFitDistance = 0.01;  // m
inline constexpr double kFitAngle = 0.5;      // degrees

// How well the document's own curve and frames (world::cubic_of, sim::frame_at) meet the rows; every row is measured.
struct FitReport {
  double max_error = 0;  // m, the largest distance of a row from the curve
  double frame_error =
      0;  // degrees, the largest angle of the rotation between a row's frame and the track's there, but near jumps
  int knots = 0;
};

struct FittedTrack {
  world::Document document;
  FitReport report;
};

// A document with knots, segments and nothing else. Needs at least 2 rows (3 when closed) with finite places within
// world::kMaxCoordinate, neighbours apart by more than 1e-6 m, and unit perpendicular frames. On a closed track the
// first row is not repeated, and is a knot. The bounds are kept whenever rows are 0.03 m apart or more and coordinates
// within 10 km: two rows that are neighbours always fit, and a span that the finished document misses is halved. Same
// rows, same bits, on every machine. Deterministic; about 25 us a row. `progress` (or null) is told how far it is; once
// it is cancelled, an empty document comes back.
FittedTrack fit_track(std::span<const FitRow> rows, bool closed, base::Progress* progress = nullptr);

}  // namespace coaster::sim
