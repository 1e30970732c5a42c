#include "sim/ground/brush.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

using world::GroundTile;

// Vertices of the square are from -kHalf to kHalf - 1.
constexpr int kHalf = world::kGroundTilesAcross / 2 * world::kGroundTileCells;

// Whole numbers from `low` to `high`.
struct VertexRange {
  int low, high;
};
// The vertices within `radius` m of a stretch from a to b along one axis, and within the square.
VertexRange vertices_near(double a, double b, double radius, double cell, int half) {
  const double low = std::ceil((std::fmin(a, b) - radius) / cell), high = std::floor((std::fmax(a, b) + radius) / cell);
  return {static_cast<int>(std::fmax(low, -half)), static_cast<int>(std::fmin(high, half - 1))};
}

// The tiles that a stroke changes.
class TouchedTiles {
 public:
  explicit TouchedTiles(const Land& land) : land_(land) {}

  // `before`: the vertex's height.
  void set_height(GroundVertex at, double before, double height) {
    const double steps =
        std::floor(std::clamp(height, -world::kHighestGround, world::kHighestGround) / world::kHeightStep + 0.5);
    if (std::fabs(steps * world::kHeightStep - before) < 0.5 * world::kHeightStep) return;
    const TileVertex in = tile_vertex(at);
    tile(in.tile).heights[in.height] = static_cast<std::int16_t>(steps);
  }
  void set_woods(GroundVertex at, std::uint8_t to) {
    const TileVertex in = tile_vertex(at);
    const GroundTile* const held = land_.park().tiles.find(in.tile);
    if ((held ? held->woods[in.woods] : 0) != to) tile(in.tile).woods[in.woods] = to;
  }

  world::GroundTiles finish() const {
    world::GroundTiles all = land_.park().tiles;
    const std::vector<std::pair<world::TilePlace, GroundTile>> changed(tiles_.begin(), tiles_.end());
    if (!changed.empty()) all.put(changed);
    return all;
  }

 private:
  GroundTile& tile(world::TilePlace place) {
    const auto found = tiles_.find(place);
    if (found != tiles_.end()) return found->second;
    const GroundTile* const held = land_.park().tiles.find(place);
    return tiles_.emplace(place, held ? *held : GroundTile()).first->second;
  }
  const Land& land_;
  std::map<world::TilePlace, GroundTile> tiles_;
};

// How much of a stroke reaches a distance, in radii: all of it up to the middle part, nothing at the rim.
double share(double radii) { return 1 - smooth_step(0.35, 1, radii); }

// Calls visit(vertex, share) for the vertices within `radius` of the stretch from `a` to `b`, with the part of the way
// from a to b that is next to it.
void each_vertex(glm::dvec2 a, glm::dvec2 b, double radius, auto visit) {
  const VertexRange columns = vertices_near(a.x, b.x, radius, world::kGroundCell, kHalf),
                    rows = vertices_near(a.y, b.y, radius, world::kGroundCell, kHalf);
  const glm::dvec2 along = b - a;
  const double square = along.x * along.x + along.y * along.y;
  for (int z = rows.low; z <= rows.high; ++z) {
    for (int x = columns.low; x <= columns.high; ++x) {
      const glm::dvec2 out = world::kGroundCell * glm::dvec2(x, z) - a;
      const double way = square > 0 ? std::clamp((out.x * along.x + out.y * along.y) / square, 0.0, 1.0) : 0.0;
      const glm::dvec2 beside = out - way * along;
      const double radii = std::sqrt(beside.x * beside.x + beside.y * beside.y) / radius;
      if (radii < 1) visit(GroundVertex{x, z}, share(radii), way);
    }
  }
}

// Gives each vertex of each_vertex() the height `to(before, share, way)`; `before`: the one that it has.
world::GroundTiles shaped(const Land& land, glm::dvec2 a, glm::dvec2 b, double radius, const auto& to) {
  TouchedTiles touched(land);
  each_vertex(a, b, radius, [&](GroundVertex at, double share, double way) {
    const double before = land.vertex(at);
    touched.set_height(at, before, to(before, share, way));
  });
  return touched.finish();
}

}  // namespace

world::GroundTiles raised(const Land& land, Brush brush, double by) {
  return shaped(land, brush.at, brush.at, brush.radius,
                [&](double before, double share, double) { return before + share * by; });
}

world::GroundTiles smoothed(const Land& land, Brush brush) {
  // The mean of a square of vertices, wider under larger brushes; heights are found once.
  const int wide = std::clamp(static_cast<int>(brush.radius / 10), 1, 4);
  const double reach = brush.radius + wide * world::kGroundCell;
  const VertexRange columns = vertices_near(brush.at.x, brush.at.x, reach, world::kGroundCell, kHalf + wide),
                    rows = vertices_near(brush.at.y, brush.at.y, reach, world::kGroundCell, kHalf + wide);
  const int across = std::max(columns.high - columns.low + 1, 0);
  std::vector<double> heights;
  for (int z = rows.low; z <= rows.high; ++z)
    for (int x = columns.low; x <= columns.high; ++x) heights.push_back(land.vertex({x, z}));
  const auto height = [&](int x, int z) {
    x = std::clamp(x, columns.low, columns.high), z = std::clamp(z, rows.low, rows.high);
    return heights[static_cast<std::size_t>((z - rows.low) * across + x - columns.low)];
  };
  TouchedTiles touched(land);
  each_vertex(brush.at, brush.at, brush.radius, [&](GroundVertex at, double share, double) {
    double sum = 0;
    for (int z = at.z - wide; z <= at.z + wide; ++z)
      for (int x = at.x - wide; x <= at.x + wide; ++x) sum += height(x, z);
    const double mean = sum / ((2 * wide + 1) * (2 * wide + 1));
    const double before = height(at.x, at.z);
    touched.set_height(at, before, mixed(before, mean, share));
  });
  return touched.finish();
}

world::GroundTiles flattened(const Land& land, Brush brush, double to) {
  return shaped(land, brush.at, brush.at, brush.radius,
                [&](double before, double share, double) { return mixed(before, to, share); });
}

world::GroundTiles sloped(const Land& land, glm::dvec2 from, glm::dvec2 to, double radius) {
  const double first = land.height(from.x, from.y), last = land.height(to.x, to.y);
  return shaped(land, from, to, radius,
                [&](double before, double share, double way) { return mixed(before, mixed(first, last, way), share); });
}

world::GroundTiles wooded(const Land& land, Brush brush, std::optional<double> to) {
  constexpr double kCell = 2 * world::kGroundCell;
  constexpr std::uint32_t kRim = 41;  // seed of the ragged rim
  const std::uint8_t value =
      to ? static_cast<std::uint8_t>(1 + std::floor(254 * std::clamp(*to, 0.0, 1.0) + 0.5)) : std::uint8_t{0};
  const glm::dvec2 middle = brush.at - 0.5 * glm::dvec2(kCell);  // of cells, by their lower corners
  const VertexRange columns = vertices_near(middle.x, middle.x, brush.radius, kCell, kHalf / 2),
                    rows = vertices_near(middle.y, middle.y, brush.radius, kCell, kHalf / 2);
  TouchedTiles touched(land);
  for (int z = rows.low; z <= rows.high; ++z) {
    for (int x = columns.low; x <= columns.high; ++x) {
      const glm::dvec2 out = kCell * glm::dvec2(x, z) - middle;
      const double radii = std::sqrt(out.x * out.x + out.y * out.y) / brush.radius;
      if (radii < 1 && random_at(x, z, kRim) < 4 * (1 - radii)) touched.set_woods({2 * x, 2 * z}, value);
    }
  }
  return touched.finish();
}

}  // namespace coaster::sim
