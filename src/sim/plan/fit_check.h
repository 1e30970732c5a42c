// How far a document is from rows that it was fitted to: measured on the curves and frames that the program shows.
#pragma once

#include <span>
#include <vector>

#include "sim/plan/fit_track.h"
#include "sim/shape/derived.h"

namespace coaster::sim {

// Segment i of the track covers rows ends[i] to ends[i + 1] (ends.size() is the number of segments + 1; a row beyond
// the last one is the first one). `free` says of each row whether its frame counts. Returns what each segment is off
// by; `knots` stays 0.
std::vector<FitReport> measure_spans(const Derived& derived, std::span<const FitRow> rows,
                                     std::span<const std::size_t> ends, std::span<const char> free);

}  // namespace coaster::sim
