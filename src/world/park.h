// The park: the land that a coaster stands on. The document stores what people decided (land, seed, strokes of
// brushes); the ground as it is cut to the track, tunnels and trees follow from document and track (sim/ground).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "base/enum_names.h"

namespace coaster::world {

// The lands. `plain` is the level plane y = 0, without a park.
enum class Land : std::uint8_t { plain, meadow, hills, valley, cliffs, island, desert, snow };

struct LandRow {
  std::string_view name, label, help;
  std::string_view in_file;  // with the version of its formulas; a changed land gets a new one
  double water, woods;       // usual values of Park's members
};
inline constexpr double kNoWater = -1000;  // m, a water level below all land
inline constexpr LandRow kLands[] = {
    {"plain", "Plain", "A level lawn, without a park.", "plain", kNoWater, 0},
    {"meadow", "Meadow", "Gentle ground with ponds.", "meadow-1", -1.2, 0.35},
    {"hills", "Hills", "Rolling ground within wooded hills, with a lake.", "hills-1", -1.2, 0.6},
    {"valley", "Valley", "Steep hills on both sides of a river.", "valley-1", -1.2, 0.75},
    {"cliffs", "Cliffs", "Terraces of rock above a lake.", "cliffs-1", -1.2, 0.5},
    {"island", "Island", "Hills and sand, with the sea around them.", "island-1", -1.2, 0.5},
    {"desert", "Desert", "Sand and terraces of red rock.", "desert-1", kNoWater, 0.1},
    {"snow", "Snow", "Snowy hills with conifers and a lake.", "snow-1", -1.2, 0.6}};
constexpr std::span<const LandRow> rows_of(Land) { return kLands; }

inline constexpr double kGroundCell = 2;       // m, side of a cell of the ground
inline constexpr int kGroundTileCells = 32;    // cells along a tile's side
inline constexpr int kGroundTilesAcross = 24;  // tiles along the side of the largest square, centred on the origin
inline constexpr double kGroundSquare = kGroundTilesAcross * kGroundTileCells * kGroundCell;  // m, 1,536
inline constexpr double kHeightStep = 1.0 / 32;                                               // m
inline constexpr double kHighestGround = 1000;                                                // m, either way
inline constexpr double kMaxRelief = 3, kHighestWater = 200, kLowestWater = kNoWater;

// A tile that a brush has touched. Its vertices are 32x32: those at the lower sides of its cells.
struct GroundTile {
  static constexpr int kVertices = kGroundTileCells * kGroundTileCells;
  static constexpr int kWoods = kVertices / 4;
  static constexpr std::int16_t kSeeded = INT16_MIN;  // a vertex that no brush has moved
  std::array<std::int16_t, kVertices> heights;        // in kHeightStep, rows along x
  std::array<std::uint8_t, kWoods> woods{};           // by cells of 4 m: 0 as seeded, 1 none, to 255 dense
  GroundTile() { heights.fill(kSeeded); }
  bool empty() const { return *this == GroundTile(); }
  friend bool operator==(const GroundTile&, const GroundTile&) = default;
};

// The column and the row of a tile: tile (0, 0) begins at the origin.
struct TilePlace {
  std::int16_t x = 0, z = 0;
  friend auto operator<=>(const TilePlace&, const TilePlace&) = default;
};
inline bool in_square(TilePlace place) {
  constexpr int kHalf = kGroundTilesAcross / 2;
  return place.x >= -kHalf && place.x < kHalf && place.z >= -kHalf && place.z < kHalf;
}

// The tiles that brushes have touched. A copy shares them: a changed tile is copied, the others are not.
class GroundTiles {
 public:
  using Map = std::map<TilePlace, std::shared_ptr<const GroundTile>>;
  const Map& map() const;
  bool empty() const { return !tiles_; }
  const GroundTile* find(TilePlace place) const;  // null: untouched
  // Replaces tiles, each within the square; one that holds nothing is taken out.
  void put(std::span<const std::pair<TilePlace, GroundTile>> tiles);
  std::size_t bytes() const { return map().size() * (sizeof(GroundTile) + 64); }
  friend bool operator==(const GroundTiles& a, const GroundTiles& b);

 private:
  std::shared_ptr<const Map> tiles_;  // null: none
};

struct Park {
  Land land = Land::plain;
  std::uint32_t seed = 7;
  double relief = 1;        // factor of heights, 0..kMaxRelief
  double woods = 0;         // 0..1, how much of the land is wooded
  double water = kNoWater;  // m, level of lakes and seas
  GroundTiles tiles;        // none without a land
  bool plain() const { return land == Land::plain; }
  friend bool operator==(const Park&, const Park&) = default;
};
// Returns a land with its usual water and woods.
Park usual_park(Land land, std::uint32_t seed);

}  // namespace coaster::world
