#include "curve/carried_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "curve/polynomial_roots.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

constexpr double kBeside = 1e-8;  // of t: that near a cusp, unit_tangent() may return either direction

// B' over a step of length h from t: p + u (q + u r), u in [0,1].
struct HodographStep {
  dvec3 p, q, r;
  HodographStep(const CoefficientsD& c, double t, double h)
      : p(c.derivative(t)), q(h * c.second_derivative(t)), r(3.0 * h * h * c.c3) {}
  dvec3 chord() const { return p + 0.5 * q + (1.0 / 3.0) * r; }
};

// A step is exact where det(B', B'', B''') is 0: in a plane. Expanded by q and r its error is det(p, q, r) / |p|^3
// times terms of second order, at most this factor times |r|/|p| + |q|^2/|p|^2 where |q| + |r| <= |p|/2.
constexpr double kErrorFactor = 0.25;
double bounded(double det, double p, double q, double r) {
  if (det == 0) return 0;
  if (!(q + r <= 0.5 * p)) return std::numeric_limits<double>::infinity();
  return kErrorFactor * std::abs(det) * (r * p + q * q) / (p * p * p * p * p);
}

// Carries a frame over a stretch without a cusp inside to `end`, where the unit tangent is `last`.
Frame carried_smoothly(const CoefficientsD& c, Frame frame, double t, double end, dvec3 last) {
  constexpr double kStepBound = 2e-10, kLeastStep = 0x1p-36;
  constexpr int kMostSteps = 4096;
  double h = end - t;
  for (int i = 1; i <= kMostSteps && t < end; ++i) {
    while (h > kLeastStep && !(step_error(c, t, h) <= kStepBound)) h *= 0.5;
    if (i == kMostSteps || t + h >= end) h = end - t;
    const double next = t + h >= end ? end : t + h;
    const dvec3 chord = HodographStep(c, t, h).chord(), d = c.derivative(next);
    const double way = glm::length(chord), speed = glm::length(d);
    const dvec3 tangent = next == end ? last : speed > 0 ? d / speed : frame.forward;
    // Reflections need only the chord's direction, which the difference of two near points would lose to rounding.
    frame = transport(frame, dvec3(0), way > 0 ? chord / way : dvec3(0), tangent);
    t = next;
    h = std::min(4.0 * h, end - t);
  }
  return frame;
}

}  // namespace

std::optional<double> reversal(const CoefficientsD& curve, double t, double stopped) {
  if (!(t > 0 && t < 1) || !(curve.speed(t) <= stopped)) return std::nullopt;
  const double half = std::min({4 * stopped / glm::length(curve.second_derivative(t)), t, 1 - t});
  return dot(curve.derivative(t - half), curve.derivative(t + half)) < 0 ? std::optional(half) : std::nullopt;
}

Cusps cusps(const Cubic& cubic) {
  const CoefficientsD c = coefficients_d(cubic);
  const dvec3 d0 = c.derivative(0.0), d2 = 3.0 * (dvec3(cubic.p3) - dvec3(cubic.p2)),
              d1 = 3.0 * (dvec3(cubic.p2) - dvec3(cubic.p1));
  const double least = 1e-9 / 3.0 * std::max({glm::length(d0), glm::length(d1), glm::length(d2)});
  Cusps found;
  each_root(product(std::array{d0, d1, d2}, std::array{d1 - d0, d2 - d1}), [&](double t) {
    if (t > kBeside && t < 1.0 - kBeside && found.count < 2 && reversal(c, t, least)) found.t[found.count++] = t;
  });
  return found;
}

double step_error(const CoefficientsD& curve, double t, double h) {
  const HodographStep s(curve, t, h);
  return bounded(glm::dot(s.p, glm::cross(s.q, s.r)), glm::length(s.p), glm::length(s.q), glm::length(s.r));
}

double steps_error(const Cubic& cubic, int steps) {
  const dvec3 p0(cubic.p0), p1(cubic.p1), p2(cubic.p2), p3(cubic.p3);
  const dvec3 d0 = p1 - p0, d1 = p2 - p1, d2 = p3 - p2, chord = p3 - p0;
  const double h = 1.0 / steps, along = std::min({glm::dot(d0, chord), glm::dot(d1, chord), glm::dot(d2, chord)});
  if (!(along > 0)) return std::numeric_limits<double>::infinity();
  const dvec3 a = d1 - d0, b = d2 - d1, c = b - a;
  const double speed = 3.0 * along / glm::length(chord);  // at least
  const double second = 6.0 * std::sqrt(std::max(glm::dot(a, a), glm::dot(b, b)));
  const double det = 54.0 * h * h * h * glm::dot(d0, glm::cross(d1, d2));
  return steps * bounded(det, speed, h * second, 3.0 * h * h * glm::length(c));
}

Frame carried(const Cubic& cubic, const Frame& from, double t0, double t1) {
  const CoefficientsD c = coefficients_d(cubic);
  const dvec3 last = unit_tangent(cubic, t1);
  const Cusps all = cusps(cubic);
  Frame frame = from;
  for (int i = 0; i < all.count; ++i) {
    const double at = all.t[i];
    const dvec3 onward = glm::normalize(c.second_derivative(at));
    if (at > t1 + kBeside || at < t0 - kBeside) continue;
    if (at <= t0 + kBeside && glm::dot(frame.forward, onward) > 0) continue;
    if (at >= t1 - kBeside && glm::dot(last, onward) < 0) continue;
    if (at > t0) frame = carried_smoothly(c, frame, t0, at, -onward), t0 = at;
    frame.forward = onward;
  }
  if (t0 >= t1) return transport(frame, dvec3(0), dvec3(0), last);
  return carried_smoothly(c, frame, t0, t1, last);
}

}  // namespace coaster::curve
