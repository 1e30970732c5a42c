// The rolls of a span's two knots with which it keeps its rows' frames within a bound.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace coaster::sim {

// The additional rolls (a, b) of the first and the second knot, radians, that keep all frames within the bound: a
// convex polygon, empty if there are none.
using RollWindow = std::vector<glm::dvec2>;

// Keeps the part of the polygon with normal . x <= limit. A corner that is off by rounding stays: otherwise each row of
// a straight, whose lines all meet in two corners, would add corners there. `spare` is memory that is reused.
void clip(RollWindow& polygon, glm::dvec2 normal, double limit, RollWindow& spare);

// The smallest and largest roll of the second knot within a window; low > high if it is empty.
struct RollRange {
  double low = 1, high = -1;
};
RollRange second_rolls(const RollWindow& window);

// Returns the roll nearest to `wanted` that the window allows the first knot when the second has `second`.
double first_roll(const RollWindow& window, double second, double wanted);

}  // namespace coaster::sim
