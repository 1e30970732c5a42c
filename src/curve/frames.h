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

// Barrett 2012, section 2.3. Nothing where the curvature is below 1e-9 /m or B' vanishes (Paper erratum: the normal is undefined
// there and flips across an inflection).
std::optional<FrenetFrame> frenet(const Cubic& cubic, double t);

// Carries `from.up` from point x0 to x1 with tangent t1 by double reflection (Wang et al. 2008, doi 10.1145/1330511.1330513).
// x0 == x1 or opposite tangents fall back to the least rotation.
Frame transport(const Frame& from, glm::dvec3 x0, glm::dvec3 x1, glm::dvec3 t1);

// `v` turned by the least rotation that takes unit vector `from` to unit vector `to`; for opposite vectors the half turn about `axis`
// (unit, perpendicular to `from`). Uses no libm functions but sqrt: the same bits everywhere.
glm::dvec3 least_rotation(glm::dvec3 from, glm::dvec3 to, glm::dvec3 v, glm::dvec3 axis);

// `v` turned about the unit `axis` by `radians` (right-handed), with base::sin_cos: the same bits everywhere.
glm::dvec3 rotate(glm::dvec3 v, glm::dvec3 axis, double radians);

// Signed angle in (-pi, pi] that turns `from` to `to` about `axis`; the same bits everywhere (base::arc_tangent).
double signed_angle(glm::dvec3 from, glm::dvec3 to, glm::dvec3 axis);

// A unit vector perpendicular to unit `forward`, as near to `wish` as can be; when they are parallel, some perpendicular
// vector that depends on `forward` alone.
glm::dvec3 perpendicular(glm::dvec3 forward, glm::dvec3 wish);

}  // namespace coaster::curve
