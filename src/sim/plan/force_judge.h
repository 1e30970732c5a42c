// How well a span follows the path of a force section. Private to force_fit.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "curve/frames.h"
#include "sim/plan/element_spans.h"
#include "sim/plan/force_fit.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::sim {

struct SpanError {
  SpanCheck check;
  FeltError felt;
  double at_ends = 0;  // g, the part of it at the two knots
};

// Returns the squared speed at which curvature is judged at a point of the path, m^2/s^2: that of the train, or on a
// section of curvature that of world::kCurvatureSpeed.
inline double judged_square(const ForceTask& task, const ForcePoint& point) {
  const bool at_any = task.program.of == world::ForceOf::curvature;
  return at_any ? world::kCurvatureSpeed * world::kCurvatureSpeed : point.square;
}

inline constexpr double kNoSpan = 1e9;  // g: the span does not follow the path

// How the spans are judged at a point of the path: by what riders feel there. On a section of curvature, which has to
// be the same at any speed, by what they would feel on the curve itself at world::kCurvatureSpeed.
struct Judged {
  double square, along, riders;  // m^2/s^2, m/s^2, m above the curve
  double up, side;               // g felt on the path
};
inline Judged judged_at(const ForceTask& task, const ForcePath& path, std::size_t i) {
  const ForcePoint& point = path.points[i];
  const double square = judged_square(task, point);
  if (task.program.of == world::ForceOf::forces) return {square, point.along, task.riders, point.up, point.side};
  const ElementPoint& on = path.curve.points[i];
  const FeltG felt = felt_on({on.position, on.tangent, on.up, square}, {on.curvature}, 0);
  return {square, 0, 0, felt.up, felt.side};
}

// Returns what riders feel on a cubic at t, upwards and to the left: sim/shape/rail_tables.h.
inline glm::dvec2 felt_on_span(const curve::CoefficientsD& c, double t, const curve::Frame& frame, double spin,
                               double spin_slope, const Judged& as) {
  const glm::dvec3 left = frame.left(), first = c.derivative(t), second = c.second_derivative(t);
  const double square = glm::dot(first, first), to_left = glm::dot(second, left) / square, d = as.riders,
               to_up = glm::dot(second, frame.up) / square, v2 = as.square / world::kGravity;
  return {v2 * (to_up - d * (to_up * to_up + spin * spin)) + frame.up.y,
          v2 * (to_left - d * (to_left * to_up + spin_slope)) - as.along / world::kGravity * d * spin + left.y};
}

// Returns the errors of the span between two knots against the path's points from `first` to `last`.
inline SpanError span_error(const ForceTask& task, const ForcePath& path, std::size_t first, std::size_t last,
                            const world::Knot& from, const world::Knot& to) {
  const std::span<const ElementPoint> points = std::span(path.curve.points).subspan(first, last - first + 1);
  std::vector<SpanPlace> places;
  SpanError error{check_span(points, from, to, &places), {}, 0};
  if (!error.check.sound || error.check.error > kElementDistance) return {error.check, {kNoSpan, first}, kNoSpan};
  const curve::CoefficientsD c =
      curve::coefficients_d({from.position, world::out_handle(from), world::in_handle(to), to.position});
  const Roll roll{points.back().s - points.front().s, error.check.roll, from.spin, to.spin};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double s = points[i].s - points.front().s;
    curve::Frame frame = places[i].frame;
    frame.up = curve::rotate(frame.up, frame.forward, roll.angle(s));
    const Judged asked = judged_at(task, path, first + i);
    const glm::dvec2 felt = felt_on_span(c, places[i].t, frame, roll.spin(s), roll.slope(s), asked);
    const double off = std::max(std::abs(felt.x - asked.up), std::abs(felt.y - asked.side));
    if (!(off <= error.felt.error)) error.felt = {off, first + i};
    if (i == 0 || i + 1 == points.size()) error.at_ends = std::max(error.at_ends, off);
  }
  return error;
}

}  // namespace coaster::sim
