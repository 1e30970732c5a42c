#include "sim/fit/fit_handles.h"

#include <algorithm>
#include <cmath>

#include "curve/frames.h"
#include "world/components.h"

namespace coaster::sim {

using glm::dvec2, glm::dvec3;

namespace {

constexpr std::size_t kFittedRows = 40;  // rows that handle lengths are fitted to
constexpr int kIterations = 12;
constexpr double kMostHandle = 0.495;  // of the rows' length: a little less than half the curve's
constexpr double kBeyond = 40;         // weight of curvature beyond the limit, relative to that of a deviation
constexpr double kStay = 1e-3;  // 1/m: weight of a change of the handles by the length, relative to that of a deviation
using Curve = curve::CoefficientsD;

// Returns the shortest and the longest handle of a span over so many metres of rows, within a knot's limits.
double least_handle(const SpanEnds& ends, double length) {
  return std::clamp<double>(ends.least_handle * length, world::kMinHandle, world::kMaxHandle);
}
double most_handle(const SpanEnds& ends, double length) {
  return std::clamp<double>(kMostHandle * length, least_handle(ends, length), world::kMaxHandle);
}

}  // namespace

Curve curve_of(const SpanEnds& e, Handles h) {
  const dvec3 d0 = h.out * e.t0, p1 = e.p0 + d0, p2 = e.p3 - h.in * e.t3, d1 = p2 - p1, d2 = e.p3 - p2;
  return {e.p0, 3.0 * d0, 3.0 * (d1 - d0), (d2 - d1) - (d1 - d0)};
}

double nearer(const Curve& c, dvec3 target, double t, int steps) {
  for (int i = 0; i < steps; ++i) {
    const dvec3 d = c.derivative(t), off = c.point(t) - target;
    const double speed = glm::dot(d, d), slope = speed + glm::dot(off, c.second_derivative(t));
    const double step = glm::dot(off, d) / (slope > 0.1 * speed ? slope : std::max(speed, 1e-30));
    t = std::clamp(t - std::clamp(step, -0.2, 0.2), 0.0, 1.0);
    if (std::abs(step) < 1e-9) break;
  }
  return t;
}

dvec3 bend_of(const Curve& c, double t) {
  const dvec3 d = c.derivative(t);
  const double speed = std::max(glm::length(d), 1e-15);
  return curve::across(c.second_derivative(t), d / speed) / (speed * speed);
}

Handles fit_handles(std::span<const FitRow> rows, std::span<const double> distances, std::size_t first,
                    std::size_t last, const SpanEnds& ends, std::vector<double>& parameters,
                    std::vector<double>& stations) {
  const double length = std::max(distances[last] - distances[first], 1e-9);
  const std::size_t inner = std::min(last - first - 1, kFittedRows);
  parameters.resize(inner + 2), stations.resize(inner + 2);
  const auto row_of = [&](std::size_t k) { return first + (last - first) * k / (inner + 1); };
  for (std::size_t k = 0; k < inner + 2; ++k)
    parameters[k] = stations[k] = (distances[row_of(k)] - distances[first]) / length;
  const double low = least_handle(ends, length), high = most_handle(ends, length);
  // Without rows between the ends: the handles of a circle through both.
  const double third = inner > 0 ? length / 3 : length / (1.5 + 0.75 * glm::length(ends.t0 + ends.t3));
  Handles h{std::clamp(third, low, high), std::clamp(third, low, high)};
  for (int iteration = 0; iteration < kIterations && inner > 0; ++iteration) {
    const Curve c = curve_of(ends, h);
    double a00 = 0, a01 = 0, a11 = 0, x0 = 0, x1 = 0, weight = 0;
    for (std::size_t k = 1; k <= inner; ++k) {
      const double t = parameters[k] = nearer(c, rows[row_of(k)].position, parameters[k], 2), u = 1 - t;
      const dvec3 d = c.derivative(t), off = rows[row_of(k)].position - c.point(t);
      const double speed = std::max(glm::dot(d, d), 1e-30);
      const auto across = [&](dvec3 v) { return v - (glm::dot(v, d) / speed) * d; };
      const dvec3 g0 = across(3 * t * u * u * ends.t0), g1 = across(-3 * t * t * u * ends.t3);
      a00 += glm::dot(g0, g0), a01 += glm::dot(g0, g1), a11 += glm::dot(g1, g1);
      x0 += glm::dot(g0, off), x1 += glm::dot(g1, off);
      weight += 9 * t * t * u * u;
    }
    // Slight damping: on a straight the lengths have no effect and stay.
    const double damping = 1e-7 * weight + 1e-12;
    a00 += damping, a11 += damping;
    const double determinant = a00 * a11 - a01 * a01;
    const double limit = 0.2 * length;
    const auto held = [&](double from, double by) {
      return std::clamp(from + std::clamp(by, -limit, limit), low, high) - from;
    };
    // A handle that is held at its bound leaves the other one to fit the rows.
    double out = held(h.out, (a11 * x0 - a01 * x1) / determinant);
    const double in = held(h.in, (x1 - a01 * out) / a11);
    out = held(h.out, (x0 - a01 * in) / a00);
    h = {h.out + out, h.in + in};
    if (std::max(std::abs(out), std::abs(in)) < 1e-4 * length) break;
  }
  return h;
}

Handles most_alike(const SpanEnds& ends, double length, dvec3 from, dvec3 to, double limit, Handles start) {
  Handles h = start;
  const auto cost = [&](Handles at) {
    constexpr int kPlaces = 16;
    const Curve c = curve_of(ends, at);
    double most = 0;
    for (int i = 0; i <= kPlaces; ++i) most = std::max(most, glm::length(bend_of(c, static_cast<double>(i) / kPlaces)));
    const dvec2 off(glm::distance(bend_of(c, 0), from), glm::distance(bend_of(c, 1), to));
    const double moved = std::abs(at.out - start.out) + std::abs(at.in - start.in);
    return glm::length(off) + kBeyond * std::max(0.0, most - limit) + kStay * moved / length;
  };
  const double low = least_handle(ends, length), high = most_handle(ends, length);
  double best = cost(h);
  for (double step = 0.08 * length; step > 0.002 * length;) {
    const Handles before = h;
    for (const dvec2 way : {dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1), dvec2(0, -1), dvec2(1, 1), dvec2(-1, -1)}) {
      const Handles tried{std::clamp(before.out + step * way.x, low, high),
                          std::clamp(before.in + step * way.y, low, high)};
      if (const double found = cost(tried); found < best) best = found, h = tried;
    }
    if (h.out == before.out && h.in == before.in) step /= 2;
  }
  return h;
}

}  // namespace coaster::sim
