#include "exchange/nolimits/nl2_spline.h"

#include <algorithm>

#include "base/check.h"
#include "sim/shape/rails.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr double kNoDirection = 1e-4;  // m: shorter differences of control points have no direction

// Interpolates; exact at w = 0 and w = 1.
template <class T>
T between(T a, T b, double w) {
  return (1 - w) * a + w * b;
}

// Returns the blossom (polar form) of one span of a cubic B-spline, by de Boor's recurrence with an argument for each
// step. knots[2] and knots[3] bound the span. With arguments from these two it gives the span's Bézier control points.
template <class T>
T blossom(std::array<T, 4> d, const std::array<double, 6>& knots, std::array<double, 3> arguments) {
  for (std::size_t step = 0; step < 3; ++step)
    for (std::size_t i = 0; i + step < 3; ++i)
      d[i] = between(d[i], d[i + 1], (arguments[step] - knots[i + step]) / (knots[i + 3] - knots[i + step]));
  return d[0];
}

// Returns span k of a clamped uniform cubic B-spline with `run` as its control points.
template <class T>
std::array<T, 4> span_of(const std::vector<T>& run, std::size_t k) {
  const double last = static_cast<double>(run.size() - 3), a = static_cast<double>(k), b = a + 1;
  std::array<double, 6> knots;
  for (int i = 0; i < 6; ++i) knots[static_cast<std::size_t>(i)] = std::clamp(a + i - 2, 0.0, last);
  const std::array<T, 4> d{run[k], run[k + 1], run[k + 2], run[k + 3]};
  return {blossom(d, knots, {a, a, a}), blossom(d, knots, {a, a, b}), blossom(d, knots, {a, b, b}),
          blossom(d, knots, {b, b, b})};
}

// Returns the spans of the B-spline of degree min(3, n - 1) with n control points.
template <class T>
std::vector<std::array<T, 4>> spans_of(const std::vector<T>& run) {
  const T a = run.front(), b = run.back();
  if (run.size() == 2) return {{a, between(a, b, 1.0 / 3), between(a, b, 2.0 / 3), b}};
  if (run.size() == 3) return {{a, between(a, run[1], 2.0 / 3), between(b, run[1], 2.0 / 3), b}};
  std::vector<std::array<T, 4>> spans;
  for (std::size_t k = 0; k + 3 < run.size(); ++k) spans.push_back(span_of(run, k));
  return spans;
}

void append_run(std::span<const SplineVertex> run, std::size_t first, std::vector<SplinePiece>& pieces) {
  std::vector<dvec3> places;
  std::vector<glm::dvec4> weighted;
  bool rational = false;
  for (const SplineVertex& v : run) {
    places.push_back(v.position), weighted.emplace_back(v.weight * v.position, v.weight);
    rational = rational || (run.size() > 2 && v.weight != run.front().weight);
  }
  const auto vertex = [first](std::size_t k) { return k == 0 ? first : first + k + 1; };
  std::size_t k = 0;
  if (rational)
    for (const RationalBezier& span : spans_of(weighted)) append_cubics(span, vertex(k++), pieces);
  else
    for (const Bezier& span : spans_of(places)) pieces.push_back({span, vertex(k++)});
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
