#include "sim/plan/closing_heights.h"

#include <algorithm>
#include <cmath>

#include "base/numerics.h"

namespace coaster::sim {
namespace {

constexpr double kRollRate = 1.0;     // rad/s, of the fading roll
constexpr double kRollPush = 3.0;     // rad/s^2, its largest change, which pushes riders sideways
constexpr double kShortestFade = 12;  // m
constexpr double kLast = 1.0 / 6.0;   // of the length, for the last cubic and the longest first one

}  // namespace

// The slope is a sum of hat functions: one that falls from the start's slope over the first part, and one around each
// joint. The two conditions are the spin and the angle at the end: a hat of area A with its centroid at c adds A and A
// (length - c).
RollFade::RollFade(double length, double angle, double spin, double slope) {
  const double a = std::min(kFadeTaper, kLast * length), b = length - kLast * length;
  const double area = 0.5 * a * slope, left = -spin - area, turned = -angle - spin * length - area * (length - a / 3.0);
  const double first_centroid = (a + b) / 3.0, second_centroid = (a + b + length) / 3.0;
  const double first = (turned - left * (length - second_centroid)) / (second_centroid - first_centroid),
               second = left - first;
  nodes_ = {{{0, angle, spin, slope}, {a, 0, 0, 2.0 * first / b}, {b, 0, 0, 2.0 * second / (length - a)}, {}}};
  nodes_[3].s = length;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const Node& from = nodes_[i - 1];
    Node& to = nodes_[i];
    const double u = to.s - from.s;
    to.spin = from.spin + 0.5 * u * (from.slope + to.slope);
    to.angle = from.angle + u * (from.spin + u * (from.slope / 3.0 + to.slope / 6.0));
  }
  nodes_[3].angle = nodes_[3].spin = 0;
}

RollFade::Part RollFade::part_at(double s) const {
  std::size_t i = 0;
  while (i < 2 && s >= nodes_[i + 1].s) ++i;
  const Node &from = nodes_[i], &to = nodes_[i + 1];
  return {from, s - from.s, (to.slope - from.slope) / (to.s - from.s)};
}

double RollFade::angle(double s) const {
  if (s >= length()) return 0;
  const Part p = part_at(s);
  return p.from.angle + p.u * (p.from.spin + p.u * (0.5 * p.from.slope + p.u * p.change / 6.0));
}

double RollFade::spin(double s) const {
  if (s >= length()) return 0;
  const Part p = part_at(s);
  return p.from.spin + p.u * (p.from.slope + 0.5 * p.u * p.change);
}

double RollFade::slope(double s) const {
  if (s >= length()) return 0;
  const Part p = part_at(s);
  return p.from.slope + p.u * p.change;
}

// An angle r over the length T needs a slope of 7.2 r / T^2 and a spin of about 1.7 r / T. The remainder of a slope
// after the first cubic needs 1.83 times that slope, multiplied by that cubic's length over 5/6 T.
double fade_length(double angle, double slope, double square) {
  const double turned = std::abs(angle), speed = std::sqrt(std::max(square, 0.0));
  const double seconds = std::max(1.7 * turned / kRollRate, std::sqrt(7.2 * turned / kRollPush));
  return std::max({kShortestFade, seconds * speed, std::abs(slope) / fade_slope(1, square)});
}

double fade_slope(double length, double square) {
  return length * kRollPush / (2.2 * kFadeTaper * std::max(square, 1.0));
}

namespace {

constexpr double kSteepestChange = 2.1875;  // of 35v^4 - 84v^5 + 70v^6 - 20v^7
constexpr double kShortestBend = 6;         // m

double bend_length(double from, double to, const HeightLimits& limits) {
  if (from == to) return 0;
  return std::max(kShortestBend, kSteepestChange * std::abs(to - from) * (to < from ? limits.crest : limits.valley));
}

// From one slope through a steady one to level.
struct ToLevel {
  double bend = 0, steady = 0, out = 0, slope = 0;  // m, m, m, and the steady slope
  double length() const { return bend + steady + out; }
};

// Returns the shortest way from a slope to level that rises by `rise`: only bends if the slope between them stays
// within the limit, else with a steady part. The rise of the bends increases with the slope between them, except for
// the shortest bends; bisection finds that slope.
ToLevel to_level(double slope, double rise, const HeightLimits& limits) {
  constexpr int kSteps = 60;
  const auto bends = [&](double middle) {
    ToLevel way;
    way.slope = middle;
    way.bend = bend_length(slope, middle, limits), way.out = bend_length(middle, 0, limits);
    return way;
  };
  const auto risen = [&](const ToLevel& way) {
    return 0.5 * (slope + way.slope) * way.bend + 0.5 * way.slope * way.out;
  };
  const double steepest = std::max(limits.steepest, std::abs(slope));
  double low = -steepest, high = steepest;
  for (const double end : {low, high}) {
    ToLevel way = bends(end);
    const double steady = (rise - risen(way)) / end;
    if (steady < 0) continue;
    way.steady = steady;
    return way;
  }
  ToLevel way =
      bends(base::bisect({low, high}, kSteps, [&](double middle) { return risen(bends(middle)) < rise; }).middle());
  // The remainder that bisection leaves where the rise jumps becomes a steady part.
  const double left = rise - risen(way);
  if (std::abs(left) > 1e-9 && way.slope != 0) way.steady = left / way.slope;
  return way;
}

}  // namespace

void HeightProfile::add(double length, double from, double to) {
  if (length > 0 && count < pieces.size()) pieces[count++] = {length, from, to};
}

double HeightProfile::length() const {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += pieces[i].length;
  return sum;
}

std::vector<double> HeightProfile::breaks() const {
  std::vector<double> at;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) at.push_back(sum += pieces[i].length);
  return at;
}

HeightProfile::At HeightProfile::at(double u) const {
  At result{start, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [length, from, to] = pieces[i];
    const bool here = u < length || i + 1 == count;
    const double v = here ? std::clamp(u / length, 0.0, 1.0) : 1.0, w = v * v * v, change = to - from;
    result.height += length * (from * v + change * v * v * w * (7.0 - 14.0 * v + 10.0 * v * v - 2.5 * w));
    if (here) {
      result.slope = from + change * w * v * (35.0 - 84.0 * v + 70.0 * v * v - 20.0 * w);
      result.change = change * 140.0 * w * (1.0 - v) * (1.0 - v) * (1.0 - v) / length;
      break;
    }
    u -= length;
  }
  return result;
}

std::optional<HeightProfile> steady_heights(const HeightEnds& e, const HeightLimits& limits) {
  constexpr int kRounds = 60;  // each halves the error, approximately
  double slope = e.length > 0 ? (e.to - e.from) / e.length : 0, first = 0, last = 0;
  for (int i = 0; i < kRounds; ++i) {
    first = bend_length(e.slope_from, slope, limits), last = bend_length(slope, e.slope_to, limits);
    const double room = e.length - 0.5 * (first + last);
    if (first + last > e.length || !(room > 0)) return std::nullopt;
    slope = (e.to - e.from - 0.5 * first * e.slope_from - 0.5 * last * e.slope_to) / room;
  }
  if (std::abs(slope) > std::max({limits.steepest, std::abs(e.slope_from), std::abs(e.slope_to)})) return std::nullopt;
  HeightProfile heights;
  heights.start = e.from;
  heights.add(first, e.slope_from, slope);
  heights.add(e.length - first - last, slope, slope);
  heights.add(last, slope, e.slope_to);
  return heights;
}

// The part down to the end is that up from the end, reversed.
std::optional<HeightProfile> heights_by_way_of(double level, const HeightEnds& e, const HeightLimits& limits) {
  const ToLevel in = to_level(e.slope_from, level - e.from, limits), out = to_level(-e.slope_to, level - e.to, limits);
  const double flat = e.length - in.length() - out.length();
  if (flat < 0 || in.steady < 0 || out.steady < 0) return std::nullopt;
  HeightProfile heights;
  heights.start = e.from;
  heights.add(in.bend, e.slope_from, in.slope);
  heights.add(in.steady, in.slope, in.slope);
  heights.add(in.out, in.slope, 0);
  heights.add(flat, 0, 0);
  heights.add(out.out, 0, -out.slope);
  heights.add(out.steady, -out.slope, -out.slope);
  heights.add(out.bend, -out.slope, e.slope_to);
  return heights;
}

}  // namespace coaster::sim
