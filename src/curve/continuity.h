// Continuity of the joint of two cubics: geometric (shape) and parametric (shape and speed of the parameter).
#pragma once

#include <cstdint>

#include "base/names.h"
#include "curve/cubic.h"

namespace coaster::curve {

enum class Geometric : std::uint8_t { broken, g0, g1, g2 };
inline constexpr base::NameRow kGeometric[] = {{"none"}, {"G0"}, {"G1"}, {"G2"}};
constexpr std::span<const base::NameRow> rows_of(Geometric) { return kGeometric; }
enum class Parametric : std::uint8_t { broken, c0, c1, c2 };
inline constexpr base::NameRow kParametric[] = {{"none"}, {"C0"}, {"C1"}, {"C2"}};
constexpr std::span<const base::NameRow> rows_of(Parametric) { return kParametric; }

struct Joint {
  double gap;             // m, |b3 - c0|
  double angle;           // radians between the tangents
  double speed_ratio;     // |C'(0)| / |B'(1)|
  double curvature_jump;  // 1/m, length of the difference of the curvature vectors
  Geometric geometric;
  Parametric parametric;
  glm::dvec3 curvature_before, curvature_after;  // 1/m, towards the centre; the length is the curvature
  double second_jump;                            // m, length of C''(0) - B''(1): 0 for C2
};

// Returns the curvature vector in 1/m, the change of the unit tangent per metre; 0 where B' vanishes, which there means
// that there is none (curvature_if_any). At t = 0 its length is (2/3) |d0 x d1| / |d0|^3 with d0 = p1 - p0, d1 = p2 -
// p1.
glm::dvec3 curvature_vector(const Cubic& cubic, double t);

// Compares the end of `before` with the start of `after`. Tolerances: gap exactly 0 for G0/C0 (control points are
// shared), angle 1e-3 rad, relative speed 1e-4, curvature 1e-3 /m, second derivative 1e-3 of its size. Paper erratum: a
// common tangent line is G1; equal first derivatives (C1) are more.
Joint joint(const Cubic& before, const Cubic& after);

}  // namespace coaster::curve
