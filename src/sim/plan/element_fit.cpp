#include "sim/plan/element_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"
#include "base/portable_math.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "curve/span_fit.h"
#include "curve/span_search.h"
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
void shift_second(curve::SpanKnots& n, const ElementCurve& curve, std::span<const std::size_t> at, bool last,
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
                                  const curve::SpanKnots& n) {
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

// Follows the ideal curve's points along a span. The frame is computed as the track's (sim/shape/derived_track.cpp):
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
  curve::SpanKnots n = curve::span_nodes(ends);
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

namespace {

constexpr double kTurnOfSpan = 1.6;  // rad, largest turn of an initial span
constexpr int kMostRounds = 60, kMostSpans = 2000, kRemovalRounds = 4;
constexpr std::size_t kMostThinning = 400'000;  // points times knots: beyond it no knots are removed
constexpr double kFarFromExact = 1e-9;
constexpr double kOfG2 = 0.6;  // of the largest jump that is G2

struct FitBounds {
  double distance, roll;
  std::vector<double> jumps;  // 1/m, by knot
};

// Float rounds a coordinate by half an ulp, which no fit can avoid.
double half_ulp(dvec3 p) {
  const dvec3 size = glm::abs(p);
  return std::max({size.x, size.y, size.z}) * 0x1p-24;
}

// An error e of a control point changes the curvature at a joint by about 8 e / handle^2, with the shorter handle
// there.
FitBounds bounds_for(const ElementCurve& curve, std::span<const std::size_t> at) {
  const std::size_t last = at.size() - 1;
  std::vector<double> rounding, shortest(at.size(), curve.length());
  for (const std::size_t i : at) rounding.push_back(half_ulp(curve.points[i].position));
  const double largest = *std::max_element(rounding.begin(), rounding.end());
  for (std::size_t k = 1; k <= last; ++k) {
    const double length = curve.points[at[k]].s - curve.points[at[k - 1]].s;
    for (double* const beside : {&shortest[k - 1], &shortest[k]}) *beside = std::min(*beside, length);
  }
  FitBounds bounds{kElementDistance + 2.0 * largest, base::radians(kElementRoll_deg), {}};
  for (std::size_t k = 0; k <= last; ++k) {
    const double error = std::max({rounding[k], rounding[k > 0 ? k - 1 : k], rounding[k < last ? k + 1 : k]}),
                 handle = std::max(shortest[k] / 3.0, kFarFromExact);
    bounds.jumps.push_back((k == last ? kElementEnd : kElementJump) + 8.0 * error / (handle * handle));
  }
  return bounds;
}

// A choice of knots among the curve's points, and the checks of its spans.
struct KnotChoiceTrial : curve::SpanTrial {
  Spans spans;
  FitBounds bounds;
  std::vector<SpanCheck> checks;
};

KnotChoiceTrial try_places(const ElementCurve& curve, std::vector<std::size_t> ends) {
  KnotChoiceTrial trial{{std::move(ends), {}}, {}, {}, {}};
  trial.spans = make_spans(curve, trial.ends);
  trial.bounds = bounds_for(curve, trial.ends);
  trial.checks.resize(trial.ends.size() - 1);
  return trial;
}

// Checks span k.
bool holds(const ElementCurve& curve, KnotChoiceTrial& t, std::size_t k) {
  const std::span<const ElementPoint> points(curve.points);
  const SpanCheck& check = t.checks[k] =
      check_span(points.subspan(t.ends[k], t.ends[k + 1] - t.ends[k] + 1), t.spans.knots[k], t.spans.knots[k + 1]);
  return check.sound && check.slopes && check.error <= t.bounds.distance && check.roll_error <= t.bounds.roll &&
         t.spans.jumps[k] <= t.bounds.jumps[k] && t.spans.jumps[k + 1] <= t.bounds.jumps[k + 1] &&
         t.spans.strains[k] <= kOfG2 && t.spans.strains[k + 1] <= kOfG2;
}

// Checks spans from `first`, cyclically, until one fails.
bool all_hold(const ElementCurve& curve, KnotChoiceTrial& t, std::size_t first) {
  const std::size_t count = t.checks.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!holds(curve, t, (first + i) % count)) return false;
  return true;
}

// Sets the difficulties from the checks.
void rate(KnotChoiceTrial& t) {
  t.difficulties.clear();
  for (const SpanCheck& check : t.checks) {
    const double distance = std::sqrt(std::sqrt(check.error / t.bounds.distance)),
                 roll = std::sqrt(check.roll_error / t.bounds.roll);
    t.difficulties.push_back(std::max({distance, roll, 0.1}));
  }
}

// Checks all spans. Returns those that fail.
std::vector<std::size_t> judge(const ElementCurve& curve, KnotChoiceTrial& t) {
  std::vector<std::size_t> failing;
  for (std::size_t k = 0; k < t.checks.size(); ++k)
    if (!holds(curve, t, k)) failing.push_back(k);
  t.holds = failing.empty();
  return failing;
}

// Returns the total turn of a piece, rad, from its points.
double turn_of(const ElementCurve& curve, std::size_t first, std::size_t last) {
  double turn = 0;
  for (std::size_t i = first + 1; i <= last; ++i)
    turn += glm::length(curve.points[i].curvature) * (curve.points[i].s - curve.points[i - 1].s);
  return turn;
}

// Returns the first point at least that far along the curve.
std::size_t point_at(const ElementCurve& curve, double s) {
  const auto found = std::ranges::lower_bound(curve.points, s, {}, &ElementPoint::s);
  return static_cast<std::size_t>(found - curve.points.begin());
}

// Returns the ends of the pieces and, evenly spaced between them by length, points for the given number of spans of
// each piece.
std::vector<std::size_t> places_for(const ElementCurve& curve, std::span<const int> counts) {
  std::vector<std::size_t> at{0};
  for (std::size_t p = 0; p + 1 < curve.breaks.size(); ++p) {
    const std::size_t first = curve.breaks[p], last = curve.breaks[p + 1];
    const double from = curve.points[first].s, length = curve.points[last].s - from;
    for (int i = 1; i < counts[p]; ++i) {
      const double wanted = from + length * i / counts[p];
      const std::size_t place = point_at(curve, wanted);
      if (place > at.back() && place < last) at.push_back(place);
    }
    at.push_back(last);
  }
  return at;
}

// Adds spans to the pieces with failing spans. Returns 0: none fails; 1: more to try; -1: nothing more to do.
int refine(const ElementCurve& curve, KnotChoiceTrial& trial, std::vector<int>& counts) {
  const std::vector<std::size_t> failing = judge(curve, trial);
  bool changed = false;
  for (std::size_t p = 0; p + 1 < curve.breaks.size(); ++p) {
    const std::size_t first = curve.breaks[p], last = curve.breaks[p + 1];
    const bool good = std::ranges::none_of(
        failing, [&](std::size_t k) { return trial.ends[k] >= first && trial.ends[k + 1] <= last; });
    if (good || counts[p] >= kMostSpans || static_cast<std::size_t>(counts[p]) >= last - first) continue;
    counts[p] += 1 + counts[p] / 8;
    changed = true;
  }
  return failing.empty() ? 0 : changed ? 1 : -1;
}

// Removes knots while all checks pass: first in pairs symmetric about the middle, as most elements are symmetric, then
// singly.
void thin(const ElementCurve& curve, KnotChoiceTrial& best) {
  const auto attempt = [&](std::size_t k, std::size_t other) {
    std::vector<std::size_t> fewer = best.ends;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(other));
    if (k != other) fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    KnotChoiceTrial trial = try_places(curve, std::move(fewer));
    if (!all_hold(curve, trial, k - 1)) return false;
    best = std::move(trial);
    return true;
  };
  for (std::size_t k = 1; 2 * k + 1 <= best.ends.size();)
    if (!attempt(k, best.ends.size() - 1 - k)) ++k;
  for (std::size_t k = 1; k + 1 < best.ends.size();)
    if (!attempt(k, k)) ++k;
}

// Returns the break within that many metres of a length along the curve, else the point there.
std::size_t break_near(const ElementCurve& curve, double s, double within) {
  const auto place = [&](std::size_t at) { return curve.points[at].s; };
  const auto near = std::ranges::lower_bound(curve.breaks, s - within, {}, place);
  if (near == curve.breaks.end() || curve.points[*near].s > s + within) return point_at(curve, s);
  const auto next = near + 1;
  const bool closer =
      next != curve.breaks.end() && std::abs(curve.points[*next].s - s) < std::abs(curve.points[*near].s - s);
  return closer ? *next : *near;
}

// Returns the ends of spans of about those lengths, at breaks where these are near; nothing if they have no room.
std::vector<std::size_t> places_of(const ElementCurve& curve, std::span<const double> lengths) {
  constexpr double kNear = 2;  // m
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  const double rest = curve.length() - std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<std::size_t> at{0};
  double s = 0;
  for (auto length = lengths.begin(); length != lengths.end(); ++length) {
    s += *length + (length == longest ? rest : 0.0);
    const bool last = length + 1 == lengths.end();
    const std::size_t place = last ? curve.points.size() - 1 : break_near(curve, s, std::min(kNear, 0.3 * *length));
    if (place <= at.back() || place + (last ? 0 : 1) >= curve.points.size()) return {};
    at.push_back(place);
  }
  return at;
}

ElementFit fit_of(KnotChoiceTrial trial, bool within) {
  ElementFit fit;
  fit.within = within;
  for (const SpanCheck& check : trial.checks)
    fit.error = std::max(fit.error, check.error), fit.roll_error = std::max(fit.roll_error, check.roll_error);
  for (const double jump : trial.spans.jumps) fit.jump = std::max(fit.jump, jump);
  fit.knots = std::move(trial.spans.knots);
  return fit;
}

}  // namespace

ElementFit fit_element(const ElementCurve& curve, std::span<const double> lengths) {
  constexpr int kRounds = 3;
  std::vector<std::size_t> at = places_of(curve, lengths);
  for (int round = 0; round < kRounds && at.size() > 1; ++round) {
    KnotChoiceTrial trial = try_places(curve, std::move(at));
    const std::vector<std::size_t> failing = judge(curve, trial);
    if (failing.empty()) return fit_of(std::move(trial), true);
    at = curve::halved(trial.ends, failing);
  }
  return fit_element(curve);
}

ElementFit fit_element(const ElementCurve& curve) {
  COASTER_CHECK(curve.points.size() >= 2 && curve.breaks.size() >= 2, "an element has a length");
  std::vector<int> counts;
  for (std::size_t p = 0; p + 1 < curve.breaks.size(); ++p)
    counts.push_back(std::clamp(
        static_cast<int>(turn_of(curve, curve.breaks[p], curve.breaks[p + 1]) / kTurnOfSpan) + 1, 1, kMostSpans));
  KnotChoiceTrial trial = try_places(curve, places_for(curve, counts));
  int more = refine(curve, trial, counts);
  for (int round = 0; round < kMostRounds && more > 0; ++round) {
    trial = try_places(curve, places_for(curve, counts));
    more = refine(curve, trial, counts);
  }
  const bool within = more == 0;
  if (within && curve.points.size() * trial.ends.size() <= kMostThinning) {
    thin(curve, trial);
    rate(trial);
    const auto attempt = [&](std::vector<std::size_t> ends) {
      KnotChoiceTrial fewer = try_places(curve, std::move(ends));
      judge(curve, fewer);
      rate(fewer);
      return fewer;
    };
    curve::remove_spans(trial, kRemovalRounds, attempt, [](KnotChoiceTrial&) { return false; });
  }
  return fit_of(std::move(trial), within);
}

}  // namespace coaster::sim
