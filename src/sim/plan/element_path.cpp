#include "sim/plan/element_path.h"

#include <algorithm>
#include <cmath>

#include "base/numerics.h"
#include "base/portable_math.h"
#include "sim/shape/roll.h"

namespace coaster::sim {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kShortPiece = 1e-9, kShortestSpan = 1.5;  // m
constexpr int kFewestSteps = 12;
constexpr double kMostRampAngle = base::kPi / 6;

// Gauss-Legendre on [0, 1].
constexpr double kNodes[4] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629};
constexpr double kWeights[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};

// Returns the derivative of the cubic through (x[i], y[i]), i = 0..3, at x[at].
double derivative_at(const double* x, const double* y, int at) {
  double sum = 0;
  for (int j = 0; j < 4; ++j) {
    if (j == at) continue;
    double weight = 1.0 / (x[j] - x[at]);
    for (int m = 0; m < 4; ++m)
      if (m != j && m != at) weight *= (x[at] - x[m]) / (x[j] - x[m]);
    sum += weight * (y[j] - y[at]);
  }
  return sum;
}

}  // namespace

dvec2 integral(double length, int steps, const std::function<dvec2(double)>& f) {
  dvec2 sum(0);
  const double step = length / steps;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < 4; ++k) sum += kWeights[k] * f((i + kNodes[k]) * step);
  return sum * step;
}

Bend::Bend(double from_angle, double to_angle, double least_radius, double length_of_ramp, double shortest)
    : from(from_angle), to(to_angle), radius(least_radius), ramp_length(length_of_ramp) {
  const double angle = std::abs(to - from);
  if (angle > 0 && length() < shortest) radius *= shortest / length();
}
double Bend::ramp_angle() const {
  if (ramp_length > 0) return std::min(0.5 * ramp_length / radius, 0.5 * std::abs(to - from));
  return std::min(0.25 * std::abs(to - from), kMostRampAngle);
}
double Bend::arc() const { return radius * std::max(0.0, std::abs(to - from) - 2.0 * ramp_angle()); }

double Bend::bend(double u) const {
  const double l = ramp(), whole = length(), most = (to < from ? -1.0 : 1.0) / radius;
  if (!(l > 0)) return 0;
  const double v = std::clamp(std::min(u, whole - u) / l, 0.0, 1.0);
  return most * (soft ? soft_step(v) : smooth_step(v));
}

double Bend::angle(double u) const {
  const double l = ramp(), whole = length(), sign = to < from ? -1.0 : 1.0;
  if (!(l > 0)) return to;
  const auto risen = [&](double v) {  // over the fraction v of a ramp
    return l / radius * (soft ? soft_step_integral(v) : v * v * v * (1.0 - 0.5 * v));
  };
  if (u <= l) return from + sign * risen(u / l);
  if (u < whole - l) return from + sign * (ramp_angle() + (u - l) / radius);
  return to - sign * risen((whole - u) / l);
}

dvec2 Bend::run_and_rise() const {
  constexpr int kSteps = 24;  // per part, at most 0.13 rad in a bend of half a turn
  const auto part = [&](double begin, double length) {
    return integral(length, kSteps, [&](double u) {
      const auto [sin, cos] = base::sin_cos(angle(begin + u));
      return dvec2(cos, sin);
    });
  };
  return part(0, ramp()) + part(ramp(), arc()) + part(ramp() + arc(), ramp());
}

ElementPath::ElementPath(dvec3 position, dvec3 tangent, dvec3 curvature, dvec3 up, double spin)
    : start_up_(curve::perpendicular(tangent, up)), start_spin_(spin) {
  curve_.points.push_back({0, position, tangent, curvature, start_up_, spin});
  curve_.breaks.push_back(0);
}

ElementPoint ElementPath::point(const ElementDerivatives& rate) const {
  ElementPoint p;
  const dvec3 d1 = world(rate.d1), d2 = world(rate.d2);
  const double square = glm::dot(d1, d1);
  p.tangent = d1 / std::sqrt(square);
  p.curvature = (d2 - p.tangent * glm::dot(d2, p.tangent)) / square;
  p.up = curve::perpendicular(p.tangent, rate.up == dvec3(0) ? dvec3(0, 1, 0) : world(rate.up));
  if (rate.roll != 0) p.up = curve::perpendicular(p.tangent, curve::rotate(p.up, p.tangent, rate.roll));
  return p;
}

void ElementPath::add(double length, const ElementPiece& piece) {
  if (!(length > kShortPiece)) return;
  const int steps = std::clamp(static_cast<int>(length / kStep) + 1, kFewestSteps, kMaxSteps);
  const double step = length / steps;
  if (curve_.points.size() == 1) {
    const ElementPoint first = point(piece(0));
    start_roll_ = curve::signed_angle(first.up, start_up_, first.tangent);
    curve_.points[0].up = first.up;
  }
  for (int i = 0; i < steps; ++i) {
    dvec3 way(0);
    double distance = 0;
    for (int k = 0; k < 4; ++k) {
      const dvec3 d1 = world(piece((i + kNodes[k]) * step).d1);
      way += kWeights[k] * d1;
      distance += kWeights[k] * std::sqrt(glm::dot(d1, d1));
    }
    ElementPoint next = point(piece((i + 1) * step));
    next.position = end().position + way * step;
    next.s = end().s + distance * step;
    curve_.points.push_back(next);
  }
  curve_.breaks.push_back(curve_.points.size() - 1);
}

void ElementPath::add(std::initializer_list<double> lengths, const ElementPiece& whole) {
  double begin = 0;
  for (const double length : lengths) {
    add(length, [&whole, begin](double u) { return whole(begin + u); });
    begin += length;
  }
}

ElementDerivatives upright_rate(double angle, double bend) {
  const auto [sin, cos] = base::sin_cos(angle);
  return {{cos, sin, 0}, {-sin * bend, cos * bend, 0}, {-sin, cos, 0}, 0};
}

double slope_of(dvec3 direction) {
  return base::arc_tangent(direction.y, std::sqrt(direction.x * direction.x + direction.z * direction.z));
}

void ElementPath::add(const Bend& bend) {
  add({bend.ramp(), bend.arc(), bend.ramp()}, [&](double u) { return upright_rate(bend.angle(u), bend.bend(u)); });
}

void measure_spins(ElementCurve& curve) {
  std::vector<ElementPoint>& points = curve.points;
  std::vector<double> angles{0}, places{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ElementPoint &a = points[i - 1], &b = points[i];
    const curve::Frame carried = curve::transport({a.tangent, a.up}, a.position, b.position, b.tangent);
    angles.push_back(angles.back() + curve::signed_angle(carried.up, b.up, b.tangent));
    places.push_back(b.s);
  }
  for (std::size_t p = 0; p + 1 < curve.breaks.size(); ++p) {
    const std::size_t first = curve.breaks[p], last = curve.breaks[p + 1];
    for (std::size_t i = first; i <= last; ++i) {
      const std::size_t from = std::clamp(i, first + 1, last - 2) - 1;
      const double spin = derivative_at(&places[from], &angles[from], static_cast<int>(i - from));
      points[i].spin = i == first && p > 0 ? 0.5 * (points[i].spin + spin) : spin;
    }
  }
}

EndSlopes slopes_at(const ElementPoint& at, const ElementPoint& near, const ElementPoint& far) {
  const double x = near.s - at.s, y = far.s - at.s, first = y / (x * (y - x)), second = x / (y * (y - x));
  return {(near.spin - at.spin) * first - (far.spin - at.spin) * second,
          (near.curvature - at.curvature) * first - (far.curvature - at.curvature) * second};
}

void merge_short_pieces(ElementCurve& curve) {
  std::vector<std::size_t> breaks{0};
  for (const std::size_t at : curve.breaks)
    if (curve.points[at].s - curve.points[breaks.back()].s >= kShortestSpan &&
        curve.length() - curve.points[at].s >= kShortestSpan)
      breaks.push_back(at);
  breaks.push_back(curve.points.size() - 1);
  curve.breaks = std::move(breaks);
}

ElementCurve ElementPath::finish(double reach) {
  double fade = curve_.length();
  for (const std::size_t at : curve_.breaks)
    if (const double s = curve_.points[at].s; s >= reach) {
      fade = s;
      break;
    }
  measure_spins(curve_);
  const Roll over{fade, -start_roll_, start_spin_ - curve_.points.front().spin, 0};
  for (ElementPoint& p : curve_.points) {
    if (!(p.s < fade) || (start_roll_ == 0 && start_spin_ == 0)) break;
    p.up = curve::perpendicular(p.tangent, curve::rotate(p.up, p.tangent, start_roll_ + over.angle(p.s)));
    p.spin += over.spin(p.s);
  }
  merge_short_pieces(curve_);
  return std::move(curve_);
}

namespace {
using base::kPi;
}  // namespace

double root(double low, double high, const std::function<double(double)>& f) {
  return base::bisect({low, high}, 60, [&](double x) { return f(x) < 0; }).middle();
}

double tangent_of(double angle) {
  const auto [sin, cos] = base::sin_cos(angle);
  return sin / cos;
}

HillFoot::HillFoot(double steepest, double least_radius, double p)
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

double HillFoot::bend(double u) const {
  if (u < first) return u / (first * radius);
  if (u < first + arc) return 1 / radius;
  return 1 / radius - (1 / radius + crest_bend) * (u - first - arc) / second;
}

double HillFoot::angle_at(double u) const {
  if (u < first) return u * u / (2 * first * radius);
  if (u < first + arc) return first_angle + (u - first) / radius;
  const double v = u - first - arc;
  return angle - second_angle + v / radius - (1 / radius + crest_bend) * v * v / (2 * second);
}

double HillFoot::rise() const {
  constexpr int kSteps = 16;
  double sum = 0;
  for (const auto& [begin, part] : {dvec2(0, first), dvec2(first, arc), dvec2(first + arc, second)})
    sum += integral(part, kSteps, [&, from = begin](double u) {
             return dvec2(0, base::sin_cos(angle_at(from + u)).sin);
           }).y;
  return sum;
}

void add_foot_up(ElementPath& path, const HillFoot& foot) {
  path.add({foot.first, foot.arc, foot.second}, [&](double u) { return upright_rate(foot.angle_at(u), foot.bend(u)); });
}

void add_foot_down(ElementPath& path, const HillFoot& foot, double way) {
  const double whole = foot.length();
  const auto down = [&](double from) {
    return [&foot, from, way](double u) {
      ElementDerivatives rate = upright_rate(-foot.angle_at(from - u), foot.bend(from - u));
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
    return ElementDerivatives{{way, slope, 0},
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
