// Projection of space curves onto a plane.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace coaster::ui {

// A plane to draw in: right and up are perpendicular unit vectors.
struct Sheet {
  glm::dvec3 origin{0}, right{1, 0, 0}, up{0, 1, 0};
  glm::dvec2 at(glm::dvec3 p) const { return {glm::dot(p - origin, right), glm::dot(p - origin, up)}; }
};

// Returns the plane through `points` (at least one; the first is the origin) in which they spread most: `right` along
// the two farthest points, `up` towards the point farthest from that line. The last point is right of the first, and
// `up` does not point down in the world. Coplanar points keep their distances. Collinear or coincident points give any
// plane that contains them.
Sheet sheet_of(std::span<const glm::dvec3> points);

// Points as coordinates of a plot's series.
struct Trace {
  std::vector<double> x, y;
  void add(glm::dvec2 p) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
};

}  // namespace coaster::ui
