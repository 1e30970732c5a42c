#include "exchange/nolimits/nl2_rolls.h"

#include <algorithm>

#include "curve/natural_spline.h"
#include "sim/shape/roll.h"

namespace coaster::exchange {

using glm::dvec3;

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

}  // namespace coaster::exchange
