// Measures the table of evaluators on this machine, on request: nanoseconds per point and the worst error of every row
// that runs on the processor, at 16 to 4096 steps per segment. A value that advances in small parts, one per frame; not
// part of any hash.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/derived.h"

namespace coaster::sim {

inline constexpr std::array<int, 5> kMeasuredSteps{16, 64, 256, 1024, 4096};
inline constexpr int kMeasureRounds = 9;            // odd, for the median
inline constexpr int kMeasuredPoints = 16'384;      // at least so many for each row in one round
inline constexpr std::size_t kMeasuredCurves = 16;  // evenly spaced along the track

struct MeasuredCell {
  double ns_per_point = 0;  // median of the rounds so far; 0 without a clock
  double worst_error = 0;   // m, largest |vertex - exact| over the curves, long double oracle
  int rounds = 0;           // 0: no result yet
  friend bool operator==(const MeasuredCell&, const MeasuredCell&) = default;
};

// A row of the table. Rows on the GPU are not measured: their time is the GPU's, their error that of the processor
// twin.
struct MeasuredRow {
  curve::EvaluatorId evaluator{};
  std::array<MeasuredCell, kMeasuredSteps.size()> cells;
  std::array<std::array<double, kMeasureRounds>, kMeasuredSteps.size()> seconds{};  // of each round, for a point
};

struct Measurement {
  std::vector<curve::PreparedCubic> curves;  // curves to evaluate, at most kMeasuredCurves
  std::vector<MeasuredRow> rows;             // empty: never started
  int next = 0, total = 0;  // parts done and total; a part is one round of every row at one number of steps
  bool running = false;
  double checksum = 0;  // of the results, so that no evaluation is optimised away
};

// Starts a measurement on at most kMeasuredCurves evenly spaced curves of a track; without a segment nothing runs.
Measurement start_measurement(const Derived& derived);

// Runs the next part: every row once at one number of steps, in an order that rotates with the round. About
// kMeasuredPoints points per row (a few ms for the whole table), plus the exact points once per number of steps. No-op
// if not running; after the last part it stops running.
void measure_next(Measurement& measurement, const Clock& clock);

// Returns 0 before the first part, 1 after the last one.
double progress(const Measurement& measurement);

// Returns the row of an evaluator, or null if it was not measured.
const MeasuredRow* row_of(const Measurement& measurement, curve::EvaluatorId evaluator);

// Returns RFC 4180 CSV with a header, after a line "# ..." with `machine`. One line per measured cell.
std::string to_csv(const Measurement& measurement, std::string_view machine);

}  // namespace coaster::sim
