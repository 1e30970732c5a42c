// Finds the knots that a file's rolls need.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "exchange/nolimits/nl2_rolls.h"
#include "sim/shape/roll.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr int kFrameSteps = 32;  // between stops, as in the derived frames of a segment
constexpr double kTurn = 2 * base::kPi;

// A position that may become a knot.
struct Candidate {
  Stop stop;
  bool knot = false;
  double off = 0;  // m between the position and its roll
  curve::Frame carried;
};

void give_roll(Candidate& to, const ElementRoll& roll, double off) {
  if (!to.stop.up || off < to.off) to.stop.up = roll.up, to.off = off;
}

// Returns the start of every piece, the rolls between, and the end; rolls near a knot go to it.
std::vector<Candidate> candidates_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls) {
  std::stable_sort(rolls.begin(), rolls.end(),
                   [](const ElementRoll& a, const ElementRoll& b) { return a.coord < b.coord; });
  std::vector<curve::ArcLengthMap> arcs;
  std::vector<double> starts{0};
  for (const Bezier& piece : pieces) {
    arcs.emplace_back(in_float(piece));
    starts.push_back(starts.back() + arcs.back().length());
  }
  std::vector<Candidate> all;
  std::size_t next = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // The piece's last roll may belong to its end, which has no candidate yet.
    Candidate start{{i, 0, starts[i], {}, 0}, true, 0, {}};
    if (next > 0) {
      const double off = starts[i] - rolls[next - 1].coord * starts.back();
      if (off < kRollSnap) give_roll(start, rolls[next - 1], off);
    }
    all.push_back(start);
    for (; next < rolls.size() && (rolls[next].coord * starts.back() < starts[i + 1]); ++next) {
      const double s = rolls[next].coord * starts.back(), within = std::max(0.0, s - starts[i]);
      if (within < kRollSnap) give_roll(all.back(), rolls[next], within);
      else if (starts[i + 1] - s >= kRollSnap && s - all.back().stop.s >= kRollSnap)
        all.push_back({{i, arcs[i].parameter(within), s, rolls[next].up, 0}, false, 0, {}});
    }
  }
  Candidate end{{pieces.size() - 1, 1, starts.back(), {}, 0}, true, 0, {}};
  for (std::size_t k = rolls.size(); k-- > 0;)
    if (const double off = (1 - rolls[k].coord) * starts.back(); off < kRollSnap) give_roll(end, rolls[k], off);
    else break;
  if (closed) {
    Candidate& first = all.front();
    if (end.stop.up && (!first.stop.up || end.off < first.off)) first.stop.up = end.stop.up;
    end.stop.up = first.stop.up;
  }
  all.push_back(end);
  return all;
}

// Carries a rotation-minimising frame from the start of the track through all candidates.
void carry_frames(std::span<const Bezier> pieces, std::vector<Candidate>& all) {
  const dvec3 first = start_direction(pieces[0]);
  all.front().carried = {first, curve::perpendicular(first, {0, 1, 0})};
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Stop &from = all[i - 1].stop, &to = all[i].stop;
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

struct Angle {
  double s, value;
};

// Returns the angles of the rolls, each the nearest to the one before by whole turns.
std::vector<Angle> angles_of(const std::vector<Candidate>& all, bool closed) {
  std::vector<Angle> angles;
  for (const Candidate& c : all) {
    if (!c.stop.up) continue;
    double value =
        curve::signed_angle(c.carried.up, curve::perpendicular(c.carried.forward, *c.stop.up), c.carried.forward);
    if (!angles.empty()) value += kTurn * std::round((angles.back().value - value) / kTurn);
    angles.push_back({c.stop.s, value});
  }
  if (!closed || all.front().stop.up) return angles;
  // The roll before the first and after the last are a lap away; after a lap the carried frame has rotated.
  const double length = all.back().stop.s;
  const curve::Frame &start = all.front().carried, &end = all.back().carried;
  const double lap = curve::signed_angle(end.up, start.up, start.forward);
  const Angle first = angles.front(), last = angles.back();
  double again = first.value + lap;
  again += kTurn * std::round((last.value - again) / kTurn);
  angles.push_back({first.s + length, again});
  angles.insert(angles.begin(), {last.s - length, last.value + first.value - again});
  return angles;
}

double angle_at(const std::vector<Angle>& angles, double s) {
  const auto after =
      std::upper_bound(angles.begin(), angles.end(), s, [](double x, const Angle& a) { return x < a.s; });
  if (after == angles.begin()) return angles.front().value;
  const Angle& before = *(after - 1);
  if (after == angles.end()) return before.value;
  return before.value + (after->value - before.value) * (s - before.s) / (after->s - before.s);
}

// A symmetric system of equations for the spins of knots, each coupled only to its neighbours.
struct SpinSystem {
  std::vector<double> diagonal, beside, right;  // beside: coupling to the next one, cyclically

  std::vector<double> times(const std::vector<double>& x) const {
    const std::size_t n = x.size();
    std::vector<double> y(n);
    for (std::size_t i = 0; i < n; ++i) y[i] += diagonal[i] * x[i];
    for (std::size_t i = 0; i < n; ++i)
      if (const std::size_t next = i + 1 < n ? i + 1 : 0; next != i)
        y[i] += beside[i] * x[next], y[next] += beside[i] * x[i];
    return y;
  }
  // Improves x by conjugate gradients (Hestenes and Stiefel 1952), scaled by the diagonal.
  void solve(std::vector<double>& x) const {
    constexpr int kMostSteps = 200;
    constexpr double kDone = 1e-24;  // of the first residual's square
    const std::size_t n = x.size();
    const std::vector<double> at_start = times(x);
    std::vector<double> rest(n), way(n);
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      rest[i] = right[i] - at_start[i], way[i] = rest[i] / diagonal[i];
      size += rest[i] * way[i];
    }
    const double first = size;
    for (int step = 0; step < kMostSteps && size > kDone * first; ++step) {
      const std::vector<double> moved = times(way);
      double along = 0, next = 0;
      for (std::size_t i = 0; i < n; ++i) along += way[i] * moved[i];
      for (std::size_t i = 0; i < n; ++i) {
        x[i] += size / along * way[i], rest[i] -= size / along * moved[i];
        next += rest[i] * rest[i] / diagonal[i];
      }
      for (std::size_t i = 0; i < n; ++i) way[i] = rest[i] / diagonal[i] + next / size * way[i];
      size = next;
    }
  }
};

// Returns the roll between neighbouring stops among `at`, with the spins that match the rolls between them by least
// squares, weakly drawn to the automatic ones.
std::vector<sim::Roll> rolls_between(const std::vector<Candidate>& all, const std::vector<std::size_t>& at,
                                     bool closed) {
  constexpr double kPull = 1e-4;
  std::vector<sim::Roll> rolls;
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const Stop &from = all[at[k]].stop, &to = all[at[k + 1]].stop;
    rolls.push_back({to.s - from.s, to.angle - from.angle, 0, 0});
  }
  const std::size_t count = closed ? rolls.size() : at.size();
  const auto next = [count](std::size_t k) { return k + 1 < count ? k + 1 : 0; };
  std::vector<double> spins(count);
  for (std::size_t k = closed ? 0 : 1; k < rolls.size(); ++k) {
    const sim::Roll& before = rolls[k > 0 ? k - 1 : rolls.size() - 1];
    spins[k] = sim::automatic_spin(before.twist, before.length, rolls[k].twist, rolls[k].length);
  }
  SpinSystem system{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  for (std::size_t k = 0; k < rolls.size(); ++k) {
    const double length = rolls[k].length, pull = kPull * length * kPull * length;
    for (const std::size_t end : {k, next(k)}) system.diagonal[end] += pull, system.right[end] += pull * spins[end];
    for (std::size_t i = at[k] + 1; i < at[k + 1]; ++i) {
      const double s = all[i].stop.s - all[at[k]].stop.s, missing = all[i].stop.angle - all[at[k]].stop.angle -
                                                                    sim::Roll{length, rolls[k].twist, 0, 0}.angle(s);
      const double a = sim::Roll{length, 0, 1, 0}.angle(s), b = sim::Roll{length, 0, 0, 1}.angle(s);
      system.diagonal[k] += a * a, system.diagonal[next(k)] += b * b, system.beside[k] += a * b;
      system.right[k] += a * missing, system.right[next(k)] += b * missing;
    }
  }
  system.solve(spins);
  for (std::size_t k = 0; k < rolls.size(); ++k) rolls[k].from = spins[k], rolls[k].to = spins[next(k)];
  return rolls;
}

// The roll between two stops with the largest error, if there is any.
struct Miss {
  std::size_t at = 0;
  double off = 0;  // rad; 0: all match
};
Miss worst_miss(const std::vector<Candidate>& all, std::size_t a, std::size_t b, const sim::Roll& roll) {
  if (b - a > 1 && std::abs(roll.twist) > kTurn * (world::kMaxTurns - 1)) return {(a + b) / 2, kTurn};
  Miss worst;
  for (std::size_t i = a + 1; i < b; ++i) {
    const double angle = all[a].stop.angle + roll.angle(all[i].stop.s - all[a].stop.s);
    const double off = std::abs(angle - all[i].stop.angle);
    if (off > base::radians(kRollTolerance) && off > worst.off) worst = {i, off};
  }
  return worst;
}

// Makes knots of rolls until the track matches all of them. Of neighbouring spans with errors only the worst is
// divided, because spins that fit it better may correct the others.
void choose_knots(std::vector<Candidate>& all, bool closed) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].knot) at.push_back(i);
    const std::vector<sim::Roll> rolls = rolls_between(all, at, closed);
    std::vector<Miss> misses;
    for (std::size_t k = 0; k < rolls.size(); ++k) {
      misses.push_back(worst_miss(all, at[k], at[k + 1], rolls[k]));
      all[at[k]].stop.spin = rolls[k].from, all[at[k + 1]].stop.spin = rolls[k].to;
    }
    for (std::size_t k = 0; k < misses.size(); ++k) {
      const double before = k > 0 ? misses[k - 1].off : 0, after = k + 1 < misses.size() ? misses[k + 1].off : 0;
      if (misses[k].off > 0 && misses[k].off > before && misses[k].off >= after)
        all[misses[k].at].knot = changed = true;
    }
  }
}

}  // namespace

std::vector<Stop> stops_of(std::span<const Bezier> pieces, bool closed, std::vector<ElementRoll> rolls) {
  const bool rolled = !rolls.empty();
  std::vector<Candidate> all = candidates_of(pieces, closed, std::move(rolls));
  if (rolled) {
    carry_frames(pieces, all);
    const std::vector<Angle> angles = angles_of(all, closed);
    for (Candidate& c : all) {
      c.stop.angle = angle_at(angles, c.stop.s);
      c.stop.up = curve::rotate(c.carried.up, c.carried.forward, c.stop.angle);
    }
    choose_knots(all, closed);
  }
  std::vector<Stop> stops;
  for (const Candidate& c : all)
    if (c.knot) stops.push_back(c.stop);
  return stops;
}

}  // namespace coaster::exchange
