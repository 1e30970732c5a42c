// Fits spans to the path of a force section, judged by what riders feel.
#include "sim/plan/force_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "curve/span_search.h"
#include "sim/ride/train.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

struct SpanError {
  SpanCheck check;
  FeltError felt;
  double at_ends = 0;  // g, the part of it at the two knots
};

// Returns the squared speed at which curvature is judged at a point of the path, m^2/s^2: that of the train, or on a
// section of curvature that of world::kCurvatureSpeed.
double judged_square(const ForceTask& task, const ForcePoint& point) {
  const bool at_any = task.program.of == world::ForceQuantity::curvature;
  return at_any ? world::kCurvatureSpeed * world::kCurvatureSpeed : point.square;
}

constexpr double kNoSpan = 1e9;  // g: the span does not follow the path

// How the spans are judged at a point of the path: by what riders feel there. On a section of curvature, which has to
// be the same at any speed, by what they would feel on the curve itself at world::kCurvatureSpeed.
struct FeltReference {
  double square, along, riders;  // m^2/s^2, m/s^2, m above the curve
  double up, side;               // g felt on the path
};
FeltReference judged_at(const ForceTask& task, const ForcePath& path, std::size_t i) {
  const ForcePoint& point = path.points[i];
  const double square = judged_square(task, point);
  if (task.program.of == world::ForceQuantity::forces) return {square, point.along, task.riders, point.up, point.side};
  const ElementPoint& on = path.curve.points[i];
  const FeltG felt = felt_on({on.position, on.tangent, on.up, square}, {on.curvature}, 0);
  return {square, 0, 0, felt.up, felt.side};
}

// Returns the errors of the span between two knots against the path's points from `first` to `last`.
SpanError span_error(const ForceTask& task, const ForcePath& path, std::size_t first, std::size_t last,
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
    const FeltReference asked = judged_at(task, path, first + i);
    const double t = places[i].t;
    const dvec3 first_derivative = c.derivative(t);
    const dvec3 curvature = c.second_derivative(t) / glm::dot(first_derivative, first_derivative);
    const FeltG felt = felt_on({c.point(t), frame.forward, frame.up, asked.square},
                               {curvature, roll.spin(s), roll.slope(s), asked.along}, asked.riders);
    const double off = std::max(std::abs(felt.up - asked.up), std::abs(felt.side - asked.side));
    if (!(off <= error.felt.error)) error.felt = {off, first + i};
    if (i == 0 || i + 1 == points.size()) error.at_ends = std::max(error.at_ends, off);
  }
  return error;
}

// Returns the fewest points that a span from there may cover: in a shorter one, riders would feel the rounding of its
// control points to float. An error e of a control point changes a curvature by about 72 e / length^2.
std::size_t fewest_points(const ForceTask& task, const ForcePath& path, std::size_t from) {
  constexpr double kStep = 0.25;  // m
  const dvec3 place = glm::abs(path.curve.points[from].position);
  const double half_ulp = std::max({place.x, place.y, place.z}) * 0x1p-24,
               square =
                   72 * half_ulp * judged_square(task, path.points[from]) / (world::kGravity * task.program.tolerance);
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(square) / kStep));
}

// Finds the largest length of single spans.
class LongestSpanSearch {
 public:
  // `at_ends`: the fraction of the tolerance that a span may use at its knots. Joints combine the errors of
  // neighbouring spans there, so a span may not use all of it.
  LongestSpanSearch(const ForceTask& task, const ForcePath& path, double at_ends)
      : task_(task), path_(path), at_ends_(at_ends) {}

  // Returns the ends of spans that are each as long as possible, from the first point on or from the last one back. The
  // span before the last one leaves that its fewest points.
  std::vector<std::size_t> ends(bool back) {
    const std::size_t last = path_.points.size() - 1;
    std::vector<std::size_t> at{0};
    for (std::size_t length = kFirst; at.back() < last;) {
      const std::size_t room = last - at.back(), least = fewest_points(task_, path_, back ? 0 : last);
      length = reach(at.back(), room, length, back);
      if (length < room && room - length < least) length = std::max(room - least, room / 2);
      at.push_back(at.back() + length);
    }
    if (!back) return at;
    for (std::size_t& place : at) place = last - place;
    std::reverse(at.begin(), at.end());
    return at;
  }

 private:
  static constexpr std::size_t kFirst = 16;

  bool holds(std::size_t from, std::size_t length, bool back) const {
    const std::size_t last = path_.points.size() - 1;
    const std::array<std::size_t, 2> at =
        back ? std::array{last - from - length, last - from} : std::array{from, from + length};
    const Spans span = make_spans(path_.curve, at, 0);
    const SpanError error = span_error(task_, path_, at[0], at[1], span.knots[0], span.knots[1]);
    constexpr double kReserve = 0.93, kDistance = 0.6;  // of the tolerances: turning tangents moves the spans slightly
    const double tolerance = task_.program.tolerance;
    return error.felt.error <= kReserve * tolerance && error.at_ends <= at_ends_ * tolerance &&
           error.check.error <= kDistance * kElementDistance &&
           error.check.roll_error <= base::radians(kElementRoll_deg);
  }

  // Returns the largest number of points, at most `room`, that one span covers, or the smallest allowed; tries `guess`
  // first.
  std::size_t reach(std::size_t from, std::size_t room, std::size_t guess, bool back) const {
    const std::size_t least = fewest_points(task_, path_, back ? path_.points.size() - 1 - from : from);
    if (room <= least) return room;
    return curve::longest_span(least, room, guess, {.growth = 3, .more = 1, .by_quarters = true},
                               [&](std::size_t length) { return holds(from, length, back); });
  }

  const ForceTask& task_;
  const ForcePath& path_;
  double at_ends_;
};

struct ForceFitAttempt : curve::SpanTrial {
  Spans spans;
  std::vector<SpanError> errors;
  std::vector<double> strains;  // of the spans: the largest error as a part of what is allowed
  std::vector<std::size_t> failing;
  // Returns the span with the largest strain.
  std::size_t worst() const {
    return static_cast<std::size_t>(std::max_element(strains.begin(), strains.end()) - strains.begin());
  }
};

// Returns how far the second knot may move sideways, m, for the curvature at the start: riders on the neighbouring
// spans feel about that share of the tolerance, or less.
double shift_at(const ForceTask& task, const ForcePath& path, const std::vector<std::size_t>& at, double share) {
  if (at.size() < 3) return 0;
  const auto& points = path.curve.points;
  const auto length = [&](std::size_t k) { return points[at[k + 1]].s - points[at[k]].s; };
  const double least = std::min({length(0), length(1), length(at.size() - 3), length(at.size() - 2)}),
               square = std::max(judged_square(task, path.points.front()), judged_square(task, path.points.back()));
  return std::min(kMostShift, share * task.program.tolerance * world::kGravity / square * least * least / 6);
}

// Returns the jump at a knot as a part of what is allowed: inside the section any that is G2.
double jump_strain(const ForceTask& task, const Spans& spans, std::size_t knot) {
  const std::size_t last = spans.jumps.size() - 1;
  if (knot == last && !task.held) return 0;
  const double strain = knot == 0 || knot == last ? spans.jumps[knot] / kElementJump : 0;
  return spans.strains[knot] > 1 ? std::max(strain, spans.strains[knot]) : strain;
}

ForceFitAttempt attempt_with(const ForceTask& task, const ForcePath& path, std::vector<std::size_t> at, double share) {
  constexpr double kAtPoints = 0.99;  // of the tolerance: between the path's points riders feel slightly more
  constexpr double kEasiest = 0.1, kHardest = 2.5;
  ForceFitAttempt now{{std::move(at), {}}, {}, {}, {}, {}};
  now.spans = make_spans(path.curve, now.ends, shift_at(task, path, now.ends, share));
  for (std::size_t k = 0; k + 1 < now.ends.size(); ++k) {
    const world::Knot &from = now.spans.knots[k], &to = now.spans.knots[k + 1];
    now.errors.push_back(span_error(task, path, now.ends[k], now.ends[k + 1], from, to));
    const SpanError& error = now.errors.back();
    const double jump = std::max(jump_strain(task, now.spans, k), jump_strain(task, now.spans, k + 1));
    now.strains.push_back(std::max({error.felt.error / (kAtPoints * task.program.tolerance), jump,
                                    error.check.roll_error / base::radians(kElementRoll_deg)}));
    if (!(now.strains.back() <= 1)) now.failing.push_back(k);
    // The error grows with the square of the length.
    now.difficulties.push_back(std::clamp(std::sqrt(error.felt.error / task.program.tolerance), kEasiest, kHardest));
  }
  now.strain = now.strains[now.worst()], now.holds = now.failing.empty();
  return now;
}

ForceFitAttempt attempt(const ForceTask& task, const ForcePath& path, const std::vector<std::size_t>& at) {
  ForceFitAttempt best = attempt_with(task, path, at, 0.25);
  for (const double share : {1.0, 4.0}) {
    if (std::max(jump_strain(task, best.spans, 0), jump_strain(task, best.spans, at.size() - 1)) <= 1) break;
    ForceFitAttempt farther = attempt_with(task, path, at, share);
    if (farther.strain < best.strain) best = std::move(farther);
  }
  return best;
}

// Returns the span to halve in order to mend a failing one: itself, or a longer neighbour at the joint where it fails.
std::size_t longer(const ForceFitAttempt& attempt, std::size_t k) {
  if (attempt.errors[k].felt.error >= kNoSpan) return k;
  const auto length = [&](std::size_t i) { return attempt.ends[i + 1] - attempt.ends[i]; };
  const std::size_t worst = attempt.errors[k].felt.at;
  if (worst == attempt.ends[k] && k > 0 && length(k - 1) > length(k)) return k - 1;
  if (worst == attempt.ends[k + 1] && k + 1 < attempt.errors.size() && length(k + 1) > length(k)) return k + 1;
  return k;
}

// Halves spans until none fails or none can be halved. Those that do not follow the path are halved even where
// rounding will then be felt.
ForceFitAttempt mended(const ForceTask& task, const ForcePath& path, ForceFitAttempt now) {
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds && !now.holds; ++round) {
    std::vector<std::size_t> spans;
    for (const std::size_t k : now.failing) {
      const std::size_t span = longer(now, k), first = now.ends[span], last = now.ends[span + 1];
      const bool follows = now.errors[span].felt.error < kNoSpan;
      if (last - first >= 2 * (follows ? fewest_points(task, path, first) : 1)) spans.push_back(span);
    }
    if (spans.empty()) break;
    now = attempt(task, path, curve::halved(now.ends, spans));
  }
  return now;
}

constexpr std::size_t kEasing = 12'000;  // points of paths that easing may try: some 5 ms

// Moves single knots near the span with the largest strain as long as that strain falls and spans fail. `budget`:
// points of paths that may still be tried.
void ease(const ForceTask& task, const ForcePath& path, ForceFitAttempt& now, std::size_t& budget) {
  const auto moved = [&](std::size_t knot, int by) {
    const auto place = static_cast<std::ptrdiff_t>(now.ends[knot]) + by;
    const bool room = place > static_cast<std::ptrdiff_t>(now.ends[knot - 1]) &&
                      place < static_cast<std::ptrdiff_t>(now.ends[knot + 1]);
    if (!room || budget < path.points.size()) return false;
    budget -= path.points.size();
    std::vector<std::size_t> at = now.ends;
    at[knot] = static_cast<std::size_t>(place);
    ForceFitAttempt next = attempt(task, path, at);
    if (!(next.strain < 0.999 * now.strain)) return false;
    now = std::move(next);
    return true;
  };
  const auto eased = [&](int by) {
    const std::size_t worst = now.worst(), last = now.ends.size() - 1;
    for (std::size_t knot = std::max<std::size_t>(worst, 1); knot < std::min(worst + 3, last); ++knot) {
      const int shorter = knot <= worst ? by : -by;  // the worst span first
      if (moved(knot, shorter) || moved(knot, -shorter)) return true;
    }
    return false;
  };
  const auto eased_before = [&](int by) {
    const std::size_t worst = now.worst();
    return worst > 1 && (moved(worst - 1, by) || moved(worst - 1, -by));
  };
  while (!now.holds && (eased(8) || eased(4) || eased(2) || eased(1) || eased_before(2))) {
  }
}

// Tries one span fewer, evened out over several rounds and eased, until that fails.
void even_out(const ForceTask& task, const ForcePath& path, ForceFitAttempt& best) {
  constexpr int kRounds = 5;
  constexpr std::size_t kEased = 200;  // points of the longest path that is eased
  std::size_t budget = path.points.size() <= kEased ? kEasing : 0;
  curve::remove_spans(
      best, kRounds, [&](const std::vector<std::size_t>& ends) { return attempt(task, path, ends); },
      [&](ForceFitAttempt& least) {
        ease(task, path, least, budget);
        return least.holds;
      });
}

// Returns spans that are as long as possible, built from the start, from the end, or from both to the middle.
ForceFitAttempt best_places(const ForceTask& task, const ForcePath& path) {
  constexpr std::size_t kShort = 600;  // points: longer paths are tried once and not evened out
  const bool quick = path.points.size() > kShort;
  std::optional<ForceFitAttempt> best;
  for (const double at_ends : {0.95, 0.7, 0.5}) {
    if (quick && at_ends > 0.5) continue;
    LongestSpanSearch reach(task, path, at_ends);
    const std::vector<std::size_t> first = reach.ends(false), second = reach.ends(true);
    std::vector<std::vector<std::size_t>> places{second, first};
    if (first.size() == second.size())
      for (std::size_t k = 0; k < first.size(); ++k) places[0][k] = (first[k] + second[k]) / 2;
    for (const std::vector<std::size_t>& at : places) {
      ForceFitAttempt now = attempt(task, path, at);
      if (!best || now.failing.size() < best->failing.size()) best = std::move(now);
      if (best->holds) break;
    }
    if (best->holds) break;
  }
  ForceFitAttempt done = mended(task, path, std::move(*best));
  std::size_t budget = kEasing;
  ease(task, path, done, budget);
  if (done.holds && !quick) even_out(task, path, done);
  return done;
}

}  // namespace

FeltError felt_error(const ForceTask& task, const ForcePath& path, std::size_t first, std::size_t last,
                     const world::Knot& from, const world::Knot& to) {
  return span_error(task, path, first, last, from, to).felt;
}

ForceFit fit_force(const ForceTask& task, const ForcePath& path) {
  ForceFitAttempt now = best_places(task, path);
  ForceFit fit;
  fit.within = now.holds;
  for (const SpanError& error : now.errors) {
    fit.spans.error = std::max(fit.spans.error, error.check.error);
    fit.spans.roll_error = std::max(fit.spans.roll_error, error.check.roll_error);
    if (error.felt.error > fit.felt_error)
      fit.felt_error = error.felt.error, fit.felt_at = path.curve.points[error.felt.at].s;
  }
  for (const double jump : now.spans.jumps) fit.spans.jump = std::max(fit.spans.jump, jump);
  fit.spans.knots = std::move(now.spans.knots);
  fit.spans.within = fit.within;
  return fit;
}

}  // namespace coaster::sim
