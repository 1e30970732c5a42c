#include "exchange/nolimits/nl2_spline.h"

#include <algorithm>
#include <cmath>

#include "curve/frames.h"
#include "sim/fit/fit_span.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

dvec3 point_of(glm::dvec4 h) { return dvec3(h) / h.w; }

// Changes the handles to those with which the curvature along `from` and `to`, the curvature vectors at the ends (1/m),
// is theirs, by Newton's method: |curvature| out^2 = 2/3 of what the far handle's end is off the tangent. Unchanged if
// none are near.
void bend(const sim::SpanEnds& ends, dvec3 from, dvec3 to, sim::Handles& handles) {
  constexpr int kSteps = 12;
  constexpr double kNear = 1.3;
  const dvec3 chord = 1.5 * (ends.p3 - ends.p0), first = 1.5 * ends.t0, last = 1.5 * ends.t3;
  const double a = 2.25 * glm::dot(from, from), b = 2.25 * glm::dot(to, to);
  const double across = glm::dot(from, last), back = glm::dot(to, first);
  sim::Handles h = handles;
  double moved = 1;
  for (int i = 0; i < kSteps && moved > 1e-13; ++i) {
    const double f = glm::dot(from, chord) - across * h.in - a * h.out * h.out,
                 g = back * h.out - glm::dot(to, chord) - b * h.in * h.in;
    const double f_out = -2 * a * h.out, g_in = -2 * b * h.in, determinant = f_out * g_in + across * back;
    if (determinant == 0) return;
    const double out = (f * g_in + across * g) / determinant, in = (f_out * g - back * f) / determinant;
    h.out -= out, h.in -= in;
    moved = std::abs(out) / handles.out + std::abs(in) / handles.in;
  }
  const double most = std::max({h.out / handles.out, handles.out / h.out, h.in / handles.in, handles.in / h.in});
  if (moved < 1e-9 && h.out > 0 && h.in > 0 && most < kNear) handles = h;
}

SplinePiece fit(const RationalBezier& r, std::size_t vertex) {
  constexpr int kPlaces = 12;
  const Bezier b{point_of(r[0]), point_of(r[1]), point_of(r[2]), point_of(r[3])};
  const sim::SpanEnds ends{b[0], start_direction(b), b[3], end_direction(b)};
  const double out = glm::distance(b[0], b[1]), in = glm::distance(b[2], b[3]), chord = glm::distance(b[0], b[3]);
  sim::Handles handles{out * r[1].w / r[0].w, in * r[2].w / r[3].w};
  if (std::min(out, in) > 1e-3 * chord) {
    const double from = 2.0 / 3 * r[0].w * r[2].w / (r[1].w * r[1].w * out * out),
                 to = 2.0 / 3 * r[3].w * r[1].w / (r[2].w * r[2].w * in * in);
    bend(ends, from * curve::across(b[2] - b[0], ends.t0), to * curve::across(b[1] - b[3], ends.t3), handles);
  } else handles = {chord / 3, chord / 3};
  SplinePiece piece{{b[0], b[0] + handles.out * ends.t0, b[3] - handles.in * ends.t3, b[3]}, vertex};
  const curve::CoefficientsD curve = sim::curve_of(ends, handles);
  for (int k = 1; k < kPlaces; ++k) {
    const double t = static_cast<double>(k) / kPlaces, u = 1 - t;
    const dvec3 here = point_of(u * u * u * r[0] + 3 * u * u * t * r[1] + 3 * u * t * t * r[2] + t * t * t * r[3]);
    piece.off = std::max(piece.off, glm::distance(here, curve.point(sim::nearer(curve, here, t, 8))));
  }
  return piece;
}

void append(const RationalBezier& r, std::size_t vertex, int halvings, std::vector<SplinePiece>& pieces) {
  const SplinePiece piece = fit(r, vertex);
  if (piece.off <= kRationalOff || halvings == 0 || pieces.size() > world::kMaxKnots) return pieces.push_back(piece);
  const glm::dvec4 a = 0.5 * (r[0] + r[1]), b = 0.5 * (r[1] + r[2]), c = 0.5 * (r[2] + r[3]), d = 0.5 * (a + b),
                   e = 0.5 * (b + c), middle = 0.5 * (d + e);
  append({r[0], a, d, middle}, vertex, halvings - 1, pieces);
  append({middle, e, c, r[3]}, vertex, halvings - 1, pieces);
}

}  // namespace

void append_cubics(const RationalBezier& rational, std::size_t vertex, std::vector<SplinePiece>& pieces) {
  constexpr int kMostHalvings = 12;
  append(rational, vertex, kMostHalvings, pieces);
}

}  // namespace coaster::exchange
