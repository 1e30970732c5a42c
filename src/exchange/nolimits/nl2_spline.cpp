#include "exchange/nolimits/nl2_spline.h"

#include <algorithm>

#include "base/check.h"
#include "sim/shape/rails.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr double kNoDirection = 1e-4;  // m: shorter differences of control points have no direction

// Interpolates; exact at w = 0 and w = 1.
dvec3 between(dvec3 a, dvec3 b, double w) { return (1 - w) * a + w * b; }

// Returns the blossom (polar form) of one span of a cubic B-spline, by de Boor's recurrence with an argument for each
// step. knots[2] and knots[3] bound the span. With arguments from these two it gives the span's Bézier control points.
dvec3 blossom(std::array<dvec3, 4> d, const std::array<double, 6>& knots, std::array<double, 3> arguments) {
  for (std::size_t step = 0; step < 3; ++step)
    for (std::size_t i = 0; i + step < 3; ++i)
      d[i] = between(d[i], d[i + 1], (arguments[step] - knots[i + step]) / (knots[i + 3] - knots[i + step]));
  return d[0];
}

// Returns span k of a clamped uniform cubic B-spline with `run` as its control points.
Bezier span_of(std::span<const SplineVertex> run, std::size_t k) {
  const double last = static_cast<double>(run.size() - 3), a = static_cast<double>(k), b = a + 1;
  std::array<double, 6> knots;
  for (int i = 0; i < 6; ++i) knots[static_cast<std::size_t>(i)] = std::clamp(a + i - 2, 0.0, last);
  const std::array<dvec3, 4> d{run[k].position, run[k + 1].position, run[k + 2].position, run[k + 3].position};
  return {blossom(d, knots, {a, a, a}), blossom(d, knots, {a, a, b}), blossom(d, knots, {a, b, b}),
          blossom(d, knots, {b, b, b})};
}

void append_run(std::span<const SplineVertex> run, std::size_t first, std::vector<SplinePiece>& pieces) {
  const dvec3 a = run.front().position, b = run.back().position;
  if (run.size() == 2) pieces.push_back({{a, between(a, b, 1.0 / 3), between(a, b, 2.0 / 3), b}, first});
  else if (run.size() == 3) {
    const dvec3 middle = run[1].position;
    pieces.push_back({{a, between(a, middle, 2.0 / 3), between(b, middle, 2.0 / 3), b}, first});
  } else
    for (std::size_t k = 0; k + 3 < run.size(); ++k)
      pieces.push_back({span_of(run, k), k == 0 ? first : first + k + 1});
}

dvec3 direction(dvec3 from, std::array<dvec3, 3> towards) {
  for (const dvec3& to : towards)
    if (const double length = glm::distance(from, to); length > kNoDirection) return (to - from) / length;
  return dvec3(0);
}

}  // namespace

dvec3 point(const Bezier& b, double t) {
  const double u = 1 - t;
  return u * u * u * b[0] + 3 * u * u * t * b[1] + 3 * u * t * t * b[2] + t * t * t * b[3];
}

dvec3 slope(const Bezier& b, double t) {
  const double u = 1 - t;
  return 3 * u * u * (b[1] - b[0]) + 6 * u * t * (b[2] - b[1]) + 3 * t * t * (b[3] - b[2]);
}

Bezier part(const Bezier& b, double from, double to) {
  // The blossom of a Bézier: its knots are 0, 0, 0, 1, 1, 1.
  const auto at = [&](double x, double y, double z) { return blossom(b, {0, 0, 0, 1, 1, 1}, {x, y, z}); };
  return {at(from, from, from), at(from, from, to), at(from, to, to), at(to, to, to)};
}

dvec3 start_direction(const Bezier& b) { return direction(b[0], {b[1], b[2], b[3]}); }
dvec3 end_direction(const Bezier& b) { return -direction(b[3], {b[2], b[1], b[0]}); }

curve::Cubic in_float(const Bezier& b) { return {glm::vec3(b[0]), glm::vec3(b[1]), glm::vec3(b[2]), glm::vec3(b[3])}; }

std::vector<SplinePiece> spline_pieces(std::span<const SplineVertex> vertices) {
  COASTER_CHECK(vertices.size() >= 2, "a curve has two ends");
  std::vector<SplinePiece> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i)
    if (vertices[i].strict || i + 1 == vertices.size()) {
      append_run(vertices.subspan(first, i + 1 - first), first, pieces);
      first = i;
    }
  return pieces;
}

PlaceOnTrack place_on(const sim::Derived& derived, double distance) {
  const sim::TrackPlace at = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[at.index]);
  const double within = std::min(at.s, shape.arc.length());
  return {sim::rails_at(shape, within), sim::rails_frame_at(shape, within)};
}

}  // namespace coaster::exchange
