// The table of arc-length methods to compare, one row each, and the study of their convergence.
#include <algorithm>
#include <array>

#include "curve/arc_length_detail.h"
#include "curve/arc_length_study.h"
#include "curve/quadrature.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

LengthEstimate counted(double length, int evaluations) { return {length, -1.0, evaluations}; }

detail::Hodograph whole(const Cubic& cubic) { return detail::hodograph(coefficients_d(cubic), 0.0, 1.0); }

LengthEstimate gauss_legendre(const Cubic& cubic, const LengthAccuracy& demand) {
  return measure_arc_length(cubic, 0.0, 1.0, demand.tolerance);
}

LengthEstimate gravesen(const Cubic& cubic, const LengthAccuracy&) {
  // Paper erratum: half the polygon "multiplied by" the chord is in square metres. The estimate is their mean; its
  // error is at most half their difference.
  const detail::Hodograph h = whole(cubic);
  const double chord = detail::chord_length(h), polygon = detail::polygon_length(h);
  return {0.5 * (chord + polygon), std::max(0.0, 0.5 * (polygon - chord)) + 1e-15 * polygon, 4};
}

LengthEstimate chord_sum(const Cubic& cubic, const LengthAccuracy& demand) {
  double sum = 0;
  dvec3 last(cubic.p0);
  for (int i = 1; i <= demand.count; ++i) {
    const dvec3 next = point(cubic, static_cast<double>(i) / demand.count);
    sum += glm::length(next - last);
    last = next;
  }
  return counted(sum, demand.count);
}

LengthEstimate simpson(const Cubic& cubic, const LengthAccuracy& demand) {
  const CoefficientsD c = coefficients_d(cubic);
  const int n = demand.count + demand.count % 2;  // Simpson's rule needs pairs of intervals
  double sum = c.speed(0) + c.speed(1);
  for (int i = 1; i < n; ++i) sum += (i % 2 ? 4.0 : 2.0) * c.speed(static_cast<double>(i) / n);
  return counted(sum / (3.0 * n), n + 1);
}

LengthEstimate trapezium(const Cubic& cubic, const LengthAccuracy& demand) {
  const CoefficientsD c = coefficients_d(cubic);
  double sum = 0.5 * (c.speed(0) + c.speed(1));
  for (int i = 1; i < demand.count; ++i) sum += c.speed(static_cast<double>(i) / demand.count);
  return counted(sum / demand.count, demand.count + 1);
}

LengthEstimate riemann(const Cubic& cubic, const LengthAccuracy& demand) {
  const CoefficientsD c = coefficients_d(cubic);
  double sum = 0;
  for (int i = 0; i < demand.count; ++i) sum += c.speed(static_cast<double>(i) / demand.count);
  return counted(sum / demand.count, demand.count);
}

// One rule of up to kMaxRule nodes over the whole curve; more nodes are divided among equal panels.
LengthEstimate by_panels(const Cubic& cubic, int count, QuadratureRule (*rule_of)(int)) {
  const CoefficientsD c = coefficients_d(cubic);
  const int panels = (count + kMaxRule - 1) / kMaxRule;
  const QuadratureRule rule = rule_of((count + panels - 1) / panels);
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const double a = static_cast<double>(p) / panels, b = static_cast<double>(p + 1) / panels;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      sum += rule.weights[i] * c.speed(0.5 * ((a + b) + (b - a) * rule.nodes[i]));
  }
  return counted(sum / (2.0 * panels), panels * static_cast<int>(rule.nodes.size()));
}

LengthEstimate gauss_legendre_fixed(const Cubic& cubic, const LengthAccuracy& demand) {
  return by_panels(cubic, demand.count, gauss_legendre_rule);
}
LengthEstimate clenshaw_curtis(const Cubic& cubic, const LengthAccuracy& demand) {
  return by_panels(cubic, demand.count, clenshaw_curtis_rule);
}

double clamped(double tolerance) { return std::clamp(tolerance, kFinestTolerance, 0.1); }

LengthEstimate gravesen_adaptive(const Cubic& cubic, const LengthAccuracy& demand) {
  return detail::adaptive_gravesen(whole(cubic), clamped(demand.tolerance));
}
LengthEstimate simpson_adaptive(const Cubic& cubic, const LengthAccuracy& demand) {
  return detail::adaptive_simpson(whole(cubic), clamped(demand.tolerance));
}

using enum LengthControl;
constexpr std::array<ArcLengthMethod, 10> kMethods{{
    {"gauss_legendre", "Gauss-Legendre, adaptive", "sum of w_i |B'(t_i)|, 16 nodes, halved until 8 nodes agree",
     tolerance, LengthBound::estimated, 1e-12, gauss_legendre},
    {"gravesen", "Gravesen's mean", "(chord + control polygon) / 2", none, LengthBound::guaranteed, 0, gravesen},
    {"chord_sum", "Chords of the polyline", "sum of |B(t_(i+1)) - B(t_i)|", count, LengthBound::none, 0, chord_sum},
    {"simpson", "Simpson", "h/3 (f_0 + 4 f_1 + 2 f_2 + ... + f_n), f = |B'|", count, LengthBound::none, 0, simpson},
    {"trapezium", "Trapezium", "h (f_0/2 + f_1 + ... + f_n/2), f = |B'|", count, LengthBound::none, 0, trapezium},
    {"riemann", "Riemann (left)", "h (f_0 + f_1 + ... + f_(n-1)), f = |B'|", count, LengthBound::none, 0, riemann},
    {"gauss_legendre_fixed", "Gauss-Legendre, n nodes", "sum of w_i |B'(t_i)|, t_i at the roots of Legendre's P_n",
     count, LengthBound::none, 0, gauss_legendre_fixed},
    {"clenshaw_curtis", "Clenshaw-Curtis", "sum of w_i |B'(t_i)|, t_i = (1 - cos(i pi/n)) / 2", count,
     LengthBound::none, 0, clenshaw_curtis},
    {"gravesen_adaptive", "Gravesen, adaptive",
     "sum of (chord + polygon) / 2, halved until sum of (polygon - chord) / 2 is small", tolerance,
     LengthBound::guaranteed, 1e-6, gravesen_adaptive},
    {"simpson_adaptive", "Simpson, adaptive", "Simpson's rule, halved until |S_2 - S_1| / 15 is small", tolerance,
     LengthBound::estimated, 1e-9, simpson_adaptive},
}};

}  // namespace

std::span<const ArcLengthMethod> arc_length_methods() { return kMethods; }

namespace {

struct Vector {
  long double x, y, z;
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator*(long double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
};
long double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector leg(glm::vec3 from, glm::vec3 to) {
  const auto part = [&](int axis) {
    return 3.0L * (static_cast<long double>(to[axis]) - static_cast<long double>(from[axis]));
  };
  return {part(0), part(1), part(2)};
}

// As detail::Hodograph, in long double.
struct LongDoubleHodograph {
  Vector v0, v1, v2;
};

LongDoubleHodograph part_of(const LongDoubleHodograph& h, long double a, long double b) {
  const auto blossom = [&](long double s, long double t) {
    return (1 - s) * ((1 - t) * h.v0 + t * h.v1) + s * ((1 - t) * h.v1 + t * h.v2);
  };
  return {(b - a) * blossom(a, a), (b - a) * blossom(a, b), (b - a) * blossom(b, b)};
}

long double polygon(const LongDoubleHodograph& h) {
  return (sqrtl(dot(h.v0, h.v0)) + sqrtl(dot(h.v1, h.v1)) + sqrtl(dot(h.v2, h.v2))) / 3;
}

bool is_steady(const LongDoubleHodograph& h) {
  const Vector m = h.v0 + h.v1 + h.v2;
  const long double least = std::min({dot(h.v0, m), dot(h.v1, m), dot(h.v2, m)});
  const long double most = std::max({dot(h.v0, h.v0), dot(h.v1, h.v1), dot(h.v2, h.v2)});
  return least > 0 && least * least >= 0.16L * most * dot(m, m);
}

// Steady pieces (speed above 0.4 of the maximum) need no estimate: the error of 40 nodes is below 1e-18 there.
long double measure(const LongDoubleHodograph& h, long double floor, int depth) {
  if (!is_steady(h) && depth < 40) {
    const long double all = polygon(h);
    if (!(all > floor)) return all;
    return measure(part_of(h, 0, 0.5L), floor, depth + 1) + measure(part_of(h, 0.5L, 1), floor, depth + 1);
  }
  const RuleLongDouble rule = gauss_legendre_rule_long_double(40);
  long double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const long double t = (1 + rule.nodes[i]) / 2, s = 1 - t;
    const Vector v = (s * s) * h.v0 + (2 * s * t) * h.v1 + (t * t) * h.v2;
    sum += rule.weights[i] * sqrtl(dot(v, v));
  }
  return sum / 2;
}

double relative(double length, long double reference) {
  if (!(reference > 0)) return kSmallestError;
  return std::max(kSmallestError, static_cast<double>(fabsl(static_cast<long double>(length) - reference) / reference));
}

std::vector<ConvergencePoint> study(const ArcLengthMethod& row, const Cubic& cubic, std::int64_t most,
                                    long double reference) {
  std::vector<ConvergencePoint> points;
  const auto add = [&](const LengthAccuracy& demand) {
    const LengthEstimate estimate = row.measure(cubic, demand);
    if (estimate.evaluations > most) return false;
    points.push_back({estimate.evaluations, relative(estimate.length, reference)});
    return true;
  };
  switch (row.control) {
    case LengthControl::none: add({}); break;
    case LengthControl::count:
      for (int count = 1; count <= 4096 && add({count, 1e-9}); count *= 2) {
      }
      break;
    case LengthControl::tolerance: {
      double tolerance = 0.1;
      for (int digits = 1; digits <= 12 && add({64, tolerance}); ++digits)
        tolerance = digits == 11 ? kFinestTolerance : tolerance / 10;
      break;
    }
  }
  // A finer tolerance may take a larger rule with fewer evaluations. Sort, so that the plot does not run backwards.
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.evaluations < b.evaluations; });
  return points;
}

}  // namespace

long double reference_length(const Cubic& c, double t0, double t1) {
  const LongDoubleHodograph whole{leg(c.p0, c.p1), leg(c.p1, c.p2), leg(c.p2, c.p3)};
  const LongDoubleHodograph part = part_of(whole, t0, t1);
  return measure(part, 1e-18L * polygon(part), 0);
}

std::vector<Convergence> convergence(const Cubic& cubic, std::int64_t most) {
  const long double reference = reference_length(cubic);
  std::vector<Convergence> all;
  for (std::size_t i = 0; i < arc_length_methods().size(); ++i)
    all.push_back({static_cast<ArcLengthId>(i), study(arc_length_methods()[i], cubic, most, reference)});
  return all;
}

std::vector<LengthComparison> compare_lengths(const Cubic& cubic, const LengthAccuracy& demand) {
  return compare_lengths(std::span<const Cubic>(&cubic, 1), demand);
}

std::vector<LengthComparison> compare_lengths(std::span<const Cubic> cubics, const LengthAccuracy& demand) {
  long double reference = 0;
  for (const Cubic& cubic : cubics) reference += reference_length(cubic);
  std::vector<LengthComparison> all;
  for (std::size_t i = 0; i < arc_length_methods().size(); ++i) {
    const ArcLengthMethod& row = arc_length_methods()[i];
    LengthComparison sum{static_cast<ArcLengthId>(i), 0, 0, 0, row.bound == LengthBound::none ? -1.0 : 0.0, 0};
    long double length = 0;
    for (const Cubic& cubic : cubics) {
      const LengthEstimate estimate =
          row.measure(cubic, {demand.count, std::max(demand.tolerance, row.usual_tolerance)});
      length += estimate.length;
      sum.evaluations += estimate.evaluations;
      if (row.bound != LengthBound::none) sum.error_bound += estimate.error_bound;
    }
    sum.length = static_cast<double>(length);
    sum.error = static_cast<double>(length - reference);
    sum.relative_error = reference > 0 ? static_cast<double>(fabsl(length - reference) / reference) : 0.0;
    all.push_back(sum);
  }
  return all;
}

}  // namespace coaster::curve
