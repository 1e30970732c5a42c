// The land as people left it: a seeded land with the strokes of brushes, before it is cut to the track. Plans, drops
// and snapping ask it, so that planning twice gives the same bits.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "world/document.h"

namespace coaster::sim {

// The side of a grid's cell, and the vertices (column, row) of that grid: vertex (0, 0) is at the origin.
struct GroundVertex {
  int x = 0, z = 0;
};
// Where the tiles of a park hold a vertex: indices into the members of a GroundTile. `woods` is of the cell of woods
// whose lower sides it is at or beyond.
struct TileVertex {
  world::TilePlace tile;
  std::size_t height, woods;
};
TileVertex tile_vertex(GroundVertex at);

// Returns the height at a place of a grid of vertices. Each cell is two triangles, divided by the diagonal with the
// smaller difference of heights, as it is drawn.
double height_between(double x, double z, auto&& vertex_height);

class Land {
 public:
  Land() = default;  // plain
  explicit Land(const world::Park& park) : park_(park) {}

  bool plain() const { return park_.plain(); }
  const world::Park& park() const { return park_; }
  // Returns the height (m) of a vertex of the grid of kGroundCell: that of a brush, else the seeded one. 0 if plain.
  double vertex(GroundVertex at) const;
  // Returns the height (m) at a place (x, z), on the triangles between the vertices; about a microsecond.
  double height(double x, double z) const;
  // Returns the seeded height (m) at a place, a smooth function of it; farther out than the square it falls to 0.
  double seeded(double x, double z) const;

  // Returns the height (m) of what one sees from above: land or water.
  double surface(double x, double z) const { return std::fmax(height(x, z), park_.plain() ? 0.0 : park_.water); }
  // Returns `over` m above the surface, where new track begins: in whole kHeightStep, so that a knot keeps it exactly.
  double standing(double x, double z, double over) const;
  // Returns how deep (m) a point of the rails is where none may go: below the plane y = 0 if plain, else under water,
  // unless kLeastOverhead of earth keep it away as in a tunnel. Negative above; minus infinity where there is no water.
  double depth(glm::dvec3 rails) const;
  static constexpr double kLeastOverhead = 4.5;  // m
  // As Ground::meet(), of the surface; for each metre of the way about a microsecond.
  std::optional<double> meet(glm::dvec3 origin, glm::dvec3 direction, double most = 2000) const;

 private:
  world::Park park_;
};

inline double height_between(double x, double z, auto&& vertex_height) {
  const double u = x / world::kGroundCell, v = z / world::kGroundCell;
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  const double p = u - i, q = v - j;
  const double a = vertex_height(GroundVertex{i, j}), b = vertex_height(GroundVertex{i + 1, j}),
               c = vertex_height(GroundVertex{i, j + 1}), d = vertex_height(GroundVertex{i + 1, j + 1});
  if (std::fabs(a - d) <= std::fabs(b - c))  // the diagonal from a to d
    return p >= q ? a + (b - a) * p + (d - b) * q : a + (d - c) * p + (c - a) * q;
  return p + q <= 1 ? a + (b - a) * p + (c - a) * q : d + (c - d) * (1 - p) + (b - d) * (1 - q);
}

// Returns the distance (m) at which a ray from `origin` along the unit `direction` first meets the heights, at most
// `most`; nothing if it does not, or begins below them. Misses what rises above the ray for less than a step.
std::optional<double> meet_heights(glm::dvec3 origin, glm::dvec3 direction, double most, auto&& height) {
  const auto over = [&](double t) {
    const glm::dvec3 p = origin + t * direction;
    return p.y - height(p.x, p.z);
  };
  double margin = over(0), before = 0;
  if (margin < 0) return std::nullopt;
  for (double t = 0; t < most; before = t) {
    // Steps of half a cell near the eye, longer far away and high above all land.
    t = std::fmin(t + std::fmax(0.5 * world::kGroundCell * (1 + t / 200), 0.25 * margin), most);
    margin = over(t);
    if (margin >= 0) continue;
    for (double low = before, high = t;;) {
      const double middle = 0.5 * (low + high);
      if (high - low < 1e-5 || middle <= low || middle >= high) return high;
      (over(middle) >= 0 ? low : high) = middle;
    }
  }
  return std::nullopt;
}

}  // namespace coaster::sim
