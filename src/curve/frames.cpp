#include "curve/frames.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"
#include "curve/continuity.h"
#include "curve/polynomial_roots.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

// Returns a frame that is unit and perpendicular to rounding; `up` must not be parallel to `forward`.
Frame orthonormal(dvec3 forward, dvec3 up) { return {forward, perpendicular(forward, up)}; }

}  // namespace

std::optional<FrenetFrame> frenet(const Cubic& cubic, double t) {
  const dvec3 d = derivative(cubic, t), dd = second_derivative(cubic, t);
  const double speed = glm::length(d);
  if (!(speed > 1e-9)) return std::nullopt;
  const dvec3 binormal = glm::cross(d, dd);
  const double size = glm::length(binormal), k = size / (speed * speed * speed);
  // Paper erratum: where the curvature is 0 there is no normal; it flips across an inflection.
  if (!(k > 1e-9) || !(k > rounding_curvature(cubic, t))) return std::nullopt;
  const dvec3 tangent = d / speed, b = binormal / size;
  const double torsion = glm::dot(binormal, third_derivative(cubic)) / (size * size);
  return FrenetFrame{tangent, glm::cross(b, tangent), b, k, torsion};
}

BinormalCurve binormal_curve(const Cubic& cubic) {
  // With B' = a + t b + t^2 c and B'' = b + 2 t c the terms of t^2 and t^3 with a repeated factor cancel.
  const CoefficientsD k = coefficients_d(cubic);
  const dvec3 a = k.c1, b = 2.0 * k.c2, c = 3.0 * k.c3;
  return {glm::cross(a, b), 2.0 * glm::cross(a, c), glm::cross(b, c)};
}

BinormalMinima binormal_minima(const BinormalCurve& curve) {
  // The curve's normal if it is plane: then b(t) is the normal times a quadratic, which changes its sign at the
  // inflections.
  dvec3 normal = curve.b0;
  for (const dvec3 b : {curve.b1, curve.b2})
    if (glm::length(b) > glm::length(normal)) normal = b;
  const double size = glm::length(normal);
  if (size > 0) normal /= size;
  const auto aside = [&](dvec3 b) { return glm::length(glm::cross(b, normal)); };
  const dvec3 h1 = curve.b0 + 0.5 * curve.b1, h2 = curve.at(1.0);
  BinormalMinima found;
  const auto add = [&](double t) {
    if (t > 0.0 && t < 1.0 && found.count < 2) found.t[found.count++] = t;
  };
  if (aside(curve.b0) + aside(curve.b1) + aside(curve.b2) <= 1e-12 * size) {
    each_root(std::array{glm::dot(curve.b0, normal), glm::dot(h1, normal), glm::dot(h2, normal)}, add);
    if (found.count == 2 && found.t[1] - found.t[0] < 1e-7) found.count = 0;  // a cusp's double root
  } else {
    const auto slope = product(std::array{curve.b0, h1, h2}, std::array{h1 - curve.b0, h2 - h1});  // of |b|^2 / 4
    each_rise(slope, [&](const Bracket& at) { add(refined_root(slope, at, true)); });
  }
  return found;
}

BinormalTurns binormal_turns(const BinormalCurve& curve) {
  constexpr double kHalfSpan = 1.0 / 64;
  const BinormalMinima minima = binormal_minima(curve);
  BinormalTurns turns{minima.count, {}};
  const double halfway = 0.5 * (minima.t[0] + minima.t[1]);
  for (int i = 0; i < minima.count; ++i) {
    BinormalTurn& turn = turns.at[i];
    turn = {minima.t[i], std::max(0.0, minima.t[i] - kHalfSpan), std::min(1.0, minima.t[i] + kHalfSpan), 0};
    if (minima.count == 2) (i == 0 ? turn.to = std::min(turn.to, halfway) : turn.from = std::max(turn.from, halfway));
    turn.angle = binormal_turn(curve, turn.from, turn.to);
  }
  return turns;
}

double angle_between(dvec3 a, dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

double binormal_turn(const BinormalCurve& curve, double t0, double t1) {
  return angle_between(curve.at(t0), curve.at(t1));
}

Frame transport(const Frame& from, dvec3 x0, dvec3 x1, dvec3 t1) {
  // Wang et al. 2008: reflect in the plane between the points, then in the plane between the tangents.
  const dvec3 v1 = x1 - x0;
  const double c1 = glm::dot(v1, v1);
  if (!(c1 > 1e-24)) return orthonormal(t1, least_rotation(from.forward, t1, from.up, from.up));
  const dvec3 up = from.up - (2.0 / c1) * glm::dot(v1, from.up) * v1;
  const dvec3 forward = from.forward - (2.0 / c1) * glm::dot(v1, from.forward) * v1;
  const dvec3 v2 = t1 - forward;
  const double c2 = glm::dot(v2, v2);
  if (!(c2 > 1e-24)) return orthonormal(t1, up);
  return orthonormal(t1, up - (2.0 / c2) * glm::dot(v2, up) * v2);
}

dvec3 least_rotation(dvec3 from, dvec3 to, dvec3 v, dvec3 axis) {
  const double c = glm::dot(from, to);
  if (c < -1.0 + 1e-12) return 2.0 * glm::dot(axis, v) * axis - v;  // the half turn about `axis`
  const dvec3 w = glm::cross(from, to);
  // Rodrigues' formula with sin = |w| and 1 - cos = |w|^2 / (1 + cos).
  return c * v + glm::cross(w, v) + (glm::dot(w, v) / (1.0 + c)) * w;
}

dvec3 rotate(dvec3 v, dvec3 axis, double radians) {
  const auto [s, c] = base::sin_cos(radians);
  return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

double signed_angle(dvec3 from, dvec3 to, dvec3 axis) {
  return base::arc_tangent(glm::dot(glm::cross(from, to), axis), glm::dot(from, to));
}

dvec3 perpendicular(dvec3 forward, dvec3 wish) {
  dvec3 up = wish - glm::dot(wish, forward) * forward;
  double length = glm::length(up);
  if (!(length > 1e-9)) {
    // Parallel: use the axis least along `forward`, so that the result is well conditioned and depends on it alone.
    const dvec3 a = glm::abs(forward);
    const dvec3 axis = a.x <= a.y && a.x <= a.z ? dvec3(1, 0, 0) : a.y <= a.z ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    up = axis - glm::dot(axis, forward) * forward;
    length = glm::length(up);
  }
  up /= length;
  // Repeat, because the first subtraction is inexact when `wish` is nearly parallel.
  up -= glm::dot(up, forward) * forward;
  return up / glm::length(up);
}

}  // namespace coaster::curve
