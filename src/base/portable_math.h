// Sine and cosine with the same bits on every compiler, library and processor (given -ffp-contract=off), for values
// that are hashed. Not faster than libm.
#pragma once

namespace coaster::base {

struct SinCos {
  double sin, cos;
};

// Returns sine and cosine of `radians`; absolute error below 1e-15 for |radians| <= 1e4. Non-finite input gives {0, 1}.
SinCos sin_cos(double radians);

// Returns the angle of the point (x, y) in (-pi, pi], as std::atan2, absolute error below 1e-15; {0, 0} gives 0.
double arc_tangent(double y, double x);

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
inline constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

}  // namespace coaster::base
