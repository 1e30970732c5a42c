#include "sim/plan/circuit_fade.h"

#include <algorithm>
#include <cmath>

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

}  // namespace coaster::sim
