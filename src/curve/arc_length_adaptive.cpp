// The arc-length methods that subdivide until they meet a relative tolerance: Gauss-Legendre with an embedded estimate,
// Simpson, Gravesen. The default rule, whose bits the ride depends on, is in arc_length.cpp.
#include "curve/arc_length_detail.h"
#include "curve/quadrature.h"

namespace coaster::curve::detail {
namespace {

template <int kHalf>
EmbeddedRule<kHalf> make_embedded() {
  constexpr int kNodes = 2 * kHalf;
  const RuleLongDouble full = gauss_legendre_rule_long_double(kNodes);
  EmbeddedRule<kHalf> rule{};
  for (std::size_t i = 0; i < kHalf; ++i) {
    // a_k = (2k+1)/2 sum w P_k(x) f(x), and the integral over the piece is half of that over [-1,1].
    const long double x = full.nodes[kHalf + i], w = full.weights[kHalf + i] / 2;
    rule.x[i] = static_cast<double>(x);
    rule.weight[i] = static_cast<double>(w);
    const auto coefficient = [&](int k) { return static_cast<double>((2 * k + 1) * w * legendre(k, x)); };
    rule.odd[0][i] = coefficient(kNodes - 1);
    rule.even[0][i] = coefficient(kNodes - 2);
    rule.odd[1][i] = coefficient(kNodes - 3);
    rule.even[1][i] = coefficient(kNodes - 4);
  }
  return rule;
}

constexpr int kMaxDepth = 30;

// --- Gauss-Legendre -------------------------------------------------------------------------------------------------

template <int kHalf>
struct GaussLegendre {
  double tolerance, floor;
  const EmbeddedRule<kHalf>& rule;
  LengthEstimate total{0, 0, 0};

  void add(const Hodograph& h, int depth) {
    if (steadiness(h) >= kSteadyEnough) {
      const SampledLength s = sample(speed_quartic(h), rule);
      const double error = estimated_error(s);
      total.evaluations += 2 * kHalf;
      if (error <= std::max(tolerance * s.length, floor) || depth >= kMaxDepth) return accept(s.length, error);
    } else {
      // Unsteady pieces are halved without evaluation until the rest about a cusp is negligibly short.
      const double polygon = polygon_length(h);
      total.evaluations += 3;
      if (!(polygon > floor) || depth >= kMaxDepth) {
        const double chord = chord_length(h);
        return accept(0.5 * (chord + polygon), 0.5 * (polygon - chord));
      }
    }
    const Halves half = halves(h);
    add(half.left, depth + 1);
    add(half.right, depth + 1);
  }

  void accept(double length, double error) {
    total.length += length;
    total.error_bound += error;
  }
};

template <int kHalf>
LengthEstimate gauss_legendre(const Hodograph& h, double tolerance, const EmbeddedRule<kHalf>& rule) {
  GaussLegendre<kHalf> pieces{tolerance, 0.0, rule};
  // Most pieces of a track pass at once and need no floor.
  if (steadiness(h) >= kSteadyEnough) {
    const SampledLength s = sample(speed_quartic(h), rule);
    const double error = estimated_error(s);
    if (error <= tolerance * s.length) return {s.length, error + 1e-15 * s.length, 2 * kHalf};
    pieces.total.evaluations = 2 * kHalf;
  }
  pieces.floor = tolerance * polygon_length(h) / 64.0;
  const Halves half = halves(h);
  pieces.add(half.left, 1);
  pieces.add(half.right, 1);
  pieces.total.error_bound += 1e-15 * pieces.total.length;  // rounding
  return pieces.total;
}

// --- Simpson --------------------------------------------------------------------------------------------------------

struct Simpson {
  SpeedQuartic q;
  LengthEstimate total{0, 0, 0};

  double speed(double u) {
    ++total.evaluations;
    return speed_at(q, u);
  }

  // [a,b] in u, with |v| at a, the middle and b; `allowed` halves with the interval. Lyness 1969
  // (doi 10.1145/321526.321537).
  void add(double a, double b, double fa, double fm, double fb, double whole, double allowed, int depth) {
    const double m = 0.5 * (a + b), fl = speed(0.5 * (a + m)), fr = speed(0.5 * (m + b)), w = (b - a) / 24.0;
    const double left = w * (fa + 4.0 * fl + fm), right = w * (fm + 4.0 * fr + fb),
                 excess = (left + right - whole) / 15.0;
    if (depth >= kMaxDepth || (depth >= 2 && std::abs(excess) <= allowed)) {
      total.length += left + right + excess;
      total.error_bound += std::abs(excess);
      return;
    }
    add(a, m, fa, fl, fm, left, 0.5 * allowed, depth + 1);
    add(m, b, fm, fr, fb, right, 0.5 * allowed, depth + 1);
  }
};

// --- Gravesen -------------------------------------------------------------------------------------------------------

struct Gravesen {
  LengthEstimate total{0, 0, 0};
  // 2^14 pieces: about a millisecond. Finer tolerances are not met; the bound says so.
  static constexpr int kDepth = 14;

  // Gravesen 1997, doi 10.1016/0925-7721(95)00054-2: chord <= length <= polygon, so the error of their mean is at most
  // half the difference.
  void add(const Hodograph& h, double allowed, int depth) {
    const double chord = chord_length(h), polygon = polygon_length(h), bound = 0.5 * (polygon - chord);
    total.evaluations += 4;
    if (!(bound > allowed) || depth >= kDepth) {
      total.length += 0.5 * (chord + polygon);
      total.error_bound += std::max(0.0, bound);
      return;
    }
    const Halves half = halves(h);
    add(half.left, 0.5 * allowed, depth + 1);
    add(half.right, 0.5 * allowed, depth + 1);
  }
};

}  // namespace

template <int kHalf>
const EmbeddedRule<kHalf>& embedded_rule() {
  static const EmbeddedRule<kHalf> rule = make_embedded<kHalf>();
  return rule;
}
template const EmbeddedRule<5>& embedded_rule<5>();
template const EmbeddedRule<7>& embedded_rule<7>();
template const EmbeddedRule<10>& embedded_rule<10>();
template const EmbeddedRule<12>& embedded_rule<12>();

LengthEstimate adaptive_gauss_legendre(const Hodograph& h, double tolerance) {
  return with_rule_for(tolerance, [&](const auto& rule) { return gauss_legendre(h, tolerance, rule); });
}

LengthEstimate adaptive_simpson(const Hodograph& h, double tolerance) {
  Simpson simpson{speed_quartic(h)};
  const double a = simpson.speed(-1), m = simpson.speed(0), b = simpson.speed(1), whole = (a + 4.0 * m + b) / 6.0;
  if (whole > 0.0) simpson.add(-1, 1, a, m, b, whole, tolerance * whole, 0);
  return simpson.total;
}

LengthEstimate adaptive_gravesen(const Hodograph& h, double tolerance) {
  Gravesen gravesen;
  gravesen.add(h, tolerance * 0.5 * (chord_length(h) + polygon_length(h)), 0);
  gravesen.total.error_bound += 1e-14 * gravesen.total.length;  // rounding of up to 2^14 sums
  return gravesen.total;
}

}  // namespace coaster::curve::detail
