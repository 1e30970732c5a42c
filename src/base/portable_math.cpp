// Cody-Waite reduction by pi/2 in three parts, then Taylor polynomials on [-pi/4, pi/4], whose first dropped terms are
// below 1e-17.
#include "base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coaster::base {
namespace {

// pi/2 = kHigh + kMiddle + kLow; the first two have 33 significant bits, so their products with |n| < 2^20 are exact.
constexpr double kHigh = 1.57079632673412561417e+00;
constexpr double kMiddle = 6.07710050630396597660e-11;
constexpr double kLow = 2.02226624879595063154e-21;
constexpr double kTwoOverPi = 0.63661977236758134308;

double sin_polynomial(double x) {
  const double z = x * x;
  double p = -1.0 / 1307674368000.0;  // 1/15!
  p = p * z + 1.0 / 6227020800.0;
  p = p * z - 1.0 / 39916800.0;
  p = p * z + 1.0 / 362880.0;
  p = p * z - 1.0 / 5040.0;
  p = p * z + 1.0 / 120.0;
  p = p * z - 1.0 / 6.0;
  return x + x * (z * p);
}

double cos_polynomial(double x) {
  const double z = x * x;
  double p = 1.0 / 20922789888000.0;  // 1/16!
  p = p * z - 1.0 / 87178291200.0;
  p = p * z + 1.0 / 479001600.0;
  p = p * z - 1.0 / 3628800.0;
  p = p * z + 1.0 / 40320.0;
  p = p * z - 1.0 / 720.0;
  p = p * z + 1.0 / 24.0;
  return 1.0 - (0.5 * z - z * z * p);
}

}  // namespace

SinCos sin_cos(double radians) {
  if (!std::isfinite(radians) || std::abs(radians) > 1e6) return {0.0, 1.0};
  const double n = std::floor(radians * kTwoOverPi + 0.5);
  const double x = ((radians - n * kHigh) - n * kMiddle) - n * kLow;
  const double s = sin_polynomial(x), c = cos_polynomial(x);
  switch (static_cast<std::int64_t>(n) & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

double arc_tangent(double y, double x) {
  const double radius = std::sqrt(x * x + y * y);
  if (!(radius > 0.0) || !std::isfinite(radius)) return 0.0;
  const double c = x / radius, s = y / radius;
  // A first guess within 0.005 rad in the octant, then Newton on sin(guess - angle), which cubes the error each time.
  const double small = std::min(std::abs(c), std::abs(s)) / std::max(std::abs(c), std::abs(s));
  double angle = small * (kPi / 4 + 0.273 * (1.0 - small));
  if (std::abs(s) > std::abs(c)) angle = kPi / 2 - angle;
  if (c < 0) angle = kPi - angle;
  if (s < 0) angle = -angle;
  for (int i = 0; i < 3; ++i) {
    const SinCos at = sin_cos(angle);
    angle += s * at.cos - c * at.sin;
  }
  return angle;
}

}  // namespace coaster::base
