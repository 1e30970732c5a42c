// The curves of the benchmarks: track-like cubics of about ten metres within 140 m of the origin, and long circuits.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "curve/cubic.h"
#include "world/topology.h"

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

// Returns a closed circuit with hills, ten metres per segment, with one train: as many loops away from a centre and
// back as keep its bends wide and, with 100,000 segments, the whole track within 20 km.
inline world::Document circuit(int segments) {
  constexpr double kTurn = 6.283185307179586;
  constexpr int kSamples = 4000;  // per loop
  const int loops = std::max(3, static_cast<int>(std::lround(31 * std::sqrt(segments / 1e5))));
  const auto plan = [&](double angle) {
    const double r = 1 + 0.8 * std::cos(loops * angle);
    return glm::dvec2(r * std::cos(angle), r * std::sin(angle));
  };
  std::vector<double> along{0.0};
  for (int i = 1; i <= loops * kSamples; ++i)
    along.push_back(along.back() +
                    glm::length(plan(kTurn * i / (loops * kSamples)) - plan(kTurn * (i - 1) / (loops * kSamples))));
  const double scale = 10.0 * segments / along.back();
  std::vector<glm::dvec3> places;
  for (int i = 0; i < segments; ++i) {
    const double wanted = along.back() * i / segments;
    const auto above = std::upper_bound(along.begin(), along.end(), wanted);
    const double part = (wanted - *(above - 1)) / (*above - *(above - 1));
    const glm::dvec2 at =
        scale * plan(kTurn * (static_cast<double>(above - along.begin() - 1) + part) / (loops * kSamples));
    const double height = 20 + 8 * std::sin(kTurn * std::lround(segments / 25.0) * i / segments);
    places.emplace_back(at.x, height, at.y);
  }
  world::Document document;
  for (int i = 0; i < segments; ++i) {
    world::Knot knot;
    knot.position = glm::vec3(places[static_cast<std::size_t>(i)]);
    knot.in_length = knot.out_length = 3.33f;
    const auto next = static_cast<std::size_t>((i + 1) % segments),
               last = static_cast<std::size_t>((i + segments - 1) % segments);
    world::set_tangent(knot, glm::vec3(places[next] - places[last]));
    world::append_knot(document, knot);
  }
  world::set_closed(document, true);
  world::add_cart(document, document.track.segments.front(), 0);
  return document;
}

inline double checksum(const glm::vec3* points, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += points[i].x + 2.0 * points[i].y + 3.0 * points[i].z;
  return sum;
}

}  // namespace coaster::bench
