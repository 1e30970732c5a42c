// The state of a fit, and the division of its rows into spans. Used by fit_track.cpp.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "base/cancellable_job.h"
#include "sim/fit/sample_interpolation.h"
#include "sim/fit/sample_span_fit.h"
#include "world/document.h"

namespace coaster::sim {

inline constexpr int kEvenings = 3;  // bisections for the smallest bounds that the same number of knots meets
// Longer tracks are not evened out, which would take up to five times as long.
inline constexpr std::size_t kEvenedRows = 60'000;

inline constexpr double kLeastSpan = 0.06;  // m: in a shorter span the least handle length would not fit

struct FittedSpan {
  std::size_t first = 0, last = 0;
  SpanFit fit;
  RollRange allowed;  // of the first knot's additional roll
};

// The state of a fit. On a closed track `rows` repeats the first row at the end.
struct FitState {
  std::vector<FitRow> rows;
  std::vector<double> distances;
  std::vector<char> free;
  std::vector<double> bends, speeds;
  RowRolls row_rolls;
  std::vector<glm::dvec3> curvatures;
  bool closed = false;
  double distance = SpanBounds{}.distance;  // m: the bound of the rows' distances
  double least_handle = kLeastHandle;
  double last_span = kLeastSpan;  // m: the last one is no shorter
  double scale = 1;               // relative to the bounds
  double felt_scale = 1;          // the same of what riders feel
  SpanScratch scratch;
  std::vector<FittedSpan> spans;
  std::vector<double> rolls;  // additional roll of a knot at each row, radians
  int passes = 0;             // completed calls of fit_spans()

  bool cancelled() const { return base::interrupted(); }
  // Reports progress within the present pass, 0..1. The passes take about the same time, the rest little.
  void tell(double part) const {
    const double all = (rows.size() > kEvenedRows ? 1 : 3 + kEvenings) + 0.2;
    base::report_progress(std::min(1.0, (passes + part) / all));
  }

  SpanBounds bounds() const {
    SpanBounds b;
    b.distance = distance * scale, b.least_handle = least_handle;
    b.angle *= scale, b.felt *= scale * felt_scale;
    b.free = free, b.bends = bends, b.spins = row_rolls.spins, b.slopes = row_rolls.slopes, b.leans = row_rolls.leans;
    b.speeds = speeds, b.curvatures = curvatures;
    b.open = !closed;
    b.heartline = world::Document{}.heartline;
    return b;
  }
  SpanFit fit(std::size_t first, std::size_t last, const RollRange& allowed) {
    SpanFit f = fit_span(rows, distances, first, last, allowed.low, allowed.high, bounds(), scratch);
    if (f.within && closed && last + 1 == rows.size()) {  // ends with the roll that it began with
      const auto [least, most] = second_rolls(f.window);
      f.within = least <= row_rolls.leans[last] && most >= row_rolls.leans[last];
    }
    return f;
  }
};

// Divides all rows into the longest spans that fit, from the first row on. Ends early once cancelled, or with one span
// more than `most_spans`.
void fit_spans(FitState& w, std::size_t most_spans = std::numeric_limits<std::size_t>::max());

// Tightens the bounds as far as the same number of spans allows: the longest spans leave a short one at the end.
void even_out(FitState& w);

}  // namespace coaster::sim
