// Fits a whole track to rows, and measures its distance from them on the displayed curves and frames.
#include "sim/fit/fit_track.h"

#include <algorithm>

#include "base/check.h"
#include "base/portable_math.h"
#include "curve/span_search.h"
#include "sim/fit/sample_interpolation.h"
#include "sim/fit/span_partition.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

constexpr std::size_t kFirstStride = 32;  // rows of the first span to try
constexpr double kLeastScale = 0.4;       // relative to the bounds
constexpr double kCopyScale = 0.2;        // the same for the rows of a track that was fitted before

// Returns the longest span from `first`; `usual`: the rows of the last one.
FittedSpan longest_span(FitState& w, std::size_t first, const RollRange& allowed, std::size_t usual) {
  const std::size_t end = w.rows.size() - 1;
  FittedSpan good{first, first + 1, w.fit(first, first + 1, allowed), allowed};
  const auto beyond = std::lower_bound(w.distances.begin() + static_cast<std::ptrdiff_t>(first), w.distances.end(),
                                       w.distances[first] + kLeastSpan);
  const auto short_rows = static_cast<std::size_t>(beyond - w.distances.begin()) - first;
  curve::longest_span(1, end - first, std::max<std::size_t>({usual, 2, short_rows}), {.coarseness = 64},
                      [&](std::size_t length) {
                        SpanFit fit = w.fit(first, first + length, allowed);
                        if (!fit.within) return false;
                        good.last = first + length, good.fit = std::move(fit);
                        return true;
                      });
  // A knot just before the end moves back slightly: the step that closes a track is shorter than the others.
  if (good.last < end && w.distances[end] - w.distances[good.last] < w.last_span) {
    std::size_t last = good.last;
    while (last > first + 1 && w.distances[end] - w.distances[last] < w.last_span) --last;
    SpanFit fit = w.fit(first, last, allowed);
    if (fit.within) good.last = last, good.fit = std::move(fit);
  }
  return good;
}

// Returns the rolls that a span allows the knot at its last row.
RollRange rolls_after(const FitState& w, std::size_t last, const SpanFit& fit) {
  const RollRange allowed = second_rolls(fit.window);
  return allowed.low > allowed.high ? RollRange{w.row_rolls.leans[last], w.row_rolls.leans[last]} : allowed;
}

// Where `span` bends too much, ends the span before it earlier, so that neither does. Changes nothing if no row will
// do.
void retreat(FitState& w, FittedSpan& span, std::size_t usual) {
  FittedSpan& before = w.spans.back();
  const std::size_t rows = before.last - before.first;
  for (std::size_t back = 1; back < rows && !w.cancelled(); back += 1 + back / 2) {
    const std::size_t last = before.last - back;
    SpanFit fit = w.fit(before.first, last, before.allowed);
    if (!fit.within || fit.bent) continue;
    FittedSpan tried = longest_span(w, last, rolls_after(w, last, fit), usual);
    if (tried.fit.bent || !tried.fit.within || tried.last < span.last) continue;
    before.last = last, before.fit = std::move(fit);
    span = std::move(tried);
    return;
  }
}

}  // namespace

void fit_spans(FitState& w, std::size_t most_spans) {
  const std::size_t end = w.rows.size() - 1;
  w.spans.clear();
  const double most = w.bounds().angle, seam = w.row_rolls.leans[0];
  RollRange allowed = w.closed ? RollRange{seam, seam} : RollRange{-most, most};
  std::size_t usual = kFirstStride;
  for (std::size_t first = 0; first < end && w.spans.size() <= most_spans && !w.cancelled();) {
    FittedSpan span = longest_span(w, first, allowed, usual);
    if (span.fit.bent && !w.spans.empty()) retreat(w, span, usual);
    usual = std::max<std::size_t>(2, span.last - span.first);
    allowed = rolls_after(w, span.last, span.fit);
    first = span.last;
    w.spans.push_back(std::move(span));
    w.tell(static_cast<double>(first) / static_cast<double>(end));
  }
  ++w.passes;
}

void even_out(FitState& w) {
  if (w.spans.size() < 2 || w.rows.size() > kEvenedRows) return;
  std::vector<FittedSpan> best = w.spans;
  const std::size_t fewest = best.size();
  const auto suffice = [&](double scale, std::size_t most) {
    w.scale = scale;
    fit_spans(w, most);
    if (w.spans.size() > most) return false;
    best = std::move(w.spans);
    return true;
  };
  // The rows of a track that was fitted before lie on spans that meet much tighter bounds with about as many knots. On
  // other rows a span's length scales with the second to fourth root of the bound: at kCopyScale there are half as many
  // spans more, and with n spans the bounds can shrink by 4 / n at most.
  if (!suffice(kCopyScale, fewest + fewest / 8 + 1) && !suffice(kLeastScale, fewest)) {
    double low = std::max(kLeastScale, 1 - 4.0 / static_cast<double>(fewest)), high = 1;
    for (int i = 0; i < kEvenings && !w.cancelled(); ++i) {
      const double middle = 0.5 * (low + high);
      (suffice(middle, fewest) ? high : low) = middle;
    }
  }
  w.scale = 1;
  w.spans = std::move(best);
}

namespace {

using glm::dvec3;

// m: rows whose frames are not fitted; less than the reach that the report excludes.
constexpr double kInnerReach = 0.45;
constexpr double kFeltRoot = 0.085;   // g: root mean square of what riders feel more or less than on the rows
constexpr double kLastSpan = 2;       // m: rolls within the bound would be felt in a shorter last span of rounded rows
constexpr double kFineHandle = 0.32;  // of a span of rounded rows: riders above the rails feel how curvature changes
constexpr int kMaxRounds = 12;        // rounds of halving spans that fail on the finished document

// Chooses a roll for every knot, from the last to the first, so that each span keeps its frames within the bound: that
// of the smooth roll, or as near to it as the bound allows. Beside other rolls a short span would turn quickly.
void choose_rolls(FitState& w) {
  w.rolls.assign(w.rows.size(), 0);
  if (w.spans.empty()) return;
  const auto [low, high] = second_rolls(w.spans.back().fit.window);
  const std::vector<double>& leans = w.row_rolls.leans;
  double roll = leans[w.spans.back().last];
  if (low <= high) roll = std::clamp(roll, low, high);
  w.rolls[w.spans.back().last] = roll;
  for (std::size_t i = w.spans.size(); i-- > 0;) {
    roll = i == 0 && w.closed ? leans[0] : first_roll(w.spans[i].fit.window, roll, leans[w.spans[i].first]);
    w.rolls[w.spans[i].first] = roll;
  }
}

world::Knot knot_of(const FitState& w, std::size_t at, double in, double out) {
  const FitRow& row = w.rows[at];
  world::Knot k;
  k.position = glm::vec3(row.position);
  k.tangent = glm::vec3(row.forward);
  k.up = glm::vec3(curve::perpendicular(row.forward, curve::rotate(row.up, row.forward, w.rolls[at])));
  k.spin = static_cast<float>(w.row_rolls.spins[at]);
  k.in_length = world::as_handle(in), k.out_length = world::as_handle(out);
  k.joint = k.in_length == k.out_length ? world::JointKind::smooth : world::JointKind::aligned;
  world::orthonormalise(k);
  return k;
}

world::Document document_of(const FitState& w, DerivedTrack& derived) {
  world::Document document;
  const std::size_t count = w.spans.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double in = i > 0      ? w.spans[i - 1].fit.in_length
                      : w.closed ? w.spans.back().fit.in_length
                                 : w.spans[i].fit.out_length;
    world::append_knot(document, knot_of(w, w.spans[i].first, in, w.spans[i].fit.out_length));
  }
  const FittedSpan& last = w.spans.back();
  if (w.closed) world::set_closed(document, true);
  else world::append_knot(document, knot_of(w, last.last, last.fit.in_length, last.fit.in_length));
  derived = shapes_of(document);
  // Whole turns: the rotation of the rows minus the rotation between the knots' frames.
  bool turned = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = w.spans[i].fit.roll + w.rolls[w.spans[i].last] - w.rolls[w.spans[i].first];
    const double turns = std::round((wanted - derived.shape_at(i).roll.twist) / (2 * base::kPi));
    if (turns == 0) continue;
    document.entities.get<world::Segment>(derived.order[i]).turns =
        static_cast<std::int32_t>(std::clamp<double>(turns, -world::kMaxTurns, world::kMaxTurns));
    turned = true;
  }
  if (turned) derived = shapes_of(document);
  return document;
}

// Halves the span: the new knot has the smooth roll.
void halve(FitState& w, const FittedSpan& span, std::vector<FittedSpan>& out) {
  const std::size_t middle = span.first + (span.last - span.first) / 2;
  const RollRange all{-w.bounds().angle, w.bounds().angle};
  w.rolls[middle] = w.row_rolls.leans[middle];
  out.push_back({span.first, middle, w.fit(span.first, middle, all), all});
  out.push_back({middle, span.last, w.fit(middle, span.last, all), all});
}

// `given`: the rows that `filled` are between.
FitState prepare(std::span<const FitRow> given, const FilledRows& filled, bool closed) {
  const std::vector<FitRow>& rows = filled.rows;
  FitState w;
  w.closed = closed;
  w.rows.assign(rows.begin(), rows.end());
  w.free = near_jumps(rows, closed, kInnerReach);
  const std::vector<double> bends = bend_limits(given, closed);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < rows.size(); ++i) w.bends.push_back(bends[filled.from[i]]);
  w.row_rolls = row_rolls(rows, closed);
  w.speeds = row_speeds(rows), w.curvatures = row_curvatures(rows, closed);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (w.free[i]) w.curvatures[i] = dvec3(0);
  for (double& spin : w.row_rolls.spins)
    spin = std::abs(spin) < kLeastSpin ? 0 : std::clamp<double>(spin, -world::kMaxSpin, world::kMaxSpin);
  if (closed) {
    w.rows.push_back(rows[0]), w.free.push_back(w.free[0]);
    for (std::vector<double>* const values : {&w.row_rolls.spins, &w.row_rolls.slopes, &w.row_rolls.leans})
      values->push_back(values->front());
    w.speeds.push_back(w.speeds[0]), w.curvatures.push_back(w.curvatures[0]);
  }
  w.distances.resize(w.rows.size());
  for (std::size_t i = 1; i < w.rows.size(); ++i)
    w.distances[i] = w.distances[i - 1] + glm::distance(w.rows[i - 1].position, w.rows[i].position);
  return w;
}

// Divides the rows into spans on which riders feel at most kFeltRoot more or less on average over the ride, too.
void fit_all(FitState& w) {
  constexpr int kTries = 4;
  constexpr double kLess = 0.95;  // of the bound that would suffice if errors scaled with it
  for (int i = 0; i < kTries && !w.cancelled(); ++i) {
    fit_spans(w);
    if (!w.cancelled()) even_out(w);
    FeltMiss all;
    for (const FittedSpan& span : w.spans) all.squares += span.fit.felt.squares, all.seconds += span.fit.felt.seconds;
    const double root = std::sqrt(all.squares / std::max(all.seconds, 1e-9));
    if (root <= kFeltRoot) break;
    w.felt_scale *= kLess * kFeltRoot / root;
  }
}

// Sets the bounds of rows that were rounded to the step. Returns the largest distance from the rows as they were, m.
double set_step(FitState& w, double step) {
  constexpr double kShare = 0.6, kMost = 0.002, kKnots = 0.85;  // of the step, m, and of the knots' own rounding
  w.last_span = kLastSpan, w.least_handle = kFineHandle;
  if (step <= 0) return kFitDistance;
  double spacing = 0;
  for (int axis = 0; axis < 3; ++axis) spacing = std::max(spacing, float_spacing(w.rows, axis));
  w.distance *= std::min(1.0, std::max(std::min(kShare * step, kMost), kKnots * spacing) / kFitDistance);
  return kSteps * std::max(step, spacing);
}

FeltUncertainty worst_doubt(std::span<const FitRow> rows, bool closed, const std::vector<double>& doubts) {
  const std::vector<char> jumps = near_jumps(rows, closed, kInnerReach);
  // Rows beside the track are no measure of its roll.
  const auto beside = [&](std::size_t i) {
    const std::size_t n = rows.size();
    const bool first = !closed && i == 0, last = !closed && i + 1 == n;
    return (!first && off_deg(rows[(i + n - 1) % n], rows[i]) > 0) ||
           (!last && off_deg(rows[i], rows[(i + 1) % n]) > 0);
  };
  FeltUncertainty worst;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!jumps[i] && doubts[i] > worst.g && !beside(i)) worst = {doubts[i], i};
  return worst;
}

}  // namespace

FittedTrack fit_track(std::span<const FitRow> rows, bool closed, std::span<const FitRow> given, double step) {
  COASTER_CHECK(rows.size() >= (closed ? 3u : 2u), "a track needs 2 rows, a closed one 3");
  const FilledRows filled = fill_rows(rows, closed);
  FitState w = prepare(rows, filled, closed);
  const double most = given.empty() ? kFitDistance : set_step(w, step);
  fit_all(w);
  if (w.cancelled()) return {};
  choose_rolls(w);
  if (closed && w.spans.size() == 1) {
    std::vector<FittedSpan> two;
    halve(w, w.spans[0], two);
    w.spans = std::move(two);
  }
  const std::vector<char> free = near_jumps(filled.rows, closed, kJumpReach);
  const FeltUncertainty roll_doubt = worst_doubt(
      rows, closed, roll_doubts(rows, closed, row_rolls(rows, closed), row_speeds(rows), world::Document{}.heartline));
  const FeltUncertainty bend_doubt = worst_doubt(rows, closed, bend_doubts(rows, closed, row_speeds(rows)));
  std::vector<FitRow> measured = filled.rows;
  std::vector<char> counted;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    counted.push_back(filled.given(i) ? 1 : 0);
    if (filled.given(i) && !given.empty()) measured[i] = given[filled.from[i]];
  }
  FittedTrack fitted;
  DerivedTrack derived;
  for (int round = 0; round < kMaxRounds; ++round) {
    fitted.document = document_of(w, derived);
    std::vector<std::size_t> ends;
    for (const FittedSpan& span : w.spans) ends.push_back(span.first);
    ends.push_back(w.spans.back().last);
    const std::vector<FitReport> reports = measure_spans(derived, measured, ends, free, counted);
    fitted.report = {0, 0, 0, static_cast<int>(fitted.document.track.knots.size()), roll_doubt, bend_doubt};
    std::vector<FittedSpan> next;
    for (std::size_t i = 0; i < reports.size(); ++i) {
      fitted.report.max_error = std::max(fitted.report.max_error, reports[i].max_error);
      fitted.report.frame_error = std::max(fitted.report.frame_error, reports[i].frame_error);
      fitted.report.jump_error = std::max(fitted.report.jump_error, reports[i].jump_error);
      fitted.report.distances.add(reports[i].distances), fitted.report.angles.add(reports[i].angles);
      const bool missed = reports[i].max_error > most || (given.empty() && reports[i].frame_error > kFitAngle);
      if (missed && w.spans[i].last > w.spans[i].first + 1) halve(w, w.spans[i], next);
      else next.push_back(w.spans[i]);
    }
    if (next.size() == w.spans.size()) break;
    w.spans = std::move(next);
  }
  base::report_progress(1);
  return fitted;
}

namespace {

// Returns the nearest parameter by Newton's method from `t`; searches the whole segment if that fails.
curve::NearestPoint nearest_from(const curve::Cubic& cubic, const curve::CoefficientsD& c, dvec3 target, double t) {
  for (int i = 0; i < 4; ++i) {
    const dvec3 off = c.point(t) - target, d = c.derivative(t);
    const double slope = glm::dot(d, d) + glm::dot(off, c.second_derivative(t));
    if (!(slope > 0)) break;
    t = std::clamp(t - glm::dot(off, d) / slope, 0.0, 1.0);
  }
  const double distance = glm::distance(curve::point(cubic, t), target);
  return distance <= 0.5 * kFitDistance ? curve::NearestPoint{t, distance} : curve::nearest_point(cubic, target);
}

}  // namespace

std::vector<FitReport> measure_spans(const DerivedTrack& derived, std::span<const FitRow> rows,
                                     std::span<const std::size_t> ends, std::span<const char> free,
                                     std::span<const char> given) {
  COASTER_CHECK(ends.size() == derived.order.size() + 1, "every segment covers a span of rows");
  std::vector<FitReport> reports(derived.order.size());
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    const curve::CoefficientsD c = curve::coefficients_d(shape.key.cubic);
    double guess = 0;
    for (std::size_t k = ends[i]; k <= ends[i + 1]; ++k) {
      const std::size_t r = k < rows.size() ? k : 0;
      // Starts from the previous row's parameter plus a mean step.
      const double mean = 1.0 / static_cast<double>(ends[i + 1] - ends[i]);
      const double start = k == ends[i] ? 0.0 : k == ends[i + 1] ? 1.0 : std::min(1.0, guess + mean);
      const curve::NearestPoint near = nearest_from(shape.key.cubic, c, rows[r].position, start);
      guess = near.t;
      if (!given[r]) continue;
      reports[i].max_error = std::max(reports[i].max_error, near.distance);
      const curve::Frame frame = frame_at(shape, shape.arc.distance(near.t));
      const double angle = frame_angle_deg(frame, {rows[r].forward, rows[r].up});
      double& worst = free[r] ? reports[i].jump_error : reports[i].frame_error;
      worst = std::max(worst, angle);
      // A row between two spans counts once in the mean squares.
      if (k == ends[i + 1] && (i + 1 < reports.size() || k == rows.size())) continue;
      reports[i].distances.add(near.distance);
      if (!free[r]) reports[i].angles.add(angle);
    }
  }
  return reports;
}

}  // namespace coaster::sim
