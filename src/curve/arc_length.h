// Arc length of a cubic: a table of methods to compare, the adaptive Gauss-Legendre one that the ride relies on, and
// the inversion from arc length to parameter.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "curve/cubic.h"

namespace coaster::curve {

enum class ArcLengthId : int {};

// What a method is asked for: each row heeds one of the two, or neither.
struct LengthDemand {
  int count = 64;           // intervals or nodes, 1 to 4096
  double tolerance = 1e-9;  // relative error, 1e-12 to 0.1
};
enum class LengthControl { none, count, tolerance };
enum class LengthBound { none, estimated, guaranteed };

struct LengthEstimate {
  double length = 0;        // m
  double error_bound = -1;  // m; -1 where the method knows none
  std::int64_t evaluations =
      0;  // square roots: one for each |B'(t)| or chord, four for a chord with its control polygon
};

struct ArcLengthMethod {
  std::string_view name;   // "gauss_legendre"
  std::string_view label;  // "Gauss-Legendre, adaptive"
  std::string_view formula;
  LengthControl control;   // what of the demand it heeds
  LengthBound bound;       // what its error_bound is worth
  double usual_tolerance;  // relative, where it heeds one: what it reaches in well under a millisecond
  LengthEstimate (*measure)(const Cubic& cubic, const LengthDemand& demand);

  // Length in metres with `steps` intervals or nodes where the method heeds a count, else to its usual tolerance.
  double length(const Cubic& cubic, int steps) const { return measure(cubic, {steps, usual_tolerance}).length; }
};

// Rows: adaptive Gauss-Legendre (the default, row 0), Gravesen's mean (Paper erratum: the paper has a product), chord
// sum of the polyline, Simpson, trapezium, Riemann, Gauss-Legendre of n nodes, Clenshaw-Curtis, Gravesen and Simpson
// with subdivision. Every row is finite and not negative for every cubic, and does bounded work: at most 2^17
// evaluations in Gravesen's subdivision (1e-9 at best: its bound says what was reached), a few thousand in the others.
std::span<const ArcLengthMethod> arc_length_methods();
const ArcLengthMethod& arc_length_method(ArcLengthId id);
std::optional<ArcLengthId> find_arc_length_method(std::string_view name);

constexpr double kFinestTolerance = 1e-12;

// Integral of |B'| over [t0,t1], t0 <= t1, in metres, by adaptive Gauss-Legendre in double, with a relative error below
// `relative_tolerance` (1e-12 to 0.1; finer is taken as 1e-12) on every kind of cubic, cusps included. The default is
// what the ride uses, the same bits on every machine: 8 and 16 nodes, 24 evaluations of B' where nothing is halved.
// Coarser tolerances take 10 to 24 nodes and estimate the error from the same samples. At a stop of the curve (a cusp)
// the work is bounded: at most 30 halvings towards it.
double arc_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0, double relative_tolerance = kFinestTolerance);
LengthEstimate measure_arc_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0,
                                  double relative_tolerance = kFinestTolerance);

// arc_length(cubics[i], 0, 1, relative_tolerance) for all, into `lengths` of the same size; for display, not for what
// is hashed: the last bits depend on the processor. Four segments at once where it has AVX2, else one by one; segments
// whose error estimate fails are measured again by arc_length.
void arc_lengths(std::span<const Cubic> cubics, double relative_tolerance, std::span<double> lengths);

// Parameters where a cubic is slowest, at most two (minima of a quartic); ascending.
struct SlowPoints {
  std::array<double, 2> t{};
  int count = 0;
};

// Length of a cubic with what is needed to invert it. Immutable; 33 knots of s over uniform t.
class ArcLengthMap {
 public:
  ArcLengthMap() = default;
  explicit ArcLengthMap(const Cubic& cubic);

  double length() const { return table_.back(); }  // metres

  // t in [0,1] with arc length s from the start; s is clamped to [0,length]. Table, then Newton inside a bisection
  // bracket (at most 60 steps): |s(t) - s| below 1e-10 m or 1e-12 of the length. A segment of no length gives t = 0.
  double parameter(double s) const;

  // Arc length from 0 to t, t in [0,1].
  double distance(double t) const;

 private:
  static constexpr int kIntervals = 32;
  double partial(int interval, double t) const;  // length from the interval's start to t within it

  CoefficientsD c_{};
  std::array<double, kIntervals + 1> table_{};
  SlowPoints slow_;
  std::uint32_t rough_ = 0;  // bit i: interval i needs the adaptive rule (near a cusp)
};

}  // namespace coaster::curve
