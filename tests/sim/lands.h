// Lands of known shape for tests: all heights near the origin set by strokes of a brush.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "sim/ground/ground.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"

namespace coaster::test {

// Gives a document a land without water whose vertices within 128 m of the origin have the heights height(x, z), m.
inline void shape_land(world::Document& document, auto&& height) {
  document.park = world::usual_park(world::Land::meadow, 3);
  document.park.relief = 0, document.park.water = world::kNoWater;
  std::vector<std::pair<world::TilePlace, world::GroundTile>> tiles;
  for (std::int16_t z = -2; z < 2; ++z) {
    for (std::int16_t x = -2; x < 2; ++x) {
      world::GroundTile tile;
      for (int v = 0; v < world::GroundTile::kVertices; ++v) {
        const double i = world::kGroundCell * (x * 32 + v % 32), j = world::kGroundCell * (z * 32 + v / 32);
        tile.heights[static_cast<std::size_t>(v)] = static_cast<std::int16_t>(std::lround(32 * height(i, j)));
      }
      tiles.push_back({{x, z}, tile});
    }
  }
  document.park.tiles.put(tiles);
}

// A ridge `top` m high over |x| <= along, within 60 m in z, on level land.
inline auto ridge(double top, double along) {
  return [=](double x, double z) { return std::abs(x) <= along && std::abs(z) <= 60 ? top : 0.0; };
}

// A track and the ground as it is cut to it.
struct TrackOnLand {
  world::Document document;
  sim::DerivedTrack derived;
  sim::Ground ground;

  explicit TrackOnLand(world::Document d) : document(std::move(d)) { update(); }
  void update() {
    sim::derive(document, {}, {}, derived);
    ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
  }
};

}  // namespace coaster::test
