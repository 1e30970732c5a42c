// The plane of largest extent.
#include "ui/lab/shapes.h"

#include <cmath>

namespace coaster::ui {
namespace {

glm::dvec3 any_perpendicular(glm::dvec3 unit) {
  const glm::dvec3 other = std::abs(unit.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return glm::normalize(other - glm::dot(other, unit) * unit);
}

// Returns the direction between the two points that are farthest apart; {1,0,0} if all coincide.
glm::dvec3 longest_direction(std::span<const glm::dvec3> points) {
  glm::dvec3 longest(0);
  for (const glm::dvec3 a : points)
    for (const glm::dvec3 b : points)
      if (glm::dot(b - a, b - a) > glm::dot(longest, longest)) longest = b - a;
  const double length = glm::length(longest);
  return length > 0 ? longest / length : glm::dvec3(1, 0, 0);
}

}  // namespace

Sheet sheet_of(std::span<const glm::dvec3> points) {
  const glm::dvec3 origin = points.front(), along = longest_direction(points);
  glm::dvec3 off(0);
  double largest = 0;
  for (const glm::dvec3 p : points) {
    const glm::dvec3 across = (p - origin) - glm::dot(p - origin, along) * along;
    if (glm::dot(across, across) > glm::dot(off, off)) off = across;
    largest = std::max(largest, glm::length(p - origin));
  }
  const double reach = glm::length(off);
  const glm::dvec3 across = reach > 1e-9 * largest && reach > 0 ? off / reach : any_perpendicular(along);
  Sheet sheet{origin, along, across};
  if (glm::dot(points.back() - origin, along) < 0) sheet.right = -along;
  if (across.y < 0) sheet.up = -across;
  return sheet;
}

}  // namespace coaster::ui
