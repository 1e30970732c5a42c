#include "curve/tight_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/numerics.h"
#include "curve/carried_frame.h"
#include "curve/polynomial_roots.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Returns half the slope of the square of the length of the quadratic with these controls, in Bernstein form.
std::array<double, 4> slope_of_square(const std::array<dvec3, 3>& h) {
  return product(h, std::array{h[1] - h[0], h[2] - h[1]});
}

// Calls found(t) for the roots of a polynomial, halved with `value`, which may be more accurate.
template <std::size_t N, class Value, class Found>
void each_root_of(const std::array<double, N>& c, const Value& value, const Found& found) {
  each_crossing(c, 0, 1, [&](Bracket at, bool rising) {
    found(base::bisect({at.low, at.high}, 60, [&](double t) { return (value(t) < 0) == rising; }).middle());
  });
}

// True if the radius is at least `limit` between two parameters by the bounds of |B'| and |B' x B''| that Bernstein's
// coefficients give there, or in halves of that; `false` decides nothing.
bool is_gentle(const CoefficientsD& k, const BinormalCurve& bend, double limit, double a, double b, int halvings = 5) {
  const dvec3 first[] = {k.derivative(a), k.c1 + (a + b) * k.c2 + 3 * a * b * k.c3, k.derivative(b)};
  const dvec3 along = first[0] + first[1] + first[2];
  const double slowest = std::min({dot(first[0], along), dot(first[1], along), dot(first[2], along)});
  if (slowest > 0) {
    const dvec3 middle = bend.b0 + 0.5 * (a + b) * bend.b1 + a * b * bend.b2, from = bend.at(a), to = bend.at(b);
    const double most = std::max({dot(from, from), dot(middle, middle), dot(to, to)}), square = dot(along, along);
    const double speed = slowest * slowest / square;  // a bound of |B'|^2
    if (speed * speed * speed >= limit * limit * most) return true;
  }
  const double half = 0.5 * (a + b);
  return halvings > 0 && is_gentle(k, bend, limit, a, half, halvings - 1) &&
         is_gentle(k, bend, limit, half, b, halvings - 1);
}

}  // namespace

double radius_at(const Cubic& cubic, double t) {
  const CoefficientsD k = coefficients_d(cubic);
  const double speed = k.speed(t), bend = glm::length(cross(k.derivative(t), k.second_derivative(t)));
  return bend > 0 ? speed * speed * speed / bend : speed > 0 ? kInfinite : 0;
}

std::vector<TightPlace> tight_places(const Cubic& cubic, double limit) {
  const CoefficientsD k = coefficients_d(cubic);
  const BinormalCurve binormal = binormal_curve(cubic);
  if (is_gentle(k, binormal, limit, 0, 1)) return {};
  // The radius has its extremes where k^2 = N / D^3 has: N' D = 3 N D'. The minima of D mark what is sharpest, where
  // that polynomial is worst conditioned.
  const std::array d{k.derivative(0), k.c1 + k.c2, k.derivative(1)},
      b{binormal.b0, binormal.b0 + 0.5 * binormal.b1, binormal.at(1)};
  const auto n_slope = slope_of_square(b), d_slope = slope_of_square(d);
  std::array<double, 8> extremes = product(n_slope, product(d, d));
  const auto other = product(product(b, b), d_slope);
  for (std::size_t i = 0; i < extremes.size(); ++i) extremes[i] -= 3 * other[i];
  const auto slowing = [&](double t) { return dot(k.derivative(t), k.second_derivative(t)); };  // D' / 2
  float largest = 0;
  for (const glm::vec3& p : {cubic.p0, cubic.p1, cubic.p2, cubic.p3})
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  // Each control point is off by half an ulp, B' by six times that on three axes; a knot's tangent adds as much.
  const double rounding = 20 * 0x1p-24 * double{largest};
  std::vector<TightPlace> all, found;
  const auto add = [&](double t) {
    all.push_back({t, k.speed(t) > 0 ? radius_at(cubic, t) : kInfinite});
    if (const auto half = reversal(k, t, rounding)) {
      // Outside of it the rounding's curvature k has an integral of k^2 below 1e-3 /m.
      const double rough = rounding * std::sqrt(500 / glm::length(k.second_derivative(t)));
      all.back() = {t, 0, true, std::min({std::max(*half, rough), t, 1 - t}), 0};
    }
  };
  add(0), add(1);
  each_root_of(d_slope, slowing, add);
  const std::vector<TightPlace> slowest = all;
  each_root_of(
      extremes,
      [&](double t) {
        const dvec3 first = k.derivative(t), second = k.second_derivative(t), bend = cross(first, second);
        return dot(bend, cross(first, 6.0 * k.c3)) * dot(first, first) - 3 * dot(bend, bend) * slowing(t);
      },
      [&](double t) {  // near a reversal it is rounding
        if (std::ranges::none_of(slowest, [&](const TightPlace& p) { return std::abs(t - p.t) <= p.half; })) add(t);
      });
  std::ranges::sort(all, {}, &TightPlace::t);
  const auto same = [](const TightPlace& x, const TightPlace& y) { return y.t - x.t < 1e-14; };  // of a multiple root
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double before = i > 0 ? all[i - 1].radius : kInfinite,
                 after = i + 1 < all.size() ? all[i + 1].radius : kInfinite;
    const bool least = all[i].radius < before && all[i].radius <= after;
    if (least && (all[i].reversal || all[i].radius < limit)) found.push_back(all[i]);
    if (!found.empty()) found.back().apart = std::max(found.back().apart, all[i].radius);
  }
  return found;
}

}  // namespace coaster::curve
