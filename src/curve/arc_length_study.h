// The arc-length methods judged: each row's error against a reference in long double, and how it falls as the method
// may do more. Pure functions that count evaluations; time is for the caller to measure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curve/arc_length.h"

namespace coaster::curve {

// The length over [t0,t1], t0 <= t1, by 40-node Gauss-Legendre in long double with halving towards stops: relative
// error below 1e-15 (1e-13 where long double is a double). About 20 us, 200 us at a cusp; bounded.
long double reference_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0);

struct ConvergencePoint {
  std::int64_t evaluations;  // as in LengthEstimate, of this one measurement
  double relative_error;     // |length - reference| / reference; never below kSmallestError, so that it has a logarithm
};
constexpr double kSmallestError = 1e-17;

struct Convergence {
  ArcLengthId method;
  std::vector<ConvergencePoint> points;  // evaluations never fall; one point for a method without a control
};

// One entry per row of the table, in its order: counts 1, 2, 4, ... up to `most` evaluations, or tolerances 1e-1, 1e-2,
// ... 1e-12 until one takes more than `most`. Under 2 ms with most = 1024. A curve of no length has errors of
// kSmallestError.
std::vector<Convergence> convergence(const Cubic& cubic, std::int64_t most = 1024);

struct LengthComparison {
  ArcLengthId method;
  double length;          // m
  double error;           // m, length - reference
  double relative_error;  // |error| / reference, 0 for a curve of no length
  double error_bound;     // m, what the method itself says; -1 where it knows none
  std::int64_t evaluations;
};

// Every row on one cubic, or summed over many (a track; its error bounds add up), with `demand.count` intervals or
// nodes; a row that heeds a tolerance is held to its usual one, or to demand.tolerance where that is coarser.
std::vector<LengthComparison> compare_lengths(const Cubic& cubic, const LengthDemand& demand);
std::vector<LengthComparison> compare_lengths(std::span<const Cubic> cubics, const LengthDemand& demand);

}  // namespace coaster::curve
