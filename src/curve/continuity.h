// Continuity of the joint of two cubics: geometric (shape) and parametric (shape and speed of the parameter).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "curve/cubic.h"

namespace coaster::curve {

// A level's name. rows_of() returns a row per enumerator, in their order.
struct LevelRow {
  std::string_view name;
};
enum class GeometricContinuity : std::uint8_t { broken, g0, g1, g2 };
inline constexpr LevelRow kGeometric[] = {{"none"}, {"G0"}, {"G1"}, {"G2"}};
constexpr std::span<const LevelRow> rows_of(GeometricContinuity) { return kGeometric; }
enum class ParametricContinuity : std::uint8_t { broken, c0, c1, c2 };
inline constexpr LevelRow kParametric[] = {{"none"}, {"C0"}, {"C1"}, {"C2"}};
constexpr std::span<const LevelRow> rows_of(ParametricContinuity) { return kParametric; }

struct JointContinuity {
  double gap;             // m, |b3 - c0|
  double angle;           // radians between the tangents
  double speed_ratio;     // |C'(0)| / |B'(1)|
  double curvature_jump;  // 1/m, length of the difference of the curvature vectors
  GeometricContinuity geometric;
  ParametricContinuity parametric;
  glm::dvec3 curvature_before, curvature_after;  // 1/m, towards the centre; the length is the curvature
  double second_jump;                            // m, length of C''(0) - B''(1): 0 for C2
};

// Returns the curvature vector in 1/m, the change of the unit tangent per metre; 0 where B' vanishes, which there means
// that there is none (curvature_if_any). At t = 0 its length is (2/3) |d0 x d1| / |d0|^3 with d0 = p1 - p0, d1 = p2 -
// p1.
glm::dvec3 curvature_vector(const Cubic& cubic, double t);

// Returns the farthest, m, that rounding to float can have moved a control point: along each axis an ulp of the
// largest of a knot's coordinate, its handle's and the handle's length, whose direction is rounded as a unit vector;
// the same along both level axes, because carrying turns knots about the vertical. With e that distance, B' is off
// by at most 6 e, B'' by 24 e.
double rounding_error(const Cubic& cubic);

// Returns the most, 1/m, by which rounding can have changed the curvature vector at t, to first order: knots by an ulp
// (half where they are planned, half where they are carried), their handles with them, and handles by half an ulp more.
// Infinite where that can turn B' any way. For T the tangent, v = |B'| less 6 e, a = T . B'', k the curvature, f_i and
// g_i the weights of point i in B' and B'', w_i = g_i - f_i a / v, and n the largest length across T of a corner of the
// box of ulps: for a knot i and its handle j n (max(|w_i|, |w_i + w_j|) + |w_j| / 2) / v^2, for both knots, + 12 e k /
// v. At most 4 times what a search finds (tests).
double rounding_curvature(const Cubic& cubic, double t);

// Returns the largest jump between two curvature vectors that is G2, 1/m: 1e-3 of the larger, or `rounding` if more.
double largest_jump(glm::dvec3 before, glm::dvec3 after, double rounding);

// Compares the end of `before` with the start of `after`, by the curve alone; sim::g_step() says what riders feel. The
// gap must be 0 (control points are shared). The others must be within a tolerance without a scale, or what rounding
// can make of 0 (tiny handles, far from the origin), whichever is more. G1: angle 1e-3 rad, or what 6 e turn both
// tangents by, but no more where a handle has no length. G2: largest_jump() with rounding_curvature()
// of both. C1: ratio of speeds 1e-4, or 6 e of both. C2: jump of the second derivative 1e-3 of its
// size, or 24 e of both. Paper erratum: a common tangent line is G1; equal first derivatives (C1) are more.
JointContinuity joint(const Cubic& before, const Cubic& after);

}  // namespace coaster::curve
