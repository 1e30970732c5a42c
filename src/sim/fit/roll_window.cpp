#include "sim/fit/roll_window.h"

#include <algorithm>
#include <cmath>

namespace coaster::sim {

using glm::dvec2;

void clip(RollWindow& polygon, dvec2 normal, double limit, RollWindow& spare) {
  constexpr double kRounding = 1e-12;  // radians
  bool all = true;
  for (const dvec2 p : polygon) all = all && glm::dot(normal, p) <= limit + kRounding;
  if (all) return;
  spare.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double x = glm::dot(normal, a) - limit, y = glm::dot(normal, b) - limit;
    if (x <= 0) spare.push_back(a);
    if ((x < 0 && y > 0) || (x > 0 && y < 0)) spare.push_back(a + (x / (x - y)) * (b - a));
  }
  polygon.swap(spare);
}

RollRange second_rolls(const RollWindow& window) {
  RollRange range;
  for (const glm::dvec2 p : window) range.low = std::min(range.low, p.y), range.high = std::max(range.high, p.y);
  return range;
}

double first_roll(const RollWindow& window, double second, double wanted) {
  double low = 1, high = -1;
  const auto take = [&](double x) { low = std::min(low, x), high = std::max(high, x); };
  const glm::dvec2* nearest = nullptr;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const glm::dvec2 &a = window[i], &b = window[i + 1 < window.size() ? i + 1 : 0];
    if (!nearest || std::abs(a.y - second) < std::abs(nearest->y - second)) nearest = &a;
    if (a.y == second) take(a.x);
    if ((a.y < second && b.y > second) || (a.y > second && b.y < second))
      take(a.x + (second - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  if (low > high) return nearest ? nearest->x : wanted;  // rounding has put `second` just outside
  return std::clamp(wanted, low, high);
}

}  // namespace coaster::sim
