// Finds the knots that a file's rolls need.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.h"
#include "exchange/nolimits/nl2_rolls.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr int kFrameSteps = 32;  // between stops, as derived frames have in a segment
constexpr double kTurn = 2 * base::kPi;

// A place that may become a knot.
struct Candidate {
  Stop stop;
  bool knot = false;
  double off = 0;  // m between the place and its roll
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

// Makes knots of the rolls between two knots until the linear roll from knot to knot meets all of them.
void choose_knots(std::vector<Candidate>& all, std::size_t first, std::size_t last) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Stop &from = all[a].stop, &to = all[b].stop;
    std::size_t worst = (a + b) / 2;
    double most = std::abs(to.angle - from.angle) > kTurn * (world::kMaxTurns - 1) ? 1e-9 : 0;
    const double bound = most > 0 ? 0 : base::radians(kRollTolerance);
    for (std::size_t i = a + 1; i < b; ++i) {
      const double share = (all[i].stop.s - from.s) / (to.s - from.s);
      const double off = std::abs(from.angle + share * (to.angle - from.angle) - all[i].stop.angle);
      if (off > most) most = off, worst = i;
    }
    if (b - a < 2 || most <= bound) continue;
    all[worst].knot = true;
    open.push_back({a, worst});
    open.push_back({worst, b});
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
    std::size_t last = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
      if (all[i].knot) choose_knots(all, std::exchange(last, i), i);
  }
  std::vector<Stop> stops;
  for (const Candidate& c : all)
    if (c.knot) stops.push_back(c.stop);
  return stops;
}

}  // namespace coaster::exchange
