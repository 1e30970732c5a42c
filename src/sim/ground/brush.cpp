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

constexpr int kCells = world::kGroundTileCells, kWoodsCells = kCells / 2;
constexpr int kHalf = world::kGroundTilesAcross / 2 * kCells;  // vertices of the square from -kHalf to kHalf - 1

int tile_index(int index, int cells) { return index >= 0 ? index / cells : -((cells - 1 - index) / cells); }

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
    const int x = tile_index(at.x, kCells), z = tile_index(at.z, kCells);
    tile(x, z).heights[static_cast<std::size_t>((at.z - z * kCells) * kCells + at.x - x * kCells)] =
        static_cast<std::int16_t>(steps);
  }
  // `cell` counts cells of woods.
  void set_woods(GroundVertex cell, std::uint8_t to) {
    const int x = tile_index(cell.x, kWoodsCells), z = tile_index(cell.z, kWoodsCells);
    const auto i = static_cast<std::size_t>((cell.z - z * kWoodsCells) * kWoodsCells + cell.x - x * kWoodsCells);
    const GroundTile* const held = land_.park().tiles.find(place(x, z));
    if ((held ? held->woods[i] : 0) != to) tile(x, z).woods[i] = to;
  }

  world::GroundTiles finish() const {
    world::GroundTiles all = land_.park().tiles;
    const std::vector<std::pair<world::TilePlace, GroundTile>> changed(tiles_.begin(), tiles_.end());
    if (!changed.empty()) all.put(changed);
    return all;
  }

 private:
  static world::TilePlace place(int x, int z) { return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(z)}; }
  GroundTile& tile(int x, int z) {
    const auto found = tiles_.find(place(x, z));
    if (found != tiles_.end()) return found->second;
    const GroundTile* const held = land_.park().tiles.find(place(x, z));
    return tiles_.emplace(place(x, z), held ? *held : GroundTile()).first->second;
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

}  // namespace

world::GroundTiles raised(const Land& land, Brush brush, double by) {
  TouchedTiles touched(land);
  each_vertex(brush.at, brush.at, brush.radius, [&](GroundVertex at, double share, double) {
    const double before = land.vertex(at);
    touched.set_height(at, before, before + share * by);
  });
  return touched.finish();
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
  TouchedTiles touched(land);
  each_vertex(brush.at, brush.at, brush.radius, [&](GroundVertex at, double share, double) {
    const double before = land.vertex(at);
    touched.set_height(at, before, mixed(before, to, share));
  });
  return touched.finish();
}

world::GroundTiles sloped(const Land& land, glm::dvec2 from, glm::dvec2 to, double radius) {
  const double first = land.height(from.x, from.y), last = land.height(to.x, to.y);
  TouchedTiles touched(land);
  each_vertex(from, to, radius, [&](GroundVertex at, double share, double way) {
    const double before = land.vertex(at);
    touched.set_height(at, before, mixed(before, mixed(first, last, way), share));
  });
  return touched.finish();
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
      if (radii < 1 && random_at(x, z, kRim) < 4 * (1 - radii)) touched.set_woods({x, z}, value);
    }
  }
  return touched.finish();
}

}  // namespace coaster::sim
