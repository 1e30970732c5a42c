// The point of a curve nearest to a given one. On the parabola y = x^2 / 12 it follows from a quadratic equation.
#include <cstdio>

#include <coaster/curve/cubic.h>

namespace curve = coaster::curve;

int main() {
  const curve::Cubic parabola{{0, 0, 0}, {4, 0, 0}, {8, 4, 0}, {12, 12, 0}};
  // On the axis inside and outside the circle of curvature, beside it, beyond the end, and off the plane.
  for (const glm::dvec3 target : {glm::dvec3(0, 3, 0), {0, 15, 0}, {0, 8, 5}, {20, 30, 0}, {6, 3, -2}}) {
    const curve::NearestPoint nearest = curve::nearest_point(parabola, target);
    const glm::dvec3 p = curve::point(parabola, nearest.t);
    std::printf("nearest %.9g %.9g %.9g %.12f %.12f %.9f %.9f\n", target.x, target.y, target.z, nearest.t,
                nearest.distance, p.x, p.y);
  }
}
