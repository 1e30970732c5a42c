// Compares the arc-length methods: the error of each against a reference in long double, and its convergence with the
// work. Pure functions that count evaluations; the caller measures time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curve/arc_length.h"

namespace coaster::curve {

// Returns the length over [t0,t1], t0 <= t1, in metres, by 40-node Gauss-Legendre in long double with halving towards
// stops: relative error below 1e-15 (1e-13 where long double is a double). Takes about 20 us, 200 us at a cusp;
// bounded.
long double reference_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0);

struct ConvergencePoint {
  std::int64_t evaluations;  // as in LengthEstimate, of this measurement alone
  double relative_error;     // |length - reference| / reference; at least kSmallestError, for a logarithmic axis
};
constexpr double kSmallestError = 1e-17;

struct Convergence {
  ArcLengthId method;
  std::vector<ConvergencePoint> points;  // evaluations never decrease; one point for a method without a control
};

// Returns one entry per method, in the order of the table: counts 1, 2, 4, ... up to `most` evaluations, or tolerances
// 1e-1, 1e-2, ... 1e-12 until one takes more than `most`. Takes under 2 ms with most = 1024. All errors of a curve of
// zero length are kSmallestError.
std::vector<Convergence> convergence(const Cubic& cubic, std::int64_t most = 1024);

struct LengthComparison {
  ArcLengthId method;
  double length;          // m
  double error;           // m, length - reference
  double relative_error;  // |error| / reference, 0 for a curve of zero length
  double error_bound;     // m, the method's own bound; -1 if it has none
  std::int64_t evaluations;
};

// Runs every method on one cubic, or sums over many (a track; error bounds add up), with `demand.count` intervals or
// nodes. A method with a tolerance uses its usual_tolerance, or demand.tolerance if that is coarser.
std::vector<LengthComparison> compare_lengths(const Cubic& cubic, const LengthAccuracy& demand);
std::vector<LengthComparison> compare_lengths(std::span<const Cubic> cubics, const LengthAccuracy& demand);

}  // namespace coaster::curve
