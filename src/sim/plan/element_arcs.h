// The arcs that make up the vertical elements: the foot of a hill, the parabola over its crest, and the teardrop of a
// loop. Private to element_shapes_*.cpp.
#pragma once

#include <functional>

#include "sim/plan/element_path.h"

namespace coaster::sim {

// Returns the x in [low, high] at which f crosses 0 upwards, to machine accuracy.
double root(double low, double high, const std::function<double(double)>& f);

double tangent_of(double angle);

// The foot of a camelback, given by its steepest angle: a clothoid to 1/radius, a circle, and a clothoid through the
// inflection to the parabola's curvature -bend. The other foot is its mirror image.
struct Foot {
  double angle, radius, crest_bend;
  double first, second, arc;  // m: clothoids and circle
  double first_angle, second_angle;
  Foot(double steepest, double least_radius, double p);
  double length() const { return first + arc + second; }
  double bend(double u) const;
  double angle_at(double u) const;
  double rise() const;  // m
};

// Adds a foot upwards, or its mirror image downwards. `way`: 1 along the axes' forward, -1 against it.
void add_foot_up(ElementPath& path, const Foot& foot);
void add_foot_down(ElementPath& path, const Foot& foot, double way = 1);

// Adds the parabola y = -x^2 / (2 p) over a crest from x = -edge to x = edge, rolled from one angle to another (rad).
void add_parabola(ElementPath& path, double p, double edge, double way = 1, double from_roll = 0, double to_roll = 0);

// A turn about a level axis: in the plane perpendicular to the axis a teardrop of clothoid, circle, clothoid, one whole
// turn, while it advances along the axis at a constant rate. The tangent keeps its angle to the axis, and curvature and
// torsion keep their ratio (a generalised helix), so after a whole turn the frame is as at the start: upright and
// straight ahead. Up is the normal: the only lateral force is gravity.
class Winding {
 public:
  // `top`: rad of the turn that form a circle in the plane perpendicular to the axis.
  Winding(double height, double top);
  double radius() const { return radius_; }  // m, of the circle
  double ramp() const { return 2 * radius_ * ramp_angle_; }
  double arc() const { return arc_; }
  double length() const { return 2 * ramp() + arc_; }  // m, in the plane perpendicular to the axis
  double width() const { return width_; }              // m, advance of the teardrop in that plane
  double turned(double u) const;
  double bend(double u) const;

 private:
  glm::dvec2 direction(double begin, double length) const;
  double ramp_angle_, radius_ = 1, width_ = 0, arc_ = 0;
};

}  // namespace coaster::sim
