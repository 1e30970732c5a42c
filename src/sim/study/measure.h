// The table of evaluators measured on this machine, on request: nanoseconds a point and the worst error of every row
// that runs on the processor, at 16 to 4096 steps a segment. A value that is advanced by small parts, one a frame;
// nobody's hash depends on it.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sim/shape/derived.h"

namespace coaster::sim {

inline constexpr std::array<int, 5> kMeasuredSteps{16, 64, 256, 1024, 4096};
inline constexpr int kMeasureRounds = 9;            // odd, for the median
inline constexpr int kMeasuredPoints = 16'384;      // evaluated at least by a row in one round
inline constexpr std::size_t kMeasuredCurves = 16;  // of a track, evenly along it

struct MeasuredCell {
  double ns_per_point = 0;  // median of the rounds so far; 0 without a clock
  double worst_error = 0;   // m, largest |vertex - exact| over the curves, long double oracle
  int rounds = 0;           // 0: nothing is known yet
  friend bool operator==(const MeasuredCell&, const MeasuredCell&) = default;
};

// A row of the table. GPU rows have none: their time is the GPU's, their error that of their twin on the processor.
struct MeasuredRow {
  curve::EvaluatorId evaluator{};
  std::array<MeasuredCell, kMeasuredSteps.size()> cells;
  std::array<std::array<double, kMeasureRounds>, kMeasuredSteps.size()> seconds{};  // of each round, for a point
};

struct Measurement {
  std::vector<curve::PreparedCubic> curves;  // what is evaluated, at most kMeasuredCurves
  std::vector<MeasuredRow> rows;             // empty: nothing was ever asked for
  int next = 0, total = 0;  // parts done and to do; a part is one round of every row at one number of steps
  bool running = false;
  double checksum = 0;  // of what was evaluated, so that no evaluation can be left out
};

// Starts anew on the curves of a track, at most kMeasuredCurves of them evenly spaced; without a segment nothing runs.
Measurement start_measurement(const Derived& derived);

// Does one part: every row once at one number of steps, in an order that turns with the round. About kMeasuredPoints
// points a row (some ms for the whole table), once more for each number of steps the exact points. Does nothing unless
// it is running; after the last part it is not.
void measure_next(Measurement& measurement, const Clock& clock);

// 0 before the first part, 1 after the last one.
double progress(const Measurement& measurement);

// The row of an evaluator, or null when it was not measured.
const MeasuredRow* row_of(const Measurement& measurement, curve::EvaluatorId evaluator);

// RFC 4180 with a header; first a line "# ..." with `machine`. One line a cell that has been measured.
std::string to_csv(const Measurement& measurement, std::string_view machine);

}  // namespace coaster::sim
