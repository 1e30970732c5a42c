#include "exchange/nolimits/nl2_spline.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/portable_math.h"
#include "curve/arc_length.h"
#include "curve/frames.h"
#include "sim/fit/sample_span_fit.h"
#include "sim/shape/rails.h"
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

// Control points times their weights (m), and the weights (> 0).
using RationalBezier = std::array<glm::dvec4, 4>;

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

constexpr int kMostHalvings = 12;

// Appends cubics within kRationalOff of a rational one, halved until they are. They have its points and directions at
// their ends and, where possible, its curvature within its plane there, which makes plane joints G2.
void append_cubics(const RationalBezier& r, std::size_t vertex, int halvings, std::vector<SplinePiece>& pieces) {
  const SplinePiece piece = fit(r, vertex);
  if (piece.off <= kRationalOff || halvings == 0 || pieces.size() > world::kMaxKnots) return pieces.push_back(piece);
  const glm::dvec4 a = 0.5 * (r[0] + r[1]), b = 0.5 * (r[1] + r[2]), c = 0.5 * (r[2] + r[3]), d = 0.5 * (a + b),
                   e = 0.5 * (b + c), middle = 0.5 * (d + e);
  append_cubics({r[0], a, d, middle}, vertex, halvings - 1, pieces);
  append_cubics({middle, e, c, r[3]}, vertex, halvings - 1, pieces);
}

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
    for (const RationalBezier& span : spans_of(weighted)) append_cubics(span, vertex(k++), kMostHalvings, pieces);
  else
    for (const Bezier& span : spans_of(places)) pieces.push_back({span, vertex(k++)});
}

dvec3 direction(dvec3 from, std::array<dvec3, 3> towards) {
  for (const dvec3& to : towards)
    if (const double length = glm::distance(from, to); length > kNoDirection) return (to - from) / length;
  return dvec3(0);
}

struct Fillet {
  double leaves = 1, joins = 0;  // parameters of the piece before and the piece after
  Bezier curve;
  double off = 0;  // m
};

// Returns the fillet that starts `reach` m before the corner and ends as far after it.
Fillet fillet_of(const Bezier& before, const Bezier& after, const curve::ArcLengthMap& arc_before,
                 const curve::ArcLengthMap& arc_after, double reach) {
  const auto leaves = [&](double m) { return arc_before.parameter(arc_before.length() - m); };
  Fillet fillet{leaves(reach), arc_after.parameter(reach), {}, 0};
  const Bezier in = part(before, 0, fillet.leaves), out = part(after, fillet.joins, 1);
  const double handle = 2 * reach / 3;
  fillet.curve = {in[3], in[3] + handle * end_direction(in), out[0] - handle * start_direction(out), out[0]};
  constexpr int kSamples = 32;
  for (int k = 1; k < kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples, beyond = (2 * t - 1) * reach;
    const dvec3 old = beyond < 0 ? point(before, leaves(-beyond)) : point(after, arc_after.parameter(beyond));
    fillet.off = std::max(fillet.off, glm::distance(old, point(fillet.curve, t)));
  }
  return fillet;
}

Fillet round_corner(const Bezier& before, const Bezier& after, double angle) {
  constexpr double kShare = 0.45, kShorter = 0.8;
  constexpr int kTries = 40;
  const curve::ArcLengthMap arc_before(in_float(before)), arc_after(in_float(after));
  // Between straight lines the fillet is reach sin(angle / 2) / 2 from the corner.
  double reach = std::min(
      {2 * kCornerOff / base::sin_cos(angle / 2).sin, kShare * arc_before.length(), kShare * arc_after.length()});
  Fillet fillet = fillet_of(before, after, arc_before, arc_after, reach);
  for (int tries = 0; fillet.off > 1.000001 * kCornerOff && tries < kTries; ++tries)
    fillet = fillet_of(before, after, arc_before, arc_after, reach *= kShorter);
  return fillet;
}

bool is_corner(const Bezier& before, const Bezier& after, double angle) {
  // A handle turned by half the angle moves its end by that much, and the curve by at most 4/9 of it.
  const double handle = std::max(glm::distance(before[2], before[3]), glm::distance(after[0], after[1]));
  return 4.0 / 9 * handle * angle / 2 > kTurnedOff || angle > base::radians(kSharpest);
}

// Returns the parameter where a curve is slowest: at a cusp the derivative vanishes.
double slowest(const Bezier& b) {
  constexpr int kSamples = 32, kHalvings = 40;
  const auto speed = [&](double t) { return glm::length(slope(b, t)); };
  double best = 0;
  for (int k = 1; k <= kSamples; ++k)
    if (const double t = static_cast<double>(k) / kSamples; speed(t) < speed(best)) best = t;
  double step = 1.0 / kSamples;
  for (int i = 0; i < kHalvings; ++i, step /= 2)
    for (const double t : {std::max(best - step, 0.0), std::min(best + step, 1.0)})
      if (speed(t) < speed(best)) best = t;
  return best;
}

// Returns the direction of travel kCornerOff away from the point at t, towards the end 0 or 1; at that end if it is
// nearer.
dvec3 direction_beside(const Bezier& b, double t, double end) {
  constexpr int kHalvings = 40;
  const dvec3 here = point(b, t);
  double near = t, far = end;
  for (int i = 0; i < kHalvings && glm::distance(point(b, end), here) > kCornerOff; ++i) {
    const double middle = 0.5 * (near + far);
    (glm::distance(point(b, middle), here) > kCornerOff ? far : near) = middle;
  }
  if (far == 0) return start_direction(b);
  return far == 1 ? end_direction(b) : glm::normalize(slope(b, far));
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

PlaceOnTrack place_on(const sim::DerivedTrack& derived, double distance) {
  const sim::TrackPlace at = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[at.index]);
  const double within = std::min(at.s, shape.arc.length());
  return {sim::rails_at(shape, within), sim::rails_frame_at(shape, within)};
}

std::vector<SplinePiece> round_corners(const std::vector<SplinePiece>& pieces, bool closed,
                                       std::vector<Corner>& corners) {
  std::vector<std::optional<Fillet>> fillets(pieces.size());  // at the start of each piece
  for (std::size_t i = closed ? 0 : 1; i < pieces.size(); ++i) {
    const Bezier &before = pieces[i > 0 ? i - 1 : pieces.size() - 1].curve, &after = pieces[i].curve;
    const double angle = curve::angle_between(end_direction(before), start_direction(after));
    if (!is_corner(before, after, angle)) continue;
    if (angle <= base::radians(kSharpest) + 1e-6) fillets[i] = round_corner(before, after, angle);
    corners.push_back({pieces[i].vertex, angle, fillets[i] ? fillets[i]->off : 0});
  }
  std::vector<SplinePiece> rounded;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto &start = fillets[i], &end = i + 1 < pieces.size() ? fillets[i + 1] : fillets[0];
    rounded.push_back({part(pieces[i].curve, start ? start->joins : 0, end ? end->leaves : 1), pieces[i].vertex});
    if (end) rounded.push_back({end->curve, pieces[i + 1 < pieces.size() ? i + 1 : 0].vertex});
  }
  return rounded;
}

std::optional<Corner> find_fold(const std::vector<SplinePiece>& pieces, bool closed) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SplinePiece &piece = pieces[i], &next = pieces[(i + 1) % pieces.size()];
    const double t = slowest(piece.curve);
    const double within =
        curve::angle_between(direction_beside(piece.curve, t, 0), direction_beside(piece.curve, t, 1));
    if (within > base::radians(kSharpest)) return Corner{piece.vertex, within, 0};
    const double corner = curve::angle_between(end_direction(piece.curve), start_direction(next.curve));
    if ((i + 1 == pieces.size() && !closed) || is_corner(piece.curve, next.curve, corner)) continue;
    const double across = curve::angle_between(direction_beside(piece.curve, 1, 0), direction_beside(next.curve, 0, 1));
    if (across > base::radians(kSharpest)) return Corner{next.vertex, across, 0};
  }
  return std::nullopt;
}

}  // namespace coaster::exchange
