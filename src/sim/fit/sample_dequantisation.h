// Rows whose numbers are rounded: the smoothest rows that they may be rounded from.
#pragma once

#include <span>
#include <vector>

#include "sim/fit/sample_interpolation.h"

namespace coaster::sim {

// The steps between neighbouring values of rounded numbers: their errors are up to half a step, step / sqrt(12) on
// average. 0: exact.
struct RowSteps {
  double position = 0;   // m
  double direction = 0;  // of the components of unit vectors
  bool rounded() const { return position > 0 || direction > 0; }
  friend bool operator==(const RowSteps&, const RowSteps&) = default;
};

struct UnroundedRows {
  std::vector<FitRow> rows;
  std::vector<std::size_t> from;  // per row: the given one that it is in place of
};

// Returns the rows of the track whose curvature and roll change least of those within half a step of the rows' numbers:
// the cubic spline in parts of kSites m, or half as long as the rows are apart, by least squares whose weights grow at
// rows that are further off and fall at others (Lawson 1961). Rows too close to the one before are left out; jumps of
// the frame stay. A step that the rows do not show becomes 0: the numbers are multiples of it because they are exact.
// Without a step, and for rows that no such curve follows or that run against their directions, both become 0, and
// there are no rows. Reports progress (base/cancellable_job.h); less smooth once it is cancelled.
inline constexpr double kSites = 0.25;  // m
UnroundedRows unrounded_rows(std::span<const FitRow> rows, bool closed, RowSteps& steps);

}  // namespace coaster::sim
