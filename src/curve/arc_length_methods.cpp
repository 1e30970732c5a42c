// The table of arc-length methods to compare, one row each.
#include <array>

#include "curve/arc_length_detail.h"
#include "curve/quadrature.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

LengthEstimate counted(double length, int evaluations) { return {length, -1.0, evaluations}; }

detail::Hodograph whole(const Cubic& cubic) { return detail::hodograph(coefficients_d(cubic), 0.0, 1.0); }

LengthEstimate gauss_legendre(const Cubic& cubic, const LengthDemand& demand) {
  return measure_arc_length(cubic, 0.0, 1.0, demand.tolerance);
}

LengthEstimate gravesen(const Cubic& cubic, const LengthDemand&) {
  // Paper erratum: half the polygon "multiplied by" the chord is in square metres. The estimate is their mean; its
  // error is at most half their difference.
  const detail::Hodograph h = whole(cubic);
  const double chord = detail::chord_length(h), polygon = detail::polygon_length(h);
  return {0.5 * (chord + polygon), std::max(0.0, 0.5 * (polygon - chord)) + 1e-15 * polygon, 4};
}

LengthEstimate chord_sum(const Cubic& cubic, const LengthDemand& demand) {
  double sum = 0;
  dvec3 last(cubic.p0);
  for (int i = 1; i <= demand.count; ++i) {
    const dvec3 next = point(cubic, static_cast<double>(i) / demand.count);
    sum += glm::length(next - last);
    last = next;
  }
  return counted(sum, demand.count);
}

LengthEstimate simpson(const Cubic& cubic, const LengthDemand& demand) {
  const CoefficientsD c = coefficients_d(cubic);
  const int n = demand.count + demand.count % 2;  // Simpson's rule needs pairs of intervals
  double sum = c.speed(0) + c.speed(1);
  for (int i = 1; i < n; ++i) sum += (i % 2 ? 4.0 : 2.0) * c.speed(static_cast<double>(i) / n);
  return counted(sum / (3.0 * n), n + 1);
}

LengthEstimate trapezium(const Cubic& cubic, const LengthDemand& demand) {
  const CoefficientsD c = coefficients_d(cubic);
  double sum = 0.5 * (c.speed(0) + c.speed(1));
  for (int i = 1; i < demand.count; ++i) sum += c.speed(static_cast<double>(i) / demand.count);
  return counted(sum / demand.count, demand.count + 1);
}

LengthEstimate riemann(const Cubic& cubic, const LengthDemand& demand) {
  const CoefficientsD c = coefficients_d(cubic);
  double sum = 0;
  for (int i = 0; i < demand.count; ++i) sum += c.speed(static_cast<double>(i) / demand.count);
  return counted(sum / demand.count, demand.count);
}

// One rule of up to kMaxRule nodes over the whole curve; more nodes are divided among equal panels.
LengthEstimate by_panels(const Cubic& cubic, int count, Rule (*rule_of)(int)) {
  const CoefficientsD c = coefficients_d(cubic);
  const int panels = (count + kMaxRule - 1) / kMaxRule;
  const Rule rule = rule_of((count + panels - 1) / panels);
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const double a = static_cast<double>(p) / panels, b = static_cast<double>(p + 1) / panels;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      sum += rule.weights[i] * c.speed(0.5 * ((a + b) + (b - a) * rule.nodes[i]));
  }
  return counted(sum / (2.0 * panels), panels * static_cast<int>(rule.nodes.size()));
}

LengthEstimate gauss_legendre_fixed(const Cubic& cubic, const LengthDemand& demand) {
  return by_panels(cubic, demand.count, gauss_legendre_rule);
}
LengthEstimate clenshaw_curtis(const Cubic& cubic, const LengthDemand& demand) {
  return by_panels(cubic, demand.count, clenshaw_curtis_rule);
}

double clamped(double tolerance) { return std::clamp(tolerance, kFinestTolerance, 0.1); }

LengthEstimate gravesen_adaptive(const Cubic& cubic, const LengthDemand& demand) {
  return detail::adaptive_gravesen(whole(cubic), clamped(demand.tolerance));
}
LengthEstimate simpson_adaptive(const Cubic& cubic, const LengthDemand& demand) {
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

}  // namespace coaster::curve
