// The curves of the benchmarks: track-like cubics of about ten metres within 140 m of the origin.
#pragma once

#include <random>
#include <vector>

#include "curve/cubic.h"

namespace coaster::bench {

inline std::vector<curve::PreparedCubic> track_cubics(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-80, 80), bend(-6, 6);
  std::vector<curve::PreparedCubic> all;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 p(place(random), place(random), place(random)), d(bend(random) + 10, bend(random), bend(random));
    const glm::vec3 e(bend(random) + 10, bend(random), bend(random));
    all.push_back(curve::prepare({p, p + d / 3.0f, p + d - e / 3.0f, p + d}));
  }
  return all;
}

inline double checksum(const glm::vec3* points, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += points[i].x + 2.0 * points[i].y + 3.0 * points[i].z;
  return sum;
}

}  // namespace coaster::bench
