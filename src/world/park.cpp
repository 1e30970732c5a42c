#include "world/park.h"

#include <algorithm>

#include "base/check.h"

namespace coaster::world {

const GroundTiles::Map& GroundTiles::map() const {
  static const Map kNone;
  return tiles_ ? *tiles_ : kNone;
}

const GroundTile* GroundTiles::find(TilePlace place) const {
  const auto found = map().find(place);
  return found == map().end() ? nullptr : found->second.get();
}

void GroundTiles::put(std::span<const std::pair<TilePlace, GroundTile>> tiles) {
  auto changed = std::make_shared<Map>(map());
  for (const auto& [place, tile] : tiles) {
    COASTER_CHECK(in_square(place), "tiles lie within the square");
    if (tile.empty()) changed->erase(place);
    else (*changed)[place] = std::make_shared<const GroundTile>(tile);
  }
  tiles_ = changed->empty() ? nullptr : std::move(changed);
}

bool operator==(const GroundTiles& a, const GroundTiles& b) {
  if (a.tiles_ == b.tiles_) return true;
  return std::ranges::equal(a.map(), b.map(), [](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || *x.second == *y.second);
  });
}

Park usual_park(Land land, std::uint32_t seed) {
  if (land == Land::plain) return {};
  const LandRow& row = base::row_of(land);
  return {.land = land, .seed = seed, .woods = row.woods, .water = row.water, .tiles = {}};
}

}  // namespace coaster::world
