// Arc length of a cubic: a table of methods to compare, the adaptive Gauss-Legendre method that the ride uses, and the
// inversion from arc length to parameter.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "curve/cubic.h"

namespace coaster::curve {

enum class ArcLengthId : int {};

// The accuracy requested from a method. Each method uses one of the two members, or neither.
struct LengthAccuracy {
  int count = 64;           // intervals or nodes, 1 to 4096
  double tolerance = 1e-9;  // relative error, 1e-12 to 0.1
};
enum class LengthControl { none, count, tolerance };
enum class LengthBound { none, estimated, guaranteed };

struct LengthEstimate {
  double length = 0;             // m
  double error_bound = -1;       // m; -1 if the method has no bound
  std::int64_t evaluations = 0;  // of square roots: one per |B'(t)| or chord, four per chord with its control polygon
};

struct ArcLengthMethod {
  std::string_view name;   // "gauss_legendre"
  std::string_view label;  // "Gauss-Legendre, adaptive"
  std::string_view formula;
  LengthControl control;   // the member of LengthAccuracy that it uses
  LengthBound bound;       // how reliable its error_bound is
  double usual_tolerance;  // relative; used only with LengthControl::tolerance; reached in well under a millisecond
  LengthEstimate (*measure)(const Cubic& cubic, const LengthAccuracy& demand);

  // Returns the length in metres, with `steps` intervals or nodes if the method takes a count, else to usual_tolerance.
  double length(const Cubic& cubic, int steps) const { return measure(cubic, {steps, usual_tolerance}).length; }
};

// Returns the table: adaptive Gauss-Legendre (the default, row 0), Gravesen's mean (Paper erratum: the paper has a
// product), chord sum of the polyline, Simpson, trapezium, Riemann, Gauss-Legendre of n nodes, Clenshaw-Curtis,
// Gravesen and Simpson with subdivision. Every method gives a finite length >= 0 for every cubic in bounded work: at
// most 2^17 evaluations in Gravesen's subdivision (1e-9 at best; error_bound says what was reached), a few thousand in
// the others.
std::span<const ArcLengthMethod> arc_length_methods();
inline std::span<const ArcLengthMethod> rows_of(ArcLengthId) { return arc_length_methods(); }

constexpr double kFinestTolerance = 1e-12;

// Returns the integral of |B'| over [t0,t1], t0 <= t1, in metres, by adaptive Gauss-Legendre in double. The relative
// error is below `relative_tolerance` (1e-12 to 0.1; clamped to 1e-12) for every kind of cubic, cusps included. The
// ride uses the default, which has the same bits on every machine: 8 and 16 nodes, 24 evaluations of B' if no interval
// is halved. Coarser tolerances take 10 to 24 nodes and estimate the error from the same samples. Work is bounded: at
// most 30 halvings towards a cusp.
double arc_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0, double relative_tolerance = kFinestTolerance);
LengthEstimate measure_arc_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0,
                                  double relative_tolerance = kFinestTolerance);

// Writes arc_length(cubics[i], 0, 1, relative_tolerance) for all i into `lengths`, which has the same size. For display
// only, not for hashed values: the last bits depend on the processor. With AVX2 four segments at once, else one by one;
// arc_length() measures segments again whose error estimate fails.
void arc_lengths(std::span<const Cubic> cubics, double relative_tolerance, std::span<double> lengths);

// The parameters of the minima of |B'|: at most two, ascending.
struct SpeedMinima {
  std::array<double, 2> t{};
  int count = 0;
};

// The arc length of a cubic and its inverse. Immutable; 33 knots of s over uniform t.
class ArcLengthMap {
 public:
  ArcLengthMap() = default;
  explicit ArcLengthMap(const Cubic& cubic);

  double length() const { return table_.back(); }  // metres

  // Returns t in [0,1] at arc length s from the start; s is clamped to [0,length]. Looks up the table, then runs Newton
  // inside a bisection bracket (at most 60 steps): |s(t) - s| is below 1e-10 m or 1e-12 of the length. Returns 0 for a
  // segment of zero length.
  double parameter(double s) const;

  // Returns the arc length in metres from 0 to t, t in [0,1].
  double distance(double t) const;

 private:
  static constexpr int kIntervals = 32;
  double partial(int interval, double t) const;  // length from the interval's start to t within it

  CoefficientsD c_{};
  std::array<double, kIntervals + 1> table_{};
  SpeedMinima slow_;
  std::uint32_t rough_ = 0;  // bit i: interval i needs the adaptive rule (near a cusp)
};

}  // namespace coaster::curve
