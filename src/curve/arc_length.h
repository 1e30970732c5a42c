// Arc length of a cubic: a table of methods to compare, the adaptive Gauss-Legendre one that the ride relies on, and the
// inversion from arc length to parameter.
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

struct ArcLengthMethod {
  std::string_view name;   // "gauss_legendre"
  std::string_view label;  // "Gauss-Legendre, adaptive"
  std::string_view formula;
  // Length in metres. `steps` is the number of intervals where the method has one (polyline, Riemann, ...).
  double (*length)(const Cubic& cubic, int steps);
};

// Rows: adaptive Gauss-Legendre (the default, row 0), Gravesen's mean (Paper erratum: the paper has a product),
// chord sum of the polyline, Simpson, trapezium, Riemann.
std::span<const ArcLengthMethod> arc_length_methods();
const ArcLengthMethod& arc_length_method(ArcLengthId id);
std::optional<ArcLengthId> find_arc_length_method(std::string_view name);

// Integral of |B'| over [t0,t1], t0 <= t1, by adaptive Gauss-Legendre in double: relative error below 1e-12 for track-like
// cubics; subdivision is capped at 24 levels, so a cusp costs bounded work and at most 1e-9 relative. Cost: 24 evaluations of B' where nothing is subdivided.
double arc_length(const Cubic& cubic, double t0 = 0.0, double t1 = 1.0);

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
