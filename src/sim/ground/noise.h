// Value noise and its sums over octaves: the base of lands and of what grows on them. Only + - * / and floor, in double
// precision, so that heights are the same bits on all machines.
#pragma once

#include <cmath>
#include <cstdint>

namespace coaster::sim {

// Returns a random number of a cell, 0 <= r < 1.
inline double random_at(std::int32_t x, std::int32_t z, std::uint32_t seed) {
  std::uint32_t bits =
      static_cast<std::uint32_t>(x) * 1597334677u ^ static_cast<std::uint32_t>(z) * 3812015801u ^ seed * 2654435769u;
  bits = (bits ^ (bits >> 15)) * 2246822519u;
  bits = (bits ^ (bits >> 13)) * 3266489917u;
  bits ^= bits >> 16;
  return (bits >> 8) * (1.0 / 16777216);
}

// Smooth steps from 0 at `a` to 1 at `b` (smoothstep), and a straight mix.
inline double smooth_step(double a, double b, double x) {
  const double t = std::fmin(std::fmax((x - a) / (b - a), 0.0), 1.0);
  return t * t * (3 - 2 * t);
}
inline double mixed(double a, double b, double t) { return a + (b - a) * t; }

// Gradient noise with cells of 1 m: about -1..1, 0 at the cells' corners, twice continuously differentiable.
inline double noise(double x, double z, std::uint32_t seed) {
  constexpr double kHalf = 0.70710678118654752;  // of a right angle: its sine
  constexpr double kGradients[][2] = {{1, 0},  {kHalf, kHalf},   {0, 1},  {-kHalf, kHalf},
                                      {-1, 0}, {-kHalf, -kHalf}, {0, -1}, {kHalf, -kHalf}};
  const double left = std::floor(x), low = std::floor(z), p = x - left, q = z - low;
  const auto i = static_cast<std::int32_t>(left), j = static_cast<std::int32_t>(low);
  const auto at = [&](std::int32_t di, std::int32_t dj) {
    const double* const g = kGradients[static_cast<int>(8 * random_at(i + di, j + dj, seed))];
    return g[0] * (p - di) + g[1] * (q - dj);
  };
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double u = fade(p), v = fade(q);
  return 1.5 * mixed(mixed(at(0, 0), at(1, 0), u), mixed(at(0, 1), at(1, 1), u), v);
}

// The sum of octaves of half the height and half the width each, turned against each other: about -1..1.
inline double octaves(int count, double x, double z, std::uint32_t seed) {
  double sum = 0, height = 0.5;
  for (int i = 0; i < count; ++i, height *= 0.5) {
    sum += height * noise(x, z, seed + static_cast<std::uint32_t>(i));
    const double turned = 1.6 * x - 1.2 * z;
    z = 1.2 * x + 1.6 * z, x = turned;
  }
  return sum;
}

}  // namespace coaster::sim
