// Fits one cubic to the rows between two knots: handle lengths, and the allowed rolls of the knots. Used by
// fit_track.cpp.
#pragma once

#include <span>
#include <vector>

#include "sim/fit/fit_handles.h"
#include "sim/fit/fit_rows.h"
#include "sim/fit/roll_window.h"

namespace coaster::sim {

// The tolerances of a fit, and the rows whose frames are ignored.
struct SpanBounds {
  double distance = 0.0095;        // m, distance of a row from the curve
  double angle = 0.0083;           // radians between the frames
  std::span<const char> free;      // per row: its frame is ignored (near a jump)
  std::span<const double> bends;   // per step from a row to the next: largest curvature, 1/m
  std::span<const double> spins;   // per row: spin of a knot there, rad/m
  std::span<const double> slopes;  // per row: rate of change of a smooth roll's spin there, rad/m^2
  std::span<const double> leans;   // per row: of that smooth roll against the row, rad
  bool open = false;               // the track begins at the first row and ends at the last one
  double felt = 0.2;               // g: what riders may feel more or less than on the rows, after a low-pass of 5 Hz
  double least_handle = kLeastHandle;      // of the rows' length
  double heartline = 0;                    // m above the rails, of the riders
  std::span<const double> speeds;          // per row: squared speed of the train over g, m
  std::span<const glm::dvec3> curvatures;  // per row: that of a smooth curve, 1/m
};

// What riders feel more or less than on the rows.
struct FeltMiss {
  double squares = 0, seconds = 0;  // g^2 s: its square over the time of the ride; the time
};

struct SpanFit {
  bool within = false;  // both bounds can be met; if false, only the handles are set
  // Between neighbouring rows: the bounds of curvature or forces are missed nevertheless.
  bool bent = false;
  double out_length = 0, in_length = 0;  // m, of the first knot's and the second knot's handle
  // Radians by which the rows turn about the curve relative to its rotation-minimising frame, including whole turns.
  double roll = 0;
  RollWindow window;
  FeltMiss felt;
};

// Memory reused by fits.
struct SpanScratch {
  std::vector<double> parameters, stations, rolls, shares, fronts, places;
  std::vector<glm::dvec3> misses;
  double length = 0;  // m, of the curve
};

// Fits the cubic through rows `first` and `last` (their positions rounded to float, as knots are) along their
// `forward`. `distances` is the length of the rows' polyline up to each row, m. `roll_low` and `roll_high` limit the
// first knot's additional roll. Handle lengths by Gauss-Newton on the orthogonal distances, parameters by Newton, from
// the start of Schneider 1990 ("An algorithm for automatically fitting digitized curves", Graphics Gems, 612-626):
// lengths along the polyline, up to half of it. Then checks all rows, the curvature at and between them, and what
// riders feel. Neighbouring rows always fit, but may be bent. Takes about 0.5 us per row and 10 us.
SpanFit fit_span(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first, std::size_t last,
                 double roll_low, double roll_high, const SpanBounds& bounds, SpanScratch& scratch);

}  // namespace coaster::sim
