#include "sim/plan/element_arcs.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace coaster::sim {
namespace {
using base::kPi;
using glm::dvec2;
}  // namespace

double root(double low, double high, const std::function<double(double)>& f) {
  constexpr int kBisections = 60;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double tangent_of(double angle) {
  const auto [sin, cos] = base::sin_cos(angle);
  return sin / cos;
}

Foot::Foot(double steepest, double least_radius, double p)
    : angle(steepest), radius(Bend(0, steepest, least_radius).radius) {
  const double r = radius;
  const double cos = base::sin_cos(steepest).cos;
  crest_bend = cos * cos * cos / p;
  first_angle = std::min(angle / 3, kPi / 6);
  first = 2 * r * first_angle;
  // As fast as the first clothoid, unless it would turn back by more than a quarter of the angle after the inflection.
  second = std::min(first * (1 + r * crest_bend), 0.5 * angle * (1 / r + crest_bend) / (crest_bend * crest_bend));
  second_angle = 0.5 * second * (1 / r - crest_bend);
  arc = r * (angle - first_angle - second_angle);
}

double Foot::bend(double u) const {
  if (u < first) return u / (first * radius);
  if (u < first + arc) return 1 / radius;
  return 1 / radius - (1 / radius + crest_bend) * (u - first - arc) / second;
}

double Foot::angle_at(double u) const {
  if (u < first) return u * u / (2 * first * radius);
  if (u < first + arc) return first_angle + (u - first) / radius;
  const double v = u - first - arc;
  return angle - second_angle + v / radius - (1 / radius + crest_bend) * v * v / (2 * second);
}

double Foot::rise() const {
  constexpr int kSteps = 16;
  double sum = 0;
  for (const auto& [begin, part] : {dvec2(0, first), dvec2(first, arc), dvec2(first + arc, second)})
    sum += integral(part, kSteps, [&, from = begin](double u) {
             return dvec2(0, base::sin_cos(angle_at(from + u)).sin);
           }).y;
  return sum;
}

void add_foot_up(ElementPath& path, const Foot& foot) {
  path.add({foot.first, foot.arc, foot.second}, [&](double u) { return upright_rate(foot.angle_at(u), foot.bend(u)); });
}

void add_foot_down(ElementPath& path, const Foot& foot, double way) {
  const double whole = foot.length();
  const auto down = [&](double from) {
    return [&foot, from, way](double u) {
      ElementRate rate = upright_rate(-foot.angle_at(from - u), foot.bend(from - u));
      for (glm::dvec3* v : {&rate.d1, &rate.d2, &rate.up}) v->x *= way;
      return rate;
    };
  };
  path.add(foot.second, down(whole));
  path.add(foot.arc, down(whole - foot.second));
  path.add(foot.first, down(whole - (foot.second + foot.arc)));
}

void add_parabola(ElementPath& path, double p, double edge, double way, double from_roll, double to_roll) {
  path.add(2 * edge, [=](double u) {
    const double slope = (edge - u) / p;
    return ElementRate{{way, slope, 0},
                       {0, -1 / p, 0},
                       {-way * slope, 1, 0},
                       from_roll + (to_roll - from_roll) * smooth_step(u / (2 * edge))};
  });
}

Winding::Winding(double height, double top) : ramp_angle_(kPi - 0.5 * top) {
  const dvec2 half = direction(0, ramp()) + direction(ramp(), 0.5 * top);  // from the foot to the apex, of radius 1
  radius_ = height / half.y;
  width_ = 2 * radius_ * half.x;
  arc_ = radius_ * top;
}

double Winding::turned(double u) const {
  if (u <= ramp()) return u * u / (2 * radius_ * ramp());
  if (u < ramp() + arc_) return ramp_angle_ + (u - ramp()) / radius_;
  const double left = length() - u;
  return 2 * kPi - left * left / (2 * radius_ * ramp());
}

double Winding::bend(double u) const { return std::clamp(std::min(u, length() - u) / ramp(), 0.0, 1.0) / radius_; }

dvec2 Winding::direction(double begin, double length) const {
  constexpr int kSteps = 48;
  return integral(length, kSteps, [&](double along) {
    const double u = begin + along;
    const auto [sin, cos] = base::sin_cos(u <= ramp() ? u * u / (2 * ramp()) : ramp_angle_ + (u - ramp()));
    return dvec2(cos, sin);
  });
}

}  // namespace coaster::sim
