// One span of a fit to rows: its handles, and the rolls of its two knots with which it keeps the rows' frames within a
// bound.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "curve/cubic.h"
#include "sim/fit/sample_interpolation.h"

namespace coaster::sim {

// The additional rolls (a, b) of the first and the second knot, radians, that keep all frames within the bound: a
// convex polygon, empty if there are none.
using RollWindow = std::vector<glm::dvec2>;

// Keeps the part of the polygon with normal . x <= limit. A corner that is off by rounding stays: otherwise each row of
// a straight, whose lines all meet in two corners, would add corners there. `spare` is memory that is reused.
void clip(RollWindow& polygon, glm::dvec2 normal, double limit, RollWindow& spare);

// The smallest and largest roll of the second knot within a window; low > high if it is empty.
struct RollRange {
  double low = 1, high = -1;
};
RollRange second_rolls(const RollWindow& window);

// Returns the roll nearest to `wanted` that the window allows the first knot when the second has `second`.
double first_roll(const RollWindow& window, double second, double wanted);

struct Handles {
  double out, in;  // m
};
// Of the rows' length: curvature changes quickly beside shorter handles.
inline constexpr double kLeastHandle = 0.25;
struct SpanEnds {
  glm::dvec3 p0, t0, p3, t3;           // positions and unit tangents
  double least_handle = kLeastHandle;  // of the rows' length
};

curve::CoefficientsD curve_of(const SpanEnds& ends, Handles handles);

// Returns the parameter nearest to `target` by Newton's method from t, kept in [0,1].
double nearer(const curve::CoefficientsD& c, glm::dvec3 target, double t, int steps);

// Returns the curvature vector, 1/m.
glm::dvec3 bend_of(const curve::CoefficientsD& c, double t);

// Returns the handles with the smallest distances of the rows between `first` and `last`, by Gauss-Newton on the
// distances perpendicular to the curve: a row's position along it is ignored, so sliding parameters do not slow it
// down. Sets the parameters of some of the rows, and their fractions of the length.
Handles fit_handles(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first,
                    std::size_t last, const SpanEnds& ends, std::vector<double>& parameters,
                    std::vector<double>& stations);

// Returns the handles with which a short span has curvatures closest to `from` and `to` at its
// ends, while its curvature stays within `limit` if possible. Searches from `start` in decreasing steps.
Handles most_alike(const SpanEnds& ends, double length, glm::dvec3 from, glm::dvec3 to, double limit, Handles start);

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
