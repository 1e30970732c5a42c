// A ray over a field of heights: the march that finds where it goes below them.
#pragma once

#include <cmath>
#include <optional>

#include <glm/glm.hpp>

#include "world/park.h"

namespace coaster::sim {

// Returns the distance (m) at which a ray from `origin` along the unit `direction` first meets the heights, at most
// `most`; nothing if it does not, or begins below them. Misses what rises above the ray for less than a step.
std::optional<double> meet_heights(glm::dvec3 origin, glm::dvec3 direction, double most, auto&& height) {
  const auto over = [&](double t) {
    const glm::dvec3 p = origin + t * direction;
    return p.y - height(p.x, p.z);
  };
  double margin = over(0), before = 0;
  if (margin < 0) return std::nullopt;
  for (double t = 0; t < most; before = t) {
    // Steps of half a cell near the eye, longer far away and high above all land.
    t = std::fmin(t + std::fmax(0.5 * world::kGroundCell * (1 + t / 200), 0.25 * margin), most);
    margin = over(t);
    if (margin >= 0) continue;
    for (double low = before, high = t;;) {
      const double middle = 0.5 * (low + high);
      if (high - low < 1e-5 || middle <= low || middle >= high) return high;
      (over(middle) >= 0 ? low : high) = middle;
    }
  }
  return std::nullopt;
}

}  // namespace coaster::sim
