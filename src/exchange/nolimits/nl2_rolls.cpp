// The roll spline; the knots that a file's rolls need, and the rolls that a track needs.
#include "exchange/nolimits/nl2_spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "curve/natural_spline.h"
#include "sim/shape/roll.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

struct Sample {
  double s = 0, angle = 0;  // m; rad against the rotation-minimising frame
  curve::Frame frame;
  bool chosen = false;
};

// Returns the track's frames at most kRollStep apart; those at the knots are chosen.
std::vector<Sample> samples_of(const sim::DerivedTrack& derived) {
  std::vector<Sample> samples;
  curve::Frame carried;
  dvec3 last(0);
  const auto add = [&](const sim::SegmentShape& shape, double start, double within, bool chosen) {
    const curve::Frame frame = sim::frame_at(shape, within);
    const dvec3 here = curve::point(shape.key.cubic, shape.arc.parameter(within));
    carried = samples.empty() ? frame : curve::transport(carried, last, here, frame.forward);
    last = here;
    double angle = curve::signed_angle(carried.up, frame.up, frame.forward);
    if (!samples.empty()) angle += 2 * base::kPi * std::round((samples.back().angle - angle) / (2 * base::kPi));
    samples.push_back({start + within, angle, frame, chosen});
  };
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const sim::SegmentShape& shape = derived.shape(derived.order[i]);
    const double length = shape.arc.length();
    const int steps = std::max(1, static_cast<int>(std::floor(length / kRollStep)));
    for (int k = 0; k < steps; ++k) add(shape, derived.starts[i], length * k / steps, k == 0);
    if (i + 1 == derived.order.size()) add(shape, derived.starts[i], length, true);
  }
  return samples;
}

// Returns true if every interpretation of the rolls between two samples matches the samples between them.
bool reads_well(const std::vector<Sample>& samples, std::size_t from, std::size_t to, const RollSpline& spline) {
  const double bound = base::radians(kRollError);
  const Sample &a = samples[from], &b = samples[to];
  const double length = b.s - a.s, turn = b.angle - a.angle;
  if (std::abs(turn) > base::kPi / 2) return false;
  for (std::size_t i = from + 1; i < to; ++i) {
    const Sample& here = samples[i];
    const double u = (here.s - a.s) / length, v = 1 - u, wanted = here.angle - a.angle;
    const dvec3 mixed = curve::perpendicular(here.frame.forward, v * a.frame.up + u * b.frame.up);
    if (std::abs(u * turn - wanted) > bound ||
        std::abs(spline.at(here.s).angle - here.angle) > base::radians(kSplineError) ||
        curve::angle_between(mixed, here.frame.up) > bound)
      return false;
  }
  return true;
}

constexpr int kFrameSteps = 32;  // between stops, as in the derived frames of a segment
constexpr double kTurn = 2 * base::kPi;
constexpr double kLeastStep = 0.01;  // m between points of the spline

// A position that may become a knot.
struct KnotCandidate {
  KnotPosition stop;  // its `up` is that of its roll, if there is one
  bool knot = false, strict = false;
  double off = 0;  // m from the position to its roll
  curve::Frame carried;
  bool rolled = false;  // has a roll
  double rate = 0;      // rad/m, of the spline
};

void give_roll(KnotCandidate& to, const ElementRoll& roll, double off) {
  if (!to.stop.up || std::abs(off) < std::abs(to.off)) to.stop.up = roll.up, to.strict = roll.strict, to.off = off;
}

// Returns the start of every piece, the rolls between, and the end; rolls near a knot go to it.
std::vector<KnotCandidate> candidates_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls,
                                         const std::vector<curve::ArcLengthMap>& arcs,
                                         const std::vector<double>& starts) {
  std::stable_sort(rolls.begin(), rolls.end(),
                   [](const ElementRoll& a, const ElementRoll& b) { return a.coord < b.coord; });
  std::vector<KnotCandidate> all;
  std::size_t next = 0;
  double last_roll = -kRollApart;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // The piece's last roll may belong to its end, which has no candidate yet.
    KnotCandidate start{{i, 0, starts[i], {}, 0}, true, false, 0, {}};
    if (next > 0) {
      const double off = rolls[next - 1].coord * starts.back() - starts[i];
      if (off > -kRollSnap) give_roll(start, rolls[next - 1], off);
    }
    all.push_back(start);
    for (; next < rolls.size() && (rolls[next].coord * starts.back() < starts[i + 1]); ++next) {
      const double s = rolls[next].coord * starts.back(), within = std::max(0.0, s - starts[i]);
      if (within < kRollSnap) give_roll(all.back(), rolls[next], within);
      else if (starts[i + 1] - s >= kRollSnap) {
        if (s - last_roll < kRollApart) continue;
        all.push_back({{i, arcs[i].parameter(within), s, rolls[next].up, 0}, false, rolls[next].strict, 0, {}});
      }
      last_roll = s;
    }
  }
  KnotCandidate end{{pieces.size() - 1, 1, starts.back(), {}, 0}, true, false, 0, {}};
  for (std::size_t k = rolls.size(); k-- > 0;)
    if (const double off = (rolls[k].coord - 1) * starts.back(); off > -kRollSnap) give_roll(end, rolls[k], off);
    else break;
  if (closed) {
    KnotCandidate& first = all.front();
    if (end.stop.up && (!first.stop.up || -end.off < first.off)) first.stop.up = end.stop.up;
    end.stop.up = first.stop.up, first.off = end.off = 0;
  }
  all.push_back(end);
  return all;
}

// Adds candidates without a roll between the others, where the track is compared with the spline.
std::vector<KnotCandidate> sampled(const std::vector<KnotCandidate>& all, const std::vector<curve::ArcLengthMap>& arcs,
                                   const std::vector<double>& starts) {
  constexpr int kParts = 4;
  std::vector<KnotCandidate> more;
  for (std::size_t i = 0; i < all.size(); ++i) {
    more.push_back(all[i]);
    const KnotPosition& from = all[i].stop;
    for (int k = 1; k < kParts && i + 1 < all.size(); ++k) {
      const double s = from.s + (all[i + 1].stop.s - from.s) * k / kParts;
      if (all[i + 1].stop.s - from.s > kRollApart)
        more.push_back(
            {{from.piece, arcs[from.piece].parameter(s - starts[from.piece]), s, {}, 0}, false, false, 0, {}});
    }
  }
  return more;
}

// Carries a rotation-minimising frame from the start of the track through all candidates.
void carry_frames(std::span<const Bezier> pieces, std::vector<KnotCandidate>& all) {
  const dvec3 first = start_direction(pieces[0]);
  all.front().carried = {first, curve::perpendicular(first, {0, 1, 0})};
  for (std::size_t i = 1; i < all.size(); ++i) {
    const KnotPosition &from = all[i - 1].stop, &to = all[i].stop;
    const Bezier& piece = pieces[from.piece];
    const double end = to.piece == from.piece ? to.t : 1;
    curve::Frame frame = all[i - 1].carried;
    dvec3 last = point(piece, from.t);
    for (int k = 1; k <= kFrameSteps; ++k) {
      const double t = from.t + (end - from.t) * k / kFrameSteps;
      const dvec3 here = point(piece, t), d = slope(piece, t);
      frame = curve::transport(frame, last, here, glm::dot(d, d) > 0 ? glm::normalize(d) : frame.forward);
      last = here;
    }
    all[i].carried = frame;
  }
}

// Returns the spline through the rolls, each angle the nearest to the one before by whole turns.
RollSpline spline_of(const std::vector<KnotCandidate>& all, bool closed) {
  std::vector<RollPoint> points;
  for (const KnotCandidate& c : all) {
    if (!c.stop.up || (!points.empty() && c.stop.s + c.off - points.back().s < kLeastStep)) continue;
    double value =
        curve::signed_angle(c.carried.up, curve::perpendicular(c.carried.forward, *c.stop.up), c.carried.forward);
    if (!points.empty()) value += kTurn * std::round((points.back().angle - value) / kTurn);
    points.push_back({c.stop.s + c.off, value, c.strict});
  }
  if (!closed || all.front().stop.up) return RollSpline(std::move(points));
  // The roll before the first and after the last are a lap away; after a lap the carried frame has rotated.
  const curve::Frame &start = all.front().carried, &end = all.back().carried;
  double lap = curve::signed_angle(end.up, start.up, start.forward);
  const double first = points.front().angle, last = points.back().angle;
  lap += kTurn * std::round((last - first - lap) / kTurn);
  // What lies more than 8 points away has no effect.
  const int laps = 1 + 8 / static_cast<int>(points.size());
  std::vector<RollPoint> round;
  for (int k = -laps; k <= laps; ++k)
    for (const RollPoint& p : points) round.push_back({p.s + k * all.back().stop.s, p.angle + k * lap, p.strict});
  return RollSpline(std::move(round));
}

// Returns the roll between neighbouring stops among `at`, with the spins that match the candidates between them by
// least squares, weakly drawn to the spline's rates.
std::vector<sim::Roll> rolls_between(const std::vector<KnotCandidate>& all, const std::vector<std::size_t>& at,
                                     bool closed) {
  constexpr double kPull = 1e-4;
  std::vector<sim::Roll> rolls;
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const KnotPosition &from = all[at[k]].stop, &to = all[at[k + 1]].stop;
    rolls.push_back({to.s - from.s, to.angle - from.angle, 0, 0});
  }
  const std::size_t count = closed ? rolls.size() : at.size();
  const auto next = [count](std::size_t k) { return k + 1 < count ? k + 1 : 0; };
  std::vector<curve::TridiagonalRow> rows(count, {0, 0, 0, dvec3(0)});
  for (std::size_t k = 0; k < rolls.size(); ++k) {
    const double length = rolls[k].length, pull = kPull * length * kPull * length;
    curve::TridiagonalRow &from = rows[k], &to = rows[next(k)];
    from.middle += pull, from.right.x += pull * all[at[k]].rate;
    to.middle += pull, to.right.x += pull * all[at[k + 1]].rate;
    for (std::size_t i = at[k] + 1; i < at[k + 1]; ++i) {
      const double s = all[i].stop.s - all[at[k]].stop.s, missing = all[i].stop.angle - all[at[k]].stop.angle -
                                                                    sim::Roll{length, rolls[k].twist, 0, 0}.angle(s);
      const double a = sim::Roll{length, 0, 1, 0}.angle(s), b = sim::Roll{length, 0, 0, 1}.angle(s);
      from.middle += a * a, to.middle += b * b, from.above += a * b, to.below += a * b;
      from.right.x += a * missing, to.right.x += b * missing;
    }
  }
  const std::vector<dvec3> spins = curve::solve_tridiagonal(std::move(rows), closed);
  for (std::size_t k = 0; k < rolls.size(); ++k) rolls[k].from = spins[k].x, rolls[k].to = spins[next(k)].x;
  return rolls;
}

// The candidate between two stops with the largest error, if there is any.
struct WorstCandidate {
  std::size_t at = 0;
  double off = 0;  // rad; 0: all match
};
WorstCandidate worst_miss(const std::vector<KnotCandidate>& all, std::size_t a, std::size_t b, const sim::Roll& roll) {
  if (b - a > 1 && std::abs(roll.twist) > kTurn * (world::kMaxTurns - 1)) return {(a + b) / 2, kTurn};
  WorstCandidate worst;
  for (std::size_t i = a + 1; i < b; ++i) {
    const double angle = all[a].stop.angle + roll.angle(all[i].stop.s - all[a].stop.s);
    const double off = std::abs(angle - all[i].stop.angle);
    if (off > base::radians(all[i].rolled ? kRollTolerance : kBetweenRolls) && off > worst.off) worst = {i, off};
  }
  return worst;
}

// Returns the roll nearest to a miss among those between two stops; the miss itself if there is none. Stops at rolls
// follow the spline exactly.
std::size_t roll_at(const std::vector<KnotCandidate>& all, std::size_t miss, std::size_t low, std::size_t high) {
  for (std::size_t d = 0; miss >= low + d || miss + d <= high; ++d)
    for (const std::size_t i : {miss >= low + d ? miss - d : miss, std::min(miss + d, high)})
      if (all[i].rolled && !all[i].knot) return i;
  return miss;
}

// Makes knots of rolls until the track matches all candidates. Of neighbouring spans with errors only the worst is
// divided, because spins that fit it better may correct the others.
void choose_knots(std::vector<KnotCandidate>& all, bool closed) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].knot) at.push_back(i);
    const std::vector<sim::Roll> rolls = rolls_between(all, at, closed);
    std::vector<WorstCandidate> misses;
    for (std::size_t k = 0; k < rolls.size(); ++k) {
      misses.push_back(worst_miss(all, at[k], at[k + 1], rolls[k]));
      all[at[k]].stop.spin = rolls[k].from, all[at[k + 1]].stop.spin = rolls[k].to;
    }
    for (std::size_t k = 0; k < misses.size(); ++k) {
      const double before = k > 0 ? misses[k - 1].off : 0, after = k + 1 < misses.size() ? misses[k + 1].off : 0;
      if (misses[k].off > 0 && misses[k].off > before && misses[k].off >= after)
        all[roll_at(all, misses[k].at, at[k > 0 ? k - 1 : 0], at[std::min(k + 2, at.size() - 1)])].knot = changed =
            true;
    }
  }
}

}  // namespace

RollSpline::RollSpline(std::vector<RollPoint> points) : points_(std::move(points)) {
  std::vector<dvec3> angles;  // from one point of rate 0 to the next
  std::vector<double> steps;
  rates_.assign(points_.size(), 0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    angles.emplace_back(points_[i].angle, 0, 0);
    if (i > 0) steps.push_back(points_[i].s - points_[i - 1].s);
    if (steps.empty() || (i + 1 < points_.size() && !points_[i].strict)) continue;
    const std::vector<dvec3> rates = curve::spline_derivatives({angles, steps, dvec3(0), dvec3(0)});
    for (std::size_t k = 0; k < rates.size(); ++k) rates_[i + 1 - rates.size() + k] = rates[k].x;
    angles = {angles.back()}, steps.clear();
  }
}

RollSpline::Value RollSpline::at(double s) const {
  const auto after =
      std::upper_bound(points_.begin(), points_.end(), s, [](double x, const RollPoint& p) { return x < p.s; });
  if (after == points_.begin()) return {after->angle, 0};
  const auto from = after - 1;
  if (after == points_.end()) return {from->angle, 0};
  const auto i = static_cast<std::size_t>(from - points_.begin());
  const sim::Roll roll{after->s - from->s, after->angle - from->angle, rates_[i], rates_[i + 1]};
  return {from->angle + roll.angle(s - from->s), roll.spin(s - from->s)};
}

std::vector<double> roll_places(const sim::DerivedTrack& derived) {
  std::vector<Sample> samples = samples_of(derived);
  std::vector<std::size_t> points;
  for (std::size_t added = 1; added > 0;) {
    points.clear();
    std::vector<RollPoint> rolls;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].chosen) points.push_back(i), rolls.push_back({samples[i].s, samples[i].angle});
    const RollSpline spline(std::move(rolls));
    added = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i + 1] - points[i] > 1 && !reads_well(samples, points[i], points[i + 1], spline)) {
        samples[(points[i] + points[i + 1]) / 2].chosen = true;
        ++added;
      }
  }
  std::vector<double> places;
  for (const std::size_t i : points) places.push_back(samples[i].s);
  return places;
}

std::vector<KnotPosition> stops_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls) {
  std::vector<curve::ArcLengthMap> arcs;
  std::vector<double> starts{0};
  for (const Bezier& piece : pieces) {
    arcs.emplace_back(in_float(piece));
    starts.push_back(starts.back() + arcs.back().length());
  }
  const bool rolled = !rolls.empty();
  std::vector<KnotCandidate> all = candidates_of(pieces, closed, std::move(rolls), arcs, starts);
  if (rolled) {
    all = sampled(all, arcs, starts);
    carry_frames(pieces, all);
    const RollSpline spline = spline_of(all, closed);
    for (KnotCandidate& c : all) {
      c.rolled = c.stop.up.has_value();
      const RollSpline::Value roll = spline.at(c.stop.s);
      c.stop.angle = roll.angle, c.rate = roll.rate;
      c.stop.up = curve::rotate(c.carried.up, c.carried.forward, c.stop.angle);
    }
    choose_knots(all, closed);
  }
  std::vector<KnotPosition> stops;
  for (const KnotCandidate& c : all)
    if (c.knot) stops.push_back(c.stop);
  return stops;
}

}  // namespace coaster::exchange
