#include "sim/plan/element_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/portable_math.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "curve/span_fit.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kMostRoll = 2.5;  // rad per span: well below half a turn, so that no whole turns are needed
constexpr double kAnySlope = std::numeric_limits<double>::infinity();
constexpr double kShortest = 0.1, kLongest = 0.8;  // handles, relative to a span's length

// Removes the curvature error that torsion leaves at an end. The tangent there is fixed, so the next knot moves
// sideways, by at most `most` m from the ideal curve. A shift changes the far handle by about 1.5 times as much,
// because the next tangent turns with it.
void shift_second(curve::SpanNodes& n, const ElementCurve& curve, std::span<const std::size_t> at, bool last,
                  double most) {
  const std::size_t count = n.place.size(), end = last ? count - 1 : 0, next = last ? count - 2 : 1;
  if (count < 4) return;
  const dvec3 far = last ? n.place[next] + n.out[next] * n.tangent[next] : n.place[next] - n.in[next] * n.tangent[next];
  const double handle = last ? n.in[end] : n.out[end];
  const dvec3 wanted = curve.points[at[end]].curvature,
              is = 2.0 / 3.0 * curve::across(far - n.place[end], n.tangent[end]) / (handle * handle);
  const dvec3 ideal = curve.points[at[next]].position;
  dvec3 off = n.place[next] + handle * handle * (wanted - is) - ideal;
  if (const double size = glm::length(off); size > most) off *= most / size;
  n.place[next] = ideal + off;
}

std::vector<world::Knot> knots_of(const ElementCurve& curve, std::span<const std::size_t> at,
                                  const curve::SpanNodes& n) {
  std::vector<world::Knot> knots;
  for (std::size_t k = 0; k < at.size(); ++k) {
    world::Knot knot;
    knot.position = glm::vec3(n.place[k]);
    knot.tangent = glm::vec3(n.tangent[k]);
    // From the tangent in double, not from the rounded one: gcc 12 at -O2 may omit a rounding to float and back, and
    // the bits matter.
    knot.up = glm::vec3(curve::perpendicular(n.tangent[k], curve.points[at[k]].up));
    knot.in_length = world::as_handle(k > 0 ? n.in[k] : n.out[k]);
    knot.out_length = world::as_handle(k + 1 < at.size() ? n.out[k] : n.in[k]);
    knot.joint = world::JointKind::aligned;
    const double spin = curve.points[at[k]].spin;
    if (std::abs(spin) >= kLeastSpin) knot.spin = static_cast<float>(spin);
    world::orthonormalise(knot);
    knots.push_back(knot);
  }
  return knots;
}

curve::Cubic cubic_between(const world::Knot& from, const world::Knot& to) {
  return {from.position, world::out_handle(from), world::in_handle(to), to.position};
}

// Returns true if a span's slopes at its start (t = 0) or end (t = 1) are within ElementPoint::slope_error.
bool slopes_hold(const ElementPoint& p, const EndSlopes& wanted, double roll_slope, const curve::Cubic& cubic,
                 double t) {
  constexpr double kStep = 0.01, kCurvatureShare = 1.5;
  if (!(p.slope_error < kAnySlope)) return true;
  const double near = t == 0 ? kStep : 1.0 - kStep;
  const dvec3 change = (curve::curvature_vector(cubic, near) - curve::curvature_vector(cubic, t)) /
                       ((near - t) * glm::length(curve::coefficients_d(cubic).derivative(t)));
  return std::abs(roll_slope - wanted.spin) <= p.slope_error &&
         std::abs(glm::dot(change - wanted.curvature, p.up)) <= kCurvatureShare * p.slope_error;
}

}  // namespace

// Follows the ideal curve's points along a span. The frame is computed as the track's (sim/shape/derived.cpp):
// rotation-minimising, turned to the second knot's up by the spins of both.
SpanCheck check_span(std::span<const ElementPoint> points, const world::Knot& from, const world::Knot& to,
                     std::vector<SpanPlace>* places) {
  const curve::Cubic cubic = cubic_between(from, to);
  const curve::CoefficientsD c = curve::coefficients_d(cubic);
  SpanCheck check;
  const double length = points.back().s - points.front().s;
  for (const float handle : {from.out_length, to.in_length})
    check.sound = check.sound && handle > kShortest * length && handle < kLongest * length;
  curve::Frame frame{curve::unit_tangent(cubic, 0.0), glm::normalize(dvec3(from.up))};
  dvec3 place = c.point(0.0);
  std::vector<double> rolls{0.0};
  double t = 0;
  if (places != nullptr) *places = {{t, frame}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool last = i + 1 == points.size();
    t = last ? 1.0 : std::min(1.0, t + (points[i].s - points[i - 1].s) / std::max(1e-9, glm::length(c.derivative(t))));
    for (int newton = 0; newton < 3 && !last; ++newton) {
      const dvec3 off = (t == 1.0 ? dvec3(cubic.p3) : c.point(t)) - points[i].position, d = c.derivative(t),
                  dd = c.second_derivative(t);
      const double slope = glm::dot(d, d) + glm::dot(off, dd);
      if (slope > 0) t = std::clamp(t - glm::dot(off, d) / slope, 0.0, 1.0);
    }
    const dvec3 here = t == 1.0 ? dvec3(cubic.p3) : c.point(t);
    check.error = std::max(check.error, glm::distance(here, points[i].position));
    frame = curve::transport(frame, place, here, curve::unit_tangent(cubic, t));
    place = here;
    if (places != nullptr) places->push_back({t, frame});
    const dvec3 wanted = last ? dvec3(to.up) : points[i].up;
    const double roll = curve::signed_angle(frame.up, curve::perpendicular(frame.forward, wanted), frame.forward);
    rolls.push_back(rolls.back() + std::remainder(roll - rolls.back(), 2.0 * base::kPi));
  }
  const Roll roll{length, rolls.back(), from.spin, to.spin};
  for (std::size_t i = 1; i < points.size(); ++i)
    check.roll_error = std::max(check.roll_error, std::abs(rolls[i] - roll.angle(points[i].s - points[0].s)));
  check.roll = rolls.back();
  check.sound = check.sound && std::abs(check.roll) < kMostRoll;
  const std::size_t end = points.size() - 1;
  check.slopes = points.size() < 3 ||
                 (slopes_hold(points[0], slopes_at(points[0], points[1], points[2]), roll.slope(0), cubic, 0) &&
                  slopes_hold(points[end], slopes_at(points[end], points[end - 1], points[end - 2]), roll.slope(length),
                              cubic, 1));
  return check;
}

Spans make_spans(const ElementCurve& curve, std::span<const std::size_t> at, double most_shift) {
  constexpr int kRounds = 12;
  constexpr double kDone = 1e-11;  // 1/m
  std::vector<curve::PathPoint> ends;
  for (const std::size_t i : at) {
    const ElementPoint& p = curve.points[i];
    ends.push_back({p.s, p.position, p.tangent, p.curvature});
  }
  curve::SpanNodes n = curve::span_nodes(ends);
  for (int round = 0; round < kRounds; ++round) {
    shift_second(n, curve, at, false, most_shift), shift_second(n, curve, at, true, most_shift);
    if (curve::turn_tangents(n) < kDone) break;
  }
  Spans spans;
  spans.knots = knots_of(curve, at, n);
  dvec3 before = curve.points.front().curvature;
  double rounding = 0;
  const auto add_jump = [&](dvec3 after, double and_rounding) {
    spans.jumps.push_back(glm::length(after - before));
    spans.strains.push_back(spans.jumps.back() / curve::largest_jump(before, after, rounding + and_rounding));
  };
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const curve::Cubic c = cubic_between(spans.knots[k], spans.knots[k + 1]);
    add_jump(curve::curvature_vector(c, 0.0), curve::rounding_curvature(c, 0.0));
    before = curve::curvature_vector(c, 1.0), rounding = curve::rounding_curvature(c, 1.0);
  }
  add_jump(curve.points.back().curvature, 0);
  return spans;
}

}  // namespace coaster::sim
