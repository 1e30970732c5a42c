// Measures the table of evaluators on this machine, on request: nanoseconds per point, and the largest error over the
// whole track, at 16 to 4096 steps per segment. A value that advances in small parts, one per frame; not part of any
// hash.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "curve/evaluators.h"
#include "sim/shape/derived_track.h"

namespace coaster::sim {

inline constexpr std::array<int, 5> kMeasuredSteps{16, 64, 256, 1024, 4096};
inline constexpr int kMeasureRounds = 9;         // odd, for the median
inline constexpr int kMeasuredPoints = 16'384;   // at least so many for each row in one round
inline constexpr int kErrorPoints = 131'072;     // at most so many for each row in one part, or one segment
inline constexpr std::size_t kTimedCurves = 16;  // at most, evenly spaced along the track; errors are those of all

struct MeasuredCell {
  double ns_per_point = 0;  // median of the rounds so far; 0 without a clock
  double worst_error = 0;   // m, largest |vertex - exact| over all segments, long double oracle
  int rounds = 0;           // 0: no result yet
  friend bool operator==(const MeasuredCell&, const MeasuredCell&) = default;
};

// A row of the table. Rows on the GPU have no time, and the error of the same arithmetic on the processor.
struct MeasuredRow {
  curve::EvaluatorId evaluator{};
  std::array<MeasuredCell, kMeasuredSteps.size()> cells;
  std::array<std::array<double, kMeasureRounds>, kMeasuredSteps.size()> seconds{};  // of each round, for a point
  bool is_timed() const { return base::row_of(evaluator).evaluated_by == curve::EvaluatedBy::processor; }
};

struct Measurement {
  std::vector<curve::PreparedCubic> curves;  // of all segments
  std::vector<MeasuredRow> rows;             // of all evaluators; empty: never started
  int next = 0, total = 0;                   // parts done and total
  int timed = 0;                             // numbers of steps timed, of all rounds
  std::size_t searched = 0;                  // segments whose errors are found at the present number of steps
  bool running = false;
  double checksum = 0;  // of the results, so that no evaluation is optimised away
};

// Starts a measurement on the curves of a track; without a segment nothing runs.
Measurement start_measurement(const DerivedTrack& derived);

// Runs the next part: in the first round the errors of the next segments, and after the last of them, as in each other
// round, every row's time once at one number of steps, in an order that rotates with the round. About kMeasuredPoints
// points per row (a few ms for the whole table), and kErrorPoints for its error (some 10 ms). No-op if not running;
// after the last part it stops running.
void measure_next(Measurement& measurement, const Clock& clock);

// Returns 0 before the first part, 1 after the last one.
double progress(const Measurement& measurement);

// Returns the row of an evaluator, or null if it was not measured.
const MeasuredRow* row_of(const Measurement& measurement, curve::EvaluatorId evaluator);

// Returns RFC 4180 CSV with a header, after a line "# ..." with `machine`. One line per measured cell.
std::string to_csv(const Measurement& measurement, std::string_view machine);

// --- Rounding errors of a polyline: each vertex against the exact point at the same t. A picture magnifies them, a
// plot shows their size

// vertex - exact, m, of the steps+1 vertices of one segment as the evaluator computes them (a GPU row: its processor
// twin); exact: de Casteljau in long double at t = i/steps, rounded once to double. Both ends are pinned to the control
// points, so their error is 0, and the accumulated error appears as a seam in the last step. steps: 1..4096. Takes
// about 0.1 us per vertex.
struct Rounding {
  std::vector<glm::dvec3> exact, error;
};
Rounding rounding(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps);

// Returns the largest |error|, m.
double largest(const Rounding& rounding);
// Returns |error| of the last vertex that is not pinned, m: the jump of the last step. 0 with one step.
double seam(const Rounding& rounding);

struct ErrorSample {
  double t = 0, mm = 0;  // |vertex - exact| in millimetres
};
// Returns |error| along the segment, steps+1 samples, for a plot. 0 at both ends, and wherever a vertex is exact.
std::vector<ErrorSample> error_profile(const curve::PreparedCubic& curve, const curve::Evaluator& evaluator, int steps);

}  // namespace coaster::sim
