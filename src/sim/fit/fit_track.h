// Fits a track to measured rows: as few knots as stay within the bounds. Knots are at rows; joints are G1.
#pragma once

#include <cmath>
#include <span>

#include "sim/fit/sample_span_fit.h"
#include "sim/shape/derived_track.h"

namespace coaster::sim {

// Bounds of the fit. A row within kJumpReach of a jump must meet the bound of the distance but not that of the frame.
inline constexpr double kFitDistance = 0.01;  // m
inline constexpr double kFitAngle = 0.5;      // degrees

struct MeanSquare {
  double sum = 0;
  std::size_t count = 0;
  void add(double value) { sum += value * value, ++count; }
  void add(const MeanSquare& more) { sum += more.sum, count += more.count; }
  double root() const { return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0; }
};

// What riders may feel more or less than on the track that the rows were taken from, and the row where.
struct FeltUncertainty {
  double g = 0;
  std::size_t row = 0;
};

// The errors of the document's own curve and frames (world::cubic_of, sim::frame_at) at the rows; every row is
// measured.
struct FitReport {
  double max_error = 0;    // m, the largest distance of a row from the curve
  double frame_error = 0;  // degrees, the largest angle between a row's frame and the track's, except near jumps
  double jump_error = 0;   // degrees, the same near jumps, where frames are ignored
  int knots = 0;
  FeltUncertainty roll_doubt, bend_doubt;  // the largest of roll_doubts() and bend_doubts(), except near jumps
  MeanSquare distances, angles;  // m and degrees, of the rows that `max_error` and `frame_error` are the largest of
};

// Returns the error of each segment of a track. Segment i covers rows ends[i] to ends[i + 1] (ends.size() is the number
// of segments + 1; the row after the last is the first). `free` says for each row whether its frame counts in
// `jump_error`, `given` whether the row counts at all. `knots` stays 0.
std::vector<FitReport> measure_spans(const DerivedTrack& derived, std::span<const FitRow> rows,
                                     std::span<const std::size_t> ends, std::span<const char> free,
                                     std::span<const char> given);

struct FittedTrack {
  world::Document document;
  FitReport report;
};

// Returns a document of knots and segments only. Needs at least 2 rows (3 if closed) with finite positions within
// world::kMaxCoordinate, neighbours more than 1e-6 m apart, and unit perpendicular frames. On a closed track the first
// row is not repeated, and is a knot. The bounds are met if rows are at least 0.03 m apart and coordinates within 10
// km: two neighbouring rows always fit, and a span that misses on the finished document is halved. Spans between more
// rows also bound what riders feel (SpanBounds::felt). The same bits on every machine; about 25 us per row. Reports
// progress (base/cancellable_job.h); returns an empty document once it is cancelled.
// `given`: what rows that are not rounded any more (sim/fit/sample_dequantisation.h) are in place of, as many; the
// report measures these. `step`: that their positions are rounded to, m, 0 if they are exact; the track stays within
// kSteps of it.
inline constexpr double kSteps = 1.5;
FittedTrack fit_track(std::span<const FitRow> rows, bool closed, std::span<const FitRow> given = {}, double step = 0);

}  // namespace coaster::sim
