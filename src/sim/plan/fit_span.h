// Fitting one cubic to the rows between two knots: handle lengths, and what the knots may be rolled by. Used by
// fit_track.cpp.
#pragma once

#include <span>
#include <vector>

#include "sim/plan/fit_rows.h"

namespace coaster::sim {

// What a fit may be off by, and which rows' frames are not asked about.
struct SpanBounds {
  double distance = 0.0095;    // m, of a row from the curve
  double angle = 0.0083;       // radians between the frames
  std::span<const char> free;  // of each row: its frame does not count (near a place where the rows jump)
};

// The additional rolls (a, b) of the first and the second knot, radians, that keep all frames within the bound: a
// convex polygon, empty when there are none.
using RollWindow = std::vector<glm::dvec2>;

struct SpanFit {
  bool within = false;                   // both bounds can be kept; else the rest may be unset but for the handles
  double out_length = 0, in_length = 0;  // m, of the first knot's and the second knot's handle
  double roll =
      0;  // radians that the rows turn about the curve against its rotation-minimising frame, whole turns included
  RollWindow window;
};

// Memory that fits share.
struct SpanScratch {
  std::vector<double> parameters, stations, rolls, shares, fronts;
};

// Fits the cubic that goes through rows `first` and `last` (their positions rounded to float, as knots are) along their
// `forward`. `distances` is the length of the rows' polyline up to each row, m. `roll_low` and `roll_high` limit the
// first knot's additional roll. Handle lengths by Gauss-Newton on the orthogonal distances, parameters by Newton, from
// the start that Schneider 1990 ("An algorithm for automatically fitting digitized curves", Graphics Gems, 612-626)
// takes: lengths along the polyline. All rows are then checked. Neighbouring rows always fit. Cost: about 0.5 us a row
// and 10 us.
SpanFit fit_span(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first, std::size_t last,
                 double roll_low, double roll_high, const SpanBounds& bounds, SpanScratch& scratch);

}  // namespace coaster::sim
