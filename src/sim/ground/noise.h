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

// Noise with cells of 1 m, -1..1, twice continuously differentiable.
inline double noise(double x, double z, std::uint32_t seed) {
  const double left = std::floor(x), low = std::floor(z);
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double u = fade(x - left), v = fade(z - low);
  const auto i = static_cast<std::int32_t>(left), j = static_cast<std::int32_t>(low);
  return 2 * mixed(mixed(random_at(i, j, seed), random_at(i + 1, j, seed), u),
                   mixed(random_at(i, j + 1, seed), random_at(i + 1, j + 1, seed), u), v) -
         1;
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
