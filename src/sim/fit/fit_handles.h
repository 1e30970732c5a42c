// The handles of a cubic through two rows along their `forward`. Used by fit_span.cpp.
#pragma once

#include <span>
#include <vector>

#include "curve/cubic.h"
#include "sim/fit/fit_rows.h"

namespace coaster::sim {

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

}  // namespace coaster::sim
