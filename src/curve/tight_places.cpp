#include "curve/tight_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "curve/frames.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A polynomial by its coefficients, and the product, of at most degree 7.
using Polynomial = std::array<double, 8>;
void add_product(const Polynomial& a, const Polynomial& b, double factor, Polynomial& sum) {
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; i + j < 8; ++j) sum[i + j] += factor * a[i] * b[j];
}
Polynomial slope_of(const Polynomial& a) {
  Polynomial slope{};
  for (std::size_t i = 1; i < 8; ++i) slope[i - 1] = static_cast<double>(i) * a[i];
  return slope;
}
// Returns |a + t b + t^2 c|^2.
Polynomial square_of(dvec3 a, dvec3 b, dvec3 c) {
  return {dot(a, a), 2 * dot(a, b), dot(b, b) + 2 * dot(a, c), 2 * dot(b, c), dot(c, c)};
}

// Returns the polynomial's coefficients in Bernstein's basis of degree 7.
Polynomial bernstein_of(const Polynomial& a) {
  Polynomial b{};
  for (std::size_t i = 0; i < 8; ++i) {
    double share = 1;  // C(i,j) / C(7,j)
    for (std::size_t j = 0; j <= i; ++j) {
      b[i] += share * a[j];
      share *= static_cast<double>(i - j) / static_cast<double>(7 - std::min<std::size_t>(j, 6));
    }
  }
  return b;
}

// Appends the roots between two parameters of a polynomial with the coefficients `b` in Bernstein's basis there. Where
// they change sign once there is one root (Descartes' rule), found by halving with `value`, which may be more accurate.
template <class Value>
void add_roots(Polynomial b, double from, double to, const Value& value, std::vector<double>& out) {
  constexpr double kSplit = 0.4871, kClosest = 1e-12;  // the split avoids the middles of symmetric curves
  int changes = 0;
  double last = 0;
  for (const double x : b) {
    if (x == 0) continue;
    changes += x * last < 0;
    last = x;
  }
  if (changes == 0) return;
  if (changes == 1 || to - from < kClosest) {
    const bool rises = value(from) < value(to);
    for (int i = 0; i < 60 && from < to; ++i) {
      const double middle = 0.5 * (from + to);
      ((value(middle) < 0) == rises ? from : to) = middle;
    }
    out.push_back(0.5 * (from + to));
    return;
  }
  Polynomial left;
  for (std::size_t level = 0; level < 8; ++level) {
    left[level] = b[0];
    for (std::size_t i = 0; i + level + 1 < 8; ++i) b[i] += kSplit * (b[i + 1] - b[i]);
  }
  const double middle = from + kSplit * (to - from);
  if (b[0] == 0) out.push_back(middle);
  add_roots(left, from, middle, value, out);
  add_roots(b, middle, to, value, out);
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

// Sets the place to a reversal if it is one.
void find_reversal(const Cubic& cubic, const CoefficientsD& k, double rounding, TightPlace& place) {
  if (!(place.t > 0 && place.t < 1) || !(k.speed(place.t) <= rounding)) return;
  const double second = glm::length(k.second_derivative(place.t)), room = std::min(place.t, 1 - place.t);
  const double half = second > 0 ? std::min(4 * rounding / second, room) : room;
  if (!(dot(k.derivative(place.t - half), k.derivative(place.t + half)) < 0)) return;
  // Outside of `half` the rounding's curvature k has an integral of k^2 below 1e-3 /m.
  place = {place.t, 0, true, std::min(std::max(half, rounding * std::sqrt(500 / second)), room), 0};
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
  const Polynomial n = square_of(binormal.b0, binormal.b1, binormal.b2), d = square_of(k.c1, 2.0 * k.c2, 3.0 * k.c3),
                   d_slope = slope_of(d);
  Polynomial extremes{};
  add_product(slope_of(n), d, 1, extremes), add_product(n, d_slope, -3, extremes);
  const auto slowing = [&](double t) {  // D' / 2
    return dot(k.derivative(t), k.second_derivative(t));
  };
  std::vector<double> at{0, 1};
  add_roots(bernstein_of(d_slope), 0, 1, slowing, at);
  add_roots(
      bernstein_of(extremes), 0, 1,
      [&](double t) {
        const dvec3 first = k.derivative(t), second = k.second_derivative(t), b = cross(first, second);
        return dot(b, cross(first, 6.0 * k.c3)) * dot(first, first) - 3 * dot(b, b) * slowing(t);
      },
      at);
  std::ranges::sort(at);
  float largest = 0;
  for (const glm::vec3& p : {cubic.p0, cubic.p1, cubic.p2, cubic.p3})
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  // Each control point is off by half an ulp, B' by six times that on three axes; a knot's tangent adds as much.
  const double rounding = 20 * 0x1p-24 * double{largest};
  std::vector<TightPlace> all, found;
  for (const double t : at) {
    all.push_back({t, radius_at(cubic, t)});
    if (!(k.speed(t) > 0)) all.back().radius = kInfinite;
    find_reversal(cubic, k, rounding, all.back());
  }
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
