// The cubic Bézier segment: control points, exact evaluation in double, derivatives, splitting. The evaluators to
// compare are in evaluators.h.
#pragma once

#include <cmath>
#include <optional>

#include <glm/glm.hpp>

namespace coaster::curve {

// Control points b0..b3 of Barrett 2012, section 2.1. Metres.
struct Cubic {
  glm::vec3 p0{0}, p1{0}, p2{0}, p3{0};
  friend bool operator==(const Cubic&, const Cubic&) = default;
};

// Coefficients of B(t) = c0 + t (c1 + t (c2 + t c3)); Barrett 2012, section 3.3.
struct Coefficients {
  glm::vec3 c0{0}, c1{0}, c2{0}, c3{0};
};
struct CoefficientsD {
  glm::dvec3 c0{0}, c1{0}, c2{0}, c3{0};
  // B(t), B'(t), B''(t), |B'(t)|.
  glm::dvec3 point(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  glm::dvec3 derivative(double t) const { return c1 + t * (2.0 * c2 + t * (3.0 * c3)); }
  glm::dvec3 second_derivative(double t) const { return 2.0 * c2 + t * (6.0 * c3); }
  double speed(double t) const {
    const glm::dvec3 d = derivative(t);
    return std::sqrt(glm::dot(d, d));
  }
};

// A cubic with precomputed coefficients; changes only when a control point moves.
struct PreparedCubic {
  Cubic cubic;
  Coefficients monomial;
};

Coefficients coefficients(const Cubic& cubic);     // in float, as in the paper's program
CoefficientsD coefficients_d(const Cubic& cubic);  // exact control points, double arithmetic
PreparedCubic prepare(const Cubic& cubic);

// Return B(t), B'(t), B''(t), B'''(t) in double, t in [0,1] (any finite t is allowed). At t = 0 and 1 point() is
// exactly p0 and p3.
glm::dvec3 point(const Cubic& cubic, double t);
glm::dvec3 derivative(const Cubic& cubic, double t);
glm::dvec3 second_derivative(const Cubic& cubic, double t);
glm::dvec3 third_derivative(const Cubic& cubic);

// Returns B(t) by de Casteljau in long double, rounded to double. The oracle for deviations.
glm::dvec3 point_long_double(const Cubic& cubic, double t);

// Returns the unit tangent at t. Where B'(t) vanishes (a cusp, a handle on its anchor) it is the limit direction from
// the next derivatives; four equal points give (1,0,0). Never NaN.
glm::dvec3 unit_tangent(const Cubic& cubic, double t);

// Returns |B'(t) x B''(t)| / |B'(t)|^3 in 1/m. Where B' vanishes it returns 0, which there only means that there is no
// number: the curvature may be unbounded. What is shown to people takes curvature_if_any().
double curvature(const Cubic& cubic, double t);

// Returns the curvature in 1/m, or its limit where B' vanishes (below 1e-9 of the longest leg, as for unit_tangent):
// 0 on a straight, at a handle on its anchor or where B'' vanishes, too. Returns nothing where there is none: at cusps
// and where a straight turns back, at a handle on the anchor of a curve that bends there (both unbounded), and for four
// equal points.
std::optional<double> curvature_if_any(const Cubic& cubic, double t);

struct SplitCubic {
  Cubic left, right;
};

// Splits at t in [0,1] by de Casteljau: left covers [0,t], right [t,1]; left.p3 == right.p0 exactly. Computed in double
// and rounded once, so each control point is within half an ulp of the exact split.
SplitCubic split(const Cubic& cubic, double t);

struct Box {
  glm::vec3 low{0}, high{0};
};

// Returns the bounding box of the control points, which contains the curve (convex hull property).
Box control_box(const Cubic& cubic);

struct NearestPoint {
  double t;
  double distance;  // m
};

// Returns the point of the curve nearest to `target`, of all minima of the distance and both ends; t within 1e-9.
NearestPoint nearest_point(const Cubic& cubic, glm::dvec3 target);

}  // namespace coaster::curve
