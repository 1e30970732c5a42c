// The distance of a document from the rows it was fitted to: measured on the curves and frames that the program shows.
#pragma once

#include <span>
#include <vector>

#include "sim/plan/fit_track.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

// Returns the error of each segment. Segment i of the track covers rows ends[i] to ends[i + 1] (ends.size() is the
// number of segments + 1; the row after the last is the first). `free` says for each row whether its frame is ignored.
// `knots` stays 0.
std::vector<FitReport> measure_spans(const Derived& derived, std::span<const FitRow> rows,
                                     std::span<const std::size_t> ends, std::span<const char> free);

}  // namespace coaster::sim
