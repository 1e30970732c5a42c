// The ideal curve of an element, before Bezier spans are fitted to it: pieces given by closed-form derivatives,
// integrated to dense points.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

#include "curve/frames.h"

namespace coaster::sim {

// Returns the angle of a direction above the horizon, rad.
double slope_of(glm::dvec3 direction);

struct ElementPoint {
  double s = 0;                 // m, arc length from the curve's start
  glm::dvec3 position{0};       // m
  glm::dvec3 tangent{1, 0, 0};  // unit
  glm::dvec3 curvature{0};      // 1/m, derivative of the tangent by length: towards the centre
  glm::dvec3 up{0, 1, 0};       // unit, perpendicular to the tangent
  double spin = 0;              // rad/m, rate of `up` about the tangent against the rotation-minimising frame
  // rad/m^2, allowed error of the slope of the roll's rate in a span that ends here; 1.5 times as much is allowed for
  // the slope of its curvature towards up (1/m^2). Both cause an acceleration of a rider above the rails: lateral and
  // longitudinal.
  double slope_error = std::numeric_limits<double>::infinity();
};

// Tangent and curvature are continuous along the curve; at a break the derivative of the curvature changes.
struct ElementCurve {
  std::vector<ElementPoint> points;
  std::vector<std::size_t> breaks;  // indices into `points` where pieces begin, and the last point
  std::size_t lead = 0;  // index where the element proper begins; the lead-in fades out the end's curvature and slope
  double length() const { return points.empty() ? 0 : points.back().s; }
};

// Sets the spin of every point: the derivative of its angle against the rotation-minimising frame, by four points of
// its piece; at a break the mean of both sides. Pieces need 4 points.
void measure_spins(ElementCurve& curve);
// The derivatives by length of the spin and the curvature at a point, from two more points on one side of it.
struct EndSlopes {
  double spin;           // rad/m^2
  glm::dvec3 curvature;  // 1/m^2
};
EndSlopes slopes_at(const ElementPoint& at, const ElementPoint& near, const ElementPoint& far);
// Merges pieces too short for a separate span with a neighbour.
void merge_short_pieces(ElementCurve& curve);

// A piece at its parameter u, in the axes of the builder: first and second derivative by u, and the up vector.
struct ElementDerivatives {
  glm::dvec3 d1{1, 0, 0}, d2{0};
  glm::dvec3 up{0};  // not yet perpendicular; 0: upright, as near to +Y as possible
  double roll = 0;   // rad about the tangent on top of `up`, positive to the rider's right
};
using ElementPiece = std::function<ElementDerivatives(double u)>;

// Returns the rate by arc length of a curve in the plane of forward and up, from its angle and curvature there.
ElementDerivatives upright_rate(double angle, double bend);

// Returns a value from 0 to 1 for v in [0, 1], with derivative 0 at both ends.
inline double smooth_step(double v) { return v * v * (3.0 - 2.0 * v); }
// The same with a second derivative of 0 at both ends, and its integral from 0: 1/2 at 1.
inline double soft_step(double v) { return v * v * v * (10.0 - 15.0 * v + 6.0 * v * v); }
inline double soft_step_integral(double v) { return v * v * v * v * (2.5 - 3.0 * v + v * v); }

// A bend from one angle to another: ramp, circle, ramp. Curvature rises as smooth_step() of the length from 0 to
// 1/radius, over a quarter of the angle, at most 30 degrees, or over a given length, and falls in the same way.
struct Bend {
  static constexpr double kShortest = 6;  // m: a slight bend gets a larger radius instead
  double from = 0, to = 0;                // rad
  double radius = 1;                      // m
  double ramp_length = 0;                 // m, at most radius times angle; 0: a quarter of the angle
  bool soft = false;                      // the curvature rises as soft_step()
  // Makes the bend at least `shortest` m long.
  Bend(double from_angle, double to_angle, double least_radius, double length_of_ramp = 0, double shortest = kShortest);
  double ramp_angle() const;
  double ramp() const { return 2.0 * radius * ramp_angle(); }  // m, length of each ramp
  double arc() const;                                          // m, length of the circle
  double length() const { return 2.0 * ramp() + arc(); }
  double angle(double u) const;  // rad at u in [0, length()]
  double bend(double u) const;   // 1/m, d angle / du, signed
  // Returns the integrals over the whole bend of cos(angle) and sin(angle), m; relative error below 1e-12.
  glm::dvec2 run_and_rise() const;
};

// Returns the integral of f over [0, length] by 4-point Gauss-Legendre on `steps` equal parts.
glm::dvec2 integral(double length, int steps, const std::function<glm::dvec2(double)>& f);

// Joins pieces. Positions are integrated in steps of at most kStep (longer pieces: kMaxSteps) by 4-point
// Gauss-Legendre: for turns below 0.2 rad per step the error is below 1e-12 of the length. Uses only + - * / sqrt and
// base::sin_cos: the same bits everywhere.
class ElementPath {
 public:
  static constexpr double kStep = 0.25;  // m
  static constexpr int kMaxSteps = 4000;

  // Starts at a position with a tangent, a curvature, an up vector and a spin (rad/m).
  ElementPath(glm::dvec3 position, glm::dvec3 tangent, glm::dvec3 curvature, glm::dvec3 up, double spin = 0);
  void set_axes(glm::dvec3 forward, glm::dvec3 up, glm::dvec3 left) { forward_ = forward, up_ = up, left_ = left; }
  // Appends a piece; ignores pieces shorter than 1e-9 m.
  void add(double length, const ElementPiece& piece);
  // Adds a curve in parts of these lengths, with breaks between them.
  void add(std::initializer_list<double> lengths, const ElementPiece& whole);
  // Adds a bend in the plane of forward and up, with angles from forward.
  void add(const Bend& bend);
  // Marks the end of the lead-in.
  void begin_element() { curve_.lead = curve_.points.size() - 1; }

  const ElementPoint& end() const { return curve_.points.back(); }
  const ElementCurve& curve() const { return curve_; }
  // Finishes the curve. The differences between the start's roll and spin and those of the pieces fade out until the
  // first break at least `reach` metres away, else until the end, as a cubic.
  ElementCurve finish(double reach);

 private:
  glm::dvec3 world(glm::dvec3 v) const { return v.x * forward_ + v.y * up_ + v.z * left_; }
  ElementPoint point(const ElementDerivatives& rate) const;

  glm::dvec3 forward_{1, 0, 0}, up_{0, 1, 0}, left_{0, 0, -1};
  glm::dvec3 start_up_;
  double start_roll_ = 0, start_spin_ = 0;
  ElementCurve curve_;
};

// Returns the x in [low, high] at which f crosses 0 upwards, to machine accuracy.
double root(double low, double high, const std::function<double(double)>& f);

double tangent_of(double angle);

// The foot of a camelback, given by its steepest angle: a clothoid to 1/radius, a circle, and a clothoid through the
// inflection to the parabola's curvature -bend. The other foot is its mirror image.
struct HillFoot {
  double angle, radius, crest_bend;
  double first, second, arc;  // m: clothoids and circle
  double first_angle, second_angle;
  HillFoot(double steepest, double least_radius, double p);
  double length() const { return first + arc + second; }
  double bend(double u) const;
  double angle_at(double u) const;
  double rise() const;  // m
};

// Adds a foot upwards, or its mirror image downwards. `way`: 1 along the axes' forward, -1 against it.
void add_foot_up(ElementPath& path, const HillFoot& foot);
void add_foot_down(ElementPath& path, const HillFoot& foot, double way = 1);

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
