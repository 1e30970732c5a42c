#include "sim/plan/circuit_turns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using base::kPi;
using glm::dvec2;

constexpr int kGrid = 144;  // steps of a whole turn
constexpr double kGridStep = 2.0 * kPi / kGrid;
constexpr double kUnit = 1000;  // m, a radius at which no bend is too short

dvec2 along(double heading) {
  const auto [sin, cos] = base::sin_cos(heading);
  return {cos, sin};
}
dvec2 swung(dvec2 v, double heading) {
  const dvec2 e = along(heading);
  return {v.x * e.x - v.y * e.y, v.x * e.y + v.y * e.x};
}

// Returns the bend with soft ramps: the roll follows the curvature, whose second derivative must not jump.
Bend soft(Bend bend) {
  bend.soft = true;
  return bend;
}

// Displacements of bends by their angle, up to two whole turns, for a radius of 1 m and the heading 0.
struct TurnTable {
  std::array<dvec2, 2 * kGrid + 1> moved{};
  std::array<double, 2 * kGrid + 1> length{};
  TurnTable() {
    for (std::size_t i = 1; i < moved.size(); ++i) {
      const Bend bend = soft({0, static_cast<double>(i) * kGridStep, kUnit});
      moved[i] = bend.run_and_rise() / kUnit, length[i] = bend.length() / kUnit;
    }
  }
  dvec2 at(double angle, double radius, double shortest) const {
    const double place = angle / kGridStep;
    const auto i = std::min(static_cast<std::size_t>(place), moved.size() - 2);
    const double share = place - static_cast<double>(i);
    const double whole = length[i] + share * (length[i + 1] - length[i]);
    const double real = radius * whole < shortest && whole > 0 ? shortest / whole : radius;
    return real * (moved[i] + share * (moved[i + 1] - moved[i]));
  }
};

Bend turn_of(const TurnChoice& c, double from, double to) { return soft({from, to, c.radius, 0, c.shortest}); }

// The remaining displacement after a first turn by `turn`, along and across the heading between the turns.
struct Rest {
  double ahead = 0, aside = 0;  // m
  double second = 0;            // rad, the second turn
};

template <class Moved>
Rest rest_after(const PlanPose& from, const PlanPose& to, const TurnChoice& c, double turn, const Moved& moved) {
  const double heading = from.heading + c.first * turn;
  double second = c.second * (to.heading - heading) / (2.0 * kPi);
  second = (second - std::floor(second) + c.more_second) * 2.0 * kPi;
  const auto shift = [&](double angle, int side, double at) {
    const dvec2 m = moved(angle, c);
    return swung({m.x, side * m.y}, at);
  };
  const dvec2 rest = to.place - from.place - c.before * along(from.heading) - c.after * along(to.heading) -
                     shift(turn, c.first, from.heading) - shift(second, c.second, heading);
  const dvec2 e = along(heading);
  return {glm::dot(rest, e), rest.y * e.x - rest.x * e.y, second};
}

Turns turns_of(const PlanPose& from, const TurnChoice& c, double turn, const Rest& rest) {
  const double heading = from.heading + c.first * turn;
  return {c.before, std::max(0.0, rest.ahead), c.after, turn_of(c, from.heading, heading),
          turn_of(c, heading, heading + c.second * rest.second)};
}

// Adds the roots of the rest's `aside` as a function of the first turn's angle.
void add_roots(const PlanPose& from, const PlanPose& to, TurnChoice c, std::vector<TurnChoice>& out) {
  static const TurnTable kTable;
  const auto moved = [](double angle, const TurnChoice& choice) {
    return kTable.at(angle, choice.radius, choice.shortest);
  };
  const int begin = c.more_first * kGrid;
  Rest last = rest_after(from, to, c, begin * kGridStep, moved);
  const auto take = [&](double low, double high, double turn) {
    const Rest rest = rest_after(from, to, c, turn, moved);
    if (rest.ahead < -0.05) return;
    c.low = low, c.high = high, c.rough = turns_of(from, c, turn, rest);
    out.push_back(c);
  };
  if (last.aside == 0) take(begin * kGridStep, begin * kGridStep, begin * kGridStep);
  for (int i = begin + 1; i <= begin + kGrid; ++i) {
    const Rest next = rest_after(from, to, c, i * kGridStep, moved);
    if ((last.aside < 0) != (next.aside < 0) && std::abs(last.second - next.second) < kPi)
      take((i - 1) * kGridStep, i * kGridStep, (i - 1 + last.aside / (last.aside - next.aside)) * kGridStep);
    last = next;
  }
}

}  // namespace

std::vector<double> Turns::breaks() const {
  std::vector<double> at{before};
  const auto add = [&](const Bend& bend, double straight) {
    const double begin = at.back();
    if (bend.length() > 0) at.insert(at.end(), {begin, begin + bend.ramp(), begin + bend.ramp() + bend.arc()});
    at.push_back(begin + bend.length());
    at.push_back(at.back() + straight);
  };
  add(first, between), add(second, after);
  return at;
}

Turns::At Turns::at(double u) const {
  double begin = 0, end = before;
  if (u <= end) return {first.from, 0};
  begin = end, end = begin + first.length();
  if (u <= end) return {first.angle(u - begin), first.bend(u - begin)};
  begin = end, end = begin + between;
  if (u <= end) return {first.to, 0};
  begin = end, end = begin + second.length();
  if (u <= end) return {second.angle(u - begin), second.bend(u - begin)};
  return {second.to, 0};
}

std::vector<TurnChoice> turn_choices(const PlanPose& from, const PlanPose& to, std::span<const double> radii,
                                     std::span<const double> straights, double shortest) {
  std::vector<TurnChoice> choices;
  const auto add_sides = [&](TurnChoice c) {
    for (c.first = -1; c.first <= 1; c.first += 2)
      for (c.second = -1; c.second <= 1; c.second += 2) add_roots(from, to, c, choices);
  };
  TurnChoice c;
  c.shortest = shortest;
  for (const double radius : radii) {
    c.radius = radius;
    for (const double before : straights)
      for (const double after : straights) c.before = before, c.after = after, add_sides(c);
    c.before = c.after = 0;
    c.more_first = 1, add_sides(c), c.more_first = 0;
    c.more_second = 1, add_sides(c), c.more_second = 0;
  }
  return choices;
}

// By regula falsi (Illinois): a few steps from a bracket of 2.5 degrees.
std::optional<Turns> exact_turns(const PlanPose& from, const PlanPose& to, const TurnChoice& choice) {
  constexpr int kSteps = 60;
  constexpr double kDone = 1e-11;  // m
  const auto moved = [](double angle, const TurnChoice& c) { return turn_of(c, 0, angle).run_and_rise(); };
  const auto rest = [&](double turn) { return rest_after(from, to, choice, turn, moved); };
  // The interpolated root may lie just outside the exact bracket.
  double low = std::max(0.0, choice.low - 0.01), high = choice.high + 0.01;
  if (choice.low == choice.high) low = high = choice.low;
  const Rest at_low = rest(low), at_high = rest(high);
  Rest here = at_low;
  double turn = low, aside_low = at_low.aside, aside_high = at_high.aside;
  if (low < high && ((aside_low < 0) == (aside_high < 0) || std::abs(at_low.second - at_high.second) > kPi))
    return std::nullopt;
  int side = 0;  // of the last two steps
  for (int i = 0; i < kSteps && low < high; ++i) {
    turn = (low * aside_high - high * aside_low) / (aside_high - aside_low);
    here = rest(turn);
    if (std::abs(here.aside) < kDone) break;
    const bool above = (here.aside < 0) == (aside_high < 0);
    (above ? high : low) = turn, (above ? aside_high : aside_low) = here.aside;
    if (side == (above ? 1 : -1)) (above ? aside_low : aside_high) *= 0.5;
    side = above ? 1 : -1;
  }
  if (!(std::abs(here.aside) < 1e-8) || here.ahead < 0) return std::nullopt;
  return turns_of(from, choice, turn, here);
}

}  // namespace coaster::sim
