// Frames along a curve: Frenet-Serret, rotation-minimising by double reflection, and rotations of vectors.
#pragma once

#include <optional>

#include "curve/cubic.h"

namespace coaster::curve {

// Right-handed: forward (tangent), left = up x forward, up. Unit and mutually perpendicular to 1e-12.
struct Frame {
  glm::dvec3 forward{1, 0, 0}, up{0, 1, 0};
  glm::dvec3 left() const { return glm::cross(up, forward); }
};

// Tangent, normal (towards the centre of curvature), binormal T x N; curvature in 1/m, torsion in 1/m.
struct FrenetFrame {
  glm::dvec3 tangent, normal, binormal;
  double curvature, torsion;
};

// Returns the Frenet frame at t; Barrett 2012, section 2.3. Returns nothing where B' vanishes, or where the curvature
// is below 1e-9 /m or below the rounding error of control points in float: there the normal would be noise (Paper
// erratum: the normal is undefined there and flips across an inflection).
std::optional<FrenetFrame> frenet(const Cubic& cubic, double t);

// The quadratic polynomial B'(t) x B''(t) of a cubic: b0 + t (b1 + t b2), in m^2. Its direction is the binormal's.
struct BinormalCurve {
  glm::dvec3 b0{0}, b1{0}, b2{0};
  glm::dvec3 at(double t) const { return b0 + t * (b1 + t * b2); }
};
BinormalCurve binormal_curve(const Cubic& cubic);

// Where the binormal may reverse in (0,1), ascending, within 1e-9: the inflections of a plane cubic, which are the
// roots of a quadratic, or the local minima of |B' x B''| of another one, where its normal turns fastest. At most 2;
// two that are closer than 1e-7 may count as none. About 0.4 us.
struct BinormalMinima {
  int count = 0;
  double t[2] = {0, 0};
};
BinormalMinima binormal_minima(const BinormalCurve& curve);

// How far the binormal, and with it the Frenet-Serret normal, turns at each of these places: the angle in [0, pi]
// between its directions at `from` and `to`, 1/64 before and after t, but not beyond the ends or halfway to the other
// place. So 180 degrees at each inflection of a plane cubic, however near they are to each other.
struct BinormalTurn {
  double t = 0, from = 0, to = 0, angle = 0;
};
struct BinormalTurns {
  int count = 0;
  BinormalTurn at[2];
};
BinormalTurns binormal_turns(const BinormalCurve& curve);

// Returns the angle between two vectors of any length, radians in [0, pi]; 0 if one of them is zero.
double angle_between(glm::dvec3 a, glm::dvec3 b);

// Returns the angle by which the binormal turns from t0 to t1, radians in [0, pi]; 0 where it has no direction.
double binormal_turn(const BinormalCurve& curve, double t0, double t1);

// Carries `from.up` from point x0 to x1 with tangent t1 by double reflection (Wang et al. 2008, doi
// 10.1145/1330511.1330513). Uses the least rotation if x0 == x1 or the tangents are opposite.
Frame transport(const Frame& from, glm::dvec3 x0, glm::dvec3 x1, glm::dvec3 t1);

// Returns `v` turned by the least rotation that takes unit vector `from` to unit vector `to`; for opposite vectors, by
// the half turn about `axis` (unit, perpendicular to `from`). Uses no libm function except sqrt: the same bits
// everywhere.
glm::dvec3 least_rotation(glm::dvec3 from, glm::dvec3 to, glm::dvec3 v, glm::dvec3 axis);

// Returns `v` turned about the unit `axis` by `radians` (right-handed), with base::sin_cos: the same bits everywhere.
glm::dvec3 rotate(glm::dvec3 v, glm::dvec3 axis, double radians);

// Returns the signed angle in (-pi, pi] that turns `from` to `to` about `axis`; the same bits everywhere
// (base::arc_tangent).
double signed_angle(glm::dvec3 from, glm::dvec3 to, glm::dvec3 axis);

// Returns the part of `v` that is perpendicular to unit `forward`.
inline glm::dvec3 across(glm::dvec3 v, glm::dvec3 forward) { return v - forward * glm::dot(v, forward); }

// Returns the unit vector perpendicular to unit `forward` that is nearest to `wish`; if they are parallel, a
// perpendicular vector that depends on `forward` alone.
glm::dvec3 perpendicular(glm::dvec3 forward, glm::dvec3 wish);

}  // namespace coaster::curve
