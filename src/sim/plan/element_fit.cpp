#include "sim/plan/element_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.h"
#include "base/portable_math.h"
#include "sim/plan/element_spans.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kTurnOfSpan = 1.6;  // rad, largest turn of an initial span
constexpr int kMostRounds = 60, kMostSpans = 2000;
constexpr std::size_t kMostThinning = 400'000;  // points times knots: beyond it no knots are removed
constexpr double kFarFromExact = 1e-9;
constexpr double kOfG2 = 0.6;  // of the largest jump that is G2

struct Bounds {
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
Bounds bounds_for(const ElementCurve& curve, std::span<const std::size_t> at) {
  const std::size_t last = at.size() - 1;
  std::vector<double> rounding, shortest(at.size(), curve.length());
  for (const std::size_t i : at) rounding.push_back(half_ulp(curve.points[i].position));
  const double largest = *std::max_element(rounding.begin(), rounding.end());
  for (std::size_t k = 1; k <= last; ++k) {
    const double length = curve.points[at[k]].s - curve.points[at[k - 1]].s;
    for (double* const beside : {&shortest[k - 1], &shortest[k]}) *beside = std::min(*beside, length);
  }
  Bounds bounds{kElementDistance + 2.0 * largest, base::radians(kElementRoll_deg), {}};
  for (std::size_t k = 0; k <= last; ++k) {
    const double error = std::max({rounding[k], rounding[k > 0 ? k - 1 : k], rounding[k < last ? k + 1 : k]}),
                 handle = std::max(shortest[k] / 3.0, kFarFromExact);
    bounds.jumps.push_back((k == last ? kElementEnd : kElementJump) + 8.0 * error / (handle * handle));
  }
  return bounds;
}

// A choice of knots, and the checks of its spans.
struct Trial {
  std::vector<std::size_t> at;  // indices into the curve's points
  Spans spans;
  Bounds bounds;
  std::vector<SpanCheck> checks;
};

Trial try_places(const ElementCurve& curve, std::vector<std::size_t> at) {
  Trial trial{std::move(at), {}, {}, {}};
  trial.spans = make_spans(curve, trial.at);
  trial.bounds = bounds_for(curve, trial.at);
  trial.checks.resize(trial.at.size() - 1);
  return trial;
}

// Checks span k.
bool holds(const ElementCurve& curve, Trial& t, std::size_t k) {
  const std::span<const ElementPoint> points(curve.points);
  const SpanCheck& check = t.checks[k] =
      check_span(points.subspan(t.at[k], t.at[k + 1] - t.at[k] + 1), t.spans.knots[k], t.spans.knots[k + 1]);
  return check.sound && check.slopes && check.error <= t.bounds.distance && check.roll_error <= t.bounds.roll &&
         t.spans.jumps[k] <= t.bounds.jumps[k] && t.spans.jumps[k + 1] <= t.bounds.jumps[k + 1] &&
         t.spans.strains[k] <= kOfG2 && t.spans.strains[k + 1] <= kOfG2;
}

// Checks spans from `first`, cyclically, until one fails.
bool all_hold(const ElementCurve& curve, Trial& t, std::size_t first) {
  const std::size_t count = t.checks.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!holds(curve, t, (first + i) % count)) return false;
  return true;
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
  const auto found = std::lower_bound(curve.points.begin(), curve.points.end(), s,
                                      [](const ElementPoint& point, double wanted) { return point.s < wanted; });
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
int refine(const ElementCurve& curve, Trial& trial, std::vector<int>& counts) {
  bool changed = false, all = true;
  std::size_t k = 0;
  for (std::size_t p = 0; p + 1 < curve.breaks.size(); ++p) {
    bool good = true;
    for (; k + 1 < trial.at.size() && trial.at[k + 1] <= curve.breaks[p + 1]; ++k)
      good = holds(curve, trial, k) && good;
    all = all && good;
    if (good || counts[p] >= kMostSpans || static_cast<std::size_t>(counts[p]) >= curve.breaks[p + 1] - curve.breaks[p])
      continue;
    counts[p] += 1 + counts[p] / 8;
    changed = true;
  }
  return all ? 0 : changed ? 1 : -1;
}

// Removes knots while all checks pass: first in pairs symmetric about the middle, as most elements are symmetric, then
// singly.
void thin(const ElementCurve& curve, Trial& best) {
  const auto attempt = [&](std::size_t k, std::size_t other) {
    std::vector<std::size_t> fewer = best.at;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(other));
    if (k != other) fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    Trial trial = try_places(curve, std::move(fewer));
    if (!all_hold(curve, trial, k - 1)) return false;
    best = std::move(trial);
    return true;
  };
  for (std::size_t k = 1; 2 * k + 1 <= best.at.size();)
    if (!attempt(k, best.at.size() - 1 - k)) ++k;
  for (std::size_t k = 1; k + 1 < best.at.size();)
    if (!attempt(k, k)) ++k;
}

// Returns the ends of `count` spans of about equal difficulty.
std::vector<std::size_t> evened(const ElementCurve& curve, const Trial& trial, std::size_t count) {
  std::vector<double> sums{0.0};
  for (const SpanCheck& check : trial.checks) {
    const double distance = std::sqrt(std::sqrt(check.error / trial.bounds.distance)),
                 roll = std::sqrt(check.roll_error / trial.bounds.roll);
    sums.push_back(sums.back() + std::max({distance, roll, 0.1}));
  }
  std::vector<std::size_t> places{0};
  for (std::size_t i = 1, k = 1; i < count; ++i) {
    const double wanted = sums.back() * static_cast<double>(i) / static_cast<double>(count);
    while (k + 1 < sums.size() && sums[k] < wanted) ++k;
    const double share = (wanted - sums[k - 1]) / (sums[k] - sums[k - 1]),
                 many = static_cast<double>(trial.at[k] - trial.at[k - 1]);
    const auto place = trial.at[k - 1] + static_cast<std::size_t>(share * many + 0.5);
    if (place > places.back() && place + 1 < curve.points.size()) places.push_back(place);
  }
  places.push_back(curve.points.size() - 1);
  return places;
}

// Tries one span fewer, evened out over several rounds, until that fails.
void even_out(const ElementCurve& curve, Trial& best) {
  constexpr int kRounds = 4;
  for (bool better = true; better && best.at.size() > 2;) {
    better = false;
    Trial trial = best;
    for (int round = 0; round < kRounds && !better; ++round) {
      trial = try_places(curve, evened(curve, trial, best.at.size() - 2));
      better = true;
      for (std::size_t k = 0; k < trial.checks.size(); ++k)
        better = holds(curve, trial, k) && better;  // all of them: the next round needs the results
    }
    if (better) best = std::move(trial);
  }
}

// Returns the break within that many metres of a length along the curve, else the point there.
std::size_t break_near(const ElementCurve& curve, double s, double within) {
  const auto before = [&](std::size_t at, double wanted) { return curve.points[at].s < wanted; };
  const auto near = std::lower_bound(curve.breaks.begin(), curve.breaks.end(), s - within, before);
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

ElementFit fit_of(Trial trial, bool within) {
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
    Trial trial = try_places(curve, std::move(at));
    bool all = true;
    at = {0};
    for (std::size_t k = 0; k < trial.checks.size(); ++k) {
      const bool good = holds(curve, trial, k);
      all = all && good;
      if (!good && trial.at[k + 1] - trial.at[k] > 1) at.push_back((trial.at[k] + trial.at[k + 1]) / 2);
      at.push_back(trial.at[k + 1]);
    }
    if (all) return fit_of(std::move(trial), true);
  }
  return fit_element(curve);
}

ElementFit fit_element(const ElementCurve& curve) {
  COASTER_CHECK(curve.points.size() >= 2 && curve.breaks.size() >= 2, "an element has a length");
  std::vector<int> counts;
  for (std::size_t p = 0; p + 1 < curve.breaks.size(); ++p)
    counts.push_back(std::clamp(
        static_cast<int>(turn_of(curve, curve.breaks[p], curve.breaks[p + 1]) / kTurnOfSpan) + 1, 1, kMostSpans));
  Trial trial = try_places(curve, places_for(curve, counts));
  int more = refine(curve, trial, counts);
  for (int round = 0; round < kMostRounds && more > 0; ++round) {
    trial = try_places(curve, places_for(curve, counts));
    more = refine(curve, trial, counts);
  }
  const bool within = more == 0;
  if (within && curve.points.size() * trial.at.size() <= kMostThinning) thin(curve, trial), even_out(curve, trial);
  return fit_of(std::move(trial), within);
}

}  // namespace coaster::sim
