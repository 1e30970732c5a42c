// Shared by the arc-length methods, not part of the room's interface: a piece of a cubic as the control vectors of its
// hodograph, the quartic |B'|^2 about its middle, and Gauss-Legendre with an error estimate from its own samples.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "curve/arc_length.h"

namespace coaster::curve::detail {

// B' over a piece, scaled by the piece's fraction of the parameter: v(x) = v0 (1-x)^2 + 2 v1 x (1-x) + v2 x^2 with x in
// [0,1], so that the integral of |v| is the piece's length. v0/3, v1/3, v2/3 are the legs of its control polygon.
struct Hodograph {
  glm::dvec3 v0, v1, v2;
};

inline Hodograph hodograph(const CoefficientsD& c, double a, double b) {
  const double w = b - a;
  const glm::dvec3 first = c.derivative(a), last = c.derivative(b);
  return {w * first, w * (first + w * (c.c2 + (3.0 * a) * c.c3)), w * last};
}

inline double polygon_length(const Hodograph& h) {
  return (glm::length(h.v0) + glm::length(h.v1) + glm::length(h.v2)) / 3.0;
}
inline double chord_length(const Hodograph& h) { return glm::length(h.v0 + h.v1 + h.v2) / 3.0; }

struct Halves {
  Hodograph left, right;
};
// Splits the hodograph at the middle by de Casteljau. Each half is scaled by 1/2, so that their lengths add up.
inline Halves halves(const Hodograph& h) {
  const glm::dvec3 a = 0.25 * (h.v0 + h.v1), b = 0.25 * (h.v1 + h.v2), middle = 0.5 * (a + b);
  return {{0.5 * h.v0, a, middle}, {middle, b, 0.5 * h.v2}};
}

// Returns a lower bound of min |v| / max |v| along the chord: 1 for a straight of even speed, 0 or less if the
// hodograph may pass near 0 (the curve may nearly stop). |v| >= steadiness * max |v| everywhere, because v is in the
// hull of v0, v1, v2.
inline double steadiness(const Hodograph& h) {
  const glm::dvec3 m = h.v0 + h.v1 + h.v2;
  const double least = std::min({glm::dot(h.v0, m), glm::dot(h.v1, m), glm::dot(h.v2, m)});
  const double most = std::max({glm::dot(h.v0, h.v0), glm::dot(h.v1, h.v1), glm::dot(h.v2, h.v2)});
  const double scale = std::sqrt(most * glm::dot(m, m));
  return scale > 0.0 ? least / scale : 0.0;
}

// |v|^2 at x = (1 +- u)/2 is (e0 + u^2 (e2 + u^2 e4)) +- u (o1 + u^2 o3): two values for little more than the cost of
// one.
struct SpeedQuartic {
  double e0, o1, e2, o3, e4;
};
inline SpeedQuartic speed_quartic(const Hodograph& h) {
  const glm::dvec3 w0 = 0.25 * (h.v0 + 2.0 * h.v1 + h.v2), w1 = 0.5 * (h.v2 - h.v0),
                   w2 = 0.25 * (h.v0 - 2.0 * h.v1 + h.v2);
  return {glm::dot(w0, w0), 2.0 * glm::dot(w0, w1), glm::dot(w1, w1) + 2.0 * glm::dot(w0, w2), 2.0 * glm::dot(w1, w2),
          glm::dot(w2, w2)};
}

// Returns the speed at u in [-1,1]. Rounding can make the quartic slightly negative where the curve stops.
inline double speed_at(const SpeedQuartic& q, double u) {
  return std::sqrt(std::max(0.0, q.e0 + u * (q.o1 + u * (q.e2 + u * (q.o3 + u * q.e4)))));
}

// The positive half of Gauss-Legendre with n = 2 * kHalf nodes. `even` and `odd` turn the sums and differences of the
// samples at +-x into the last four coefficients of their Legendre series, of degrees n-2, n-4 and n-1, n-3, in units
// of length.
template <int kHalf>
struct EmbeddedRule {
  std::array<double, kHalf> x, weight;
  std::array<std::array<double, kHalf>, 2> even, odd;
};
template <int kHalf>
const EmbeddedRule<kHalf>& embedded_rule();  // kHalf = 5, 7, 10, 12

struct SampledLength {
  double length;
  double last;  // the largest of the last four Legendre coefficients of the samples, as a length
};

template <int kHalf>
SampledLength sample(const SpeedQuartic& q, const EmbeddedRule<kHalf>& rule) {
  double sum = 0, even0 = 0, even1 = 0, odd0 = 0, odd1 = 0;
  for (std::size_t i = 0; i < kHalf; ++i) {
    const double u = rule.x[i], uu = u * u, e = q.e0 + uu * (q.e2 + uu * q.e4), o = u * (q.o1 + uu * q.o3);
    const double plus = std::sqrt(std::max(0.0, e + o)), minus = std::sqrt(std::max(0.0, e - o)), both = plus + minus,
                 change = plus - minus;
    sum += rule.weight[i] * both;
    even0 += rule.even[0][i] * both;
    even1 += rule.even[1][i] * both;
    odd0 += rule.odd[0][i] * change;
    odd1 += rule.odd[1][i] * change;
  }
  return {sum, std::max({std::abs(even0), std::abs(even1), std::abs(odd0), std::abs(odd1)})};
}

// Returns use(rule) with the rule for a relative tolerance: few enough nodes that most pieces of a track pass at once
// and none is expensive.
template <class Use>
auto with_rule_for(double tolerance, const Use& use) {
  if (tolerance >= 1e-4) return use(embedded_rule<5>());
  if (tolerance >= 1e-7) return use(embedded_rule<7>());
  return tolerance >= 1e-10 ? use(embedded_rule<10>()) : use(embedded_rule<12>());
}

// The Legendre series of |v| falls like r^k, and the error of n nodes like r^(2n): about the square of the last
// coefficients that the samples show. Four coefficients are used, because a symmetric speed has no odd ones and a
// complex pair of roots makes single ones vanish. The factor and kSteadyEnough are measured: over 300,000 pieces of all
// kinds the error of accepted pieces is below a tenth of the tolerance.
constexpr double kCoefficientFactor = 3.0, kSteadyEnough = 0.15;
inline double estimated_error(const SampledLength& s) {
  return s.length > 0.0 ? kCoefficientFactor * s.last * s.last / s.length : 0.0;
}

// The methods that subdivide. Each does bounded work for every cubic and tolerance.
LengthEstimate adaptive_gauss_legendre(const Hodograph& h, double tolerance);  // tolerance in [1e-12, 0.1]
LengthEstimate adaptive_simpson(const Hodograph& h, double tolerance);
LengthEstimate adaptive_gravesen(const Hodograph& h, double tolerance);

}  // namespace coaster::curve::detail
