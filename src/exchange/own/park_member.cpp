// A park is written in full: what a reader does not find has the land's usual value. A tile takes few bytes because
// heights are stored as differences from what their neighbours lead to expect, low bytes before high ones, and deflate
// does the rest.
#include "exchange/own/park_member.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/share_link.h"

namespace coaster::exchange {
namespace {

using world::GroundTile;

constexpr int kSide = world::kGroundTileCells, kHalf = world::kGroundTilesAcross / 2;
constexpr int kHighest = static_cast<int>(world::kHighestGround / world::kHeightStep);
constexpr std::size_t kMask = GroundTile::kVertices / 8;  // bytes of a bit for each vertex: a brush has moved it
constexpr std::size_t kLargest = 2 + kMask + 2 * GroundTile::kVertices + GroundTile::kWoods;  // bytes of a tile
constexpr std::size_t kMostTiles = std::size_t{world::kGroundTilesAcross} * world::kGroundTilesAcross;

// Returns what the height of a vertex is expected to be from those before it, in the order of rows: on the plane
// through three neighbours, else as the neighbour, else as the one before.
int expected_height(const GroundTile& tile, std::size_t i, int before) {
  const auto at = [&](std::size_t back) { return int{tile.heights[i - back]}; };
  const bool has_left = i % kSide > 0 && at(1) != GroundTile::kSeeded;
  const bool has_up = i >= kSide && at(kSide) != GroundTile::kSeeded;
  if (has_left && has_up && at(kSide + 1) != GroundTile::kSeeded) return at(1) + at(kSide) - at(kSide + 1);
  return has_left ? at(1) : has_up ? at(kSide) : before;
}

// Small differences of either sign become small numbers.
std::uint16_t folded(int difference) {
  const auto wrapped = static_cast<std::int16_t>(static_cast<std::uint16_t>(difference));
  const auto twice = static_cast<std::uint16_t>(static_cast<std::uint16_t>(wrapped) << 1);
  return wrapped < 0 ? static_cast<std::uint16_t>(~twice) : twice;
}
int unfolded(std::uint16_t number) { return (number & 1) != 0 ? -(number >> 1) - 1 : number >> 1; }

void add_tile(std::string& bytes, world::TilePlace place, const GroundTile& tile) {
  bytes += static_cast<char>(place.x + kHalf);
  bytes += static_cast<char>(place.z + kHalf);
  std::array<unsigned char, kMask> mask{};
  std::string low, high;
  int before = 0;
  for (std::size_t i = 0; i < tile.heights.size(); ++i) {
    const int height = tile.heights[i];
    if (height == GroundTile::kSeeded) continue;
    mask[i / 8] = static_cast<unsigned char>(mask[i / 8] | 1u << i % 8);
    const std::uint16_t number = folded(height - expected_height(tile, i, before));
    low += static_cast<char>(number & 255), high += static_cast<char>(number >> 8);
    before = height;
  }
  for (const unsigned char part : mask) bytes += static_cast<char>(part);
  bytes += low + high;
  for (const std::uint8_t woods : tile.woods) bytes += static_cast<char>(woods);
}

// Takes tiles from bytes. Each function returns false where they end early.
class TileBytes {
 public:
  explicit TileBytes(std::string_view bytes) : bytes_(bytes) {}
  bool at_end() const { return bytes_.empty(); }

  bool take(world::TilePlace& place, GroundTile& tile) {
    std::string_view head, mask, low, high, woods;
    if (!take(2, head) || !take(kMask, mask)) return false;
    place = {static_cast<std::int16_t>(number(head[0]) - kHalf), static_cast<std::int16_t>(number(head[1]) - kHalf)};
    std::size_t count = 0;
    for (std::size_t i = 0; i < GroundTile::kVertices; ++i) count += moved(mask, i) ? 1 : 0;
    if (!take(count, low) || !take(count, high) || !take(GroundTile::kWoods, woods)) return false;
    int before = 0;
    for (std::size_t i = 0, next = 0; i < GroundTile::kVertices; ++i) {
      if (!moved(mask, i)) continue;
      const auto stored = static_cast<std::uint16_t>(number(low[next]) | number(high[next]) << 8);
      before =
          static_cast<std::int16_t>(static_cast<std::uint16_t>(expected_height(tile, i, before) + unfolded(stored)));
      tile.heights[i] = static_cast<std::int16_t>(before);
      in_limits_ = in_limits_ && before >= -kHighest && before <= kHighest;
      ++next;
    }
    for (std::size_t i = 0; i < woods.size(); ++i) tile.woods[i] = static_cast<std::uint8_t>(woods[i]);
    return true;
  }
  bool in_limits() const { return in_limits_; }

 private:
  static int number(char c) { return static_cast<unsigned char>(c); }
  static bool moved(std::string_view mask, std::size_t i) { return (number(mask[i / 8]) >> i % 8 & 1) != 0; }
  bool take(std::size_t count, std::string_view& part) {
    if (bytes_.size() < count) return false;
    part = bytes_.substr(0, count), bytes_.remove_prefix(count);
    return true;
  }
  std::string_view bytes_;
  bool in_limits_ = true;
};

base::Status bad_tiles(std::string_view message) { return {base::Code::bad_file, std::string(message)}; }

bool read_tiles(JsonFieldReader& fields, world::GroundTiles& tiles) {
  std::string text;
  if (!fields.text("tiles", text)) return false;
  auto unpacked = unpack_tiles(text);
  if (!unpacked) return fields.fail("tiles", unpacked.status().message);
  tiles = std::move(*unpacked);
  return true;
}

bool read_number(JsonFieldReader& fields, std::string_view member, double& value, double low, double high) {
  if (!fields.has(member)) return true;
  if (!fields.number(member, value, low, high)) return false;
  if (value == 0) value = 0;  // not -0, which is printed as 0
  return true;
}

constexpr std::string_view kNone = "none";  // in place of the water's level

bool read_water(JsonFieldReader& fields, const Json& member, double& water) {
  if (!member.contains("water") || !member["water"].is_string())
    return read_number(fields, "water", water, world::kLowestWater, world::kHighestWater);
  std::string text;
  if (!fields.text("water", text)) return false;
  water = world::kNoWater;
  return text == kNone || fields.reject("water", "a number, or \"none\"");
}

}  // namespace

std::string pack_tiles(const world::GroundTiles& tiles) {
  std::string bytes;
  for (const auto& [place, tile] : tiles.map()) add_tile(bytes, place, *tile);
  return bytes.empty() ? bytes : pack(bytes);
}

base::Result<world::GroundTiles> unpack_tiles(std::string_view text) {
  world::GroundTiles tiles;
  if (text.empty()) return tiles;
  const base::Result<std::string> bytes = unpack(text, kMostTiles * kLargest);
  if (!bytes) return bytes.status();
  std::vector<std::pair<world::TilePlace, GroundTile>> read;
  for (TileBytes left(*bytes); !left.at_end();) {
    world::TilePlace place;
    GroundTile tile;
    if (!left.take(place, tile)) return bad_tiles("the last tile is cut off");
    if (!world::in_square(place)) return bad_tiles(fmt::format("tile ({}, {}) is outside the park", place.x, place.z));
    if (!read.empty() && !(read.back().first < place))
      return bad_tiles(fmt::format("tile ({}, {}) is out of order", place.x, place.z));
    if (!left.in_limits())
      return bad_tiles(
          fmt::format("a height of tile ({}, {}) is beyond {} m", place.x, place.z, world::kHighestGround));
    if (tile.empty()) return bad_tiles(fmt::format("tile ({}, {}) holds nothing", place.x, place.z));
    read.emplace_back(place, tile);
  }
  if (!read.empty()) tiles.put(read);
  return tiles;
}

std::string park_member(const world::Park& park) {
  const world::LandRow& row = base::row_of(park.land);
  std::string text = fmt::format("{{\"land\": \"{}\", \"seed\": {}", row.in_file, park.seed);
  if (park.relief != world::Park().relief) text += fmt::format(", \"relief\": {}", base::to_text(park.relief));
  if (park.woods != row.woods) text += fmt::format(", \"woods\": {}", base::to_text(park.woods));
  if (park.water != row.water)
    text += park.water == world::kNoWater ? fmt::format(", \"water\": \"{}\"", kNone)
                                          : fmt::format(", \"water\": {}", base::to_text(park.water));
  if (!park.tiles.empty()) text += fmt::format(", \"tiles\": \"{}\"", pack_tiles(park.tiles));
  return text + "}";
}

bool read_park(JsonFieldReader& fields, world::Park& park, std::vector<std::string>& warnings) {
  if (!fields.has("park")) return true;
  const Json* const object = fields.object("park");
  if (!object) return false;
  std::string error, land;
  JsonFieldReader member(*object, {"park"}, error);
  const auto failed = [&] { return fields.fail({}, error); };
  if (!member.text("land", land)) return failed();
  const auto* const row = std::ranges::find(world::kLands, land, &world::LandRow::in_file);
  if (row == world::kLands) return true;  // plain
  if (row == std::end(world::kLands)) {
    warnings.push_back(fmt::format("park.land: this program does not know {}: the land is plain", json_string(land)));
    fields.leave("park");
    return true;
  }
  world::Park read = world::usual_park(static_cast<world::Land>(row - world::kLands), park.seed);
  std::int64_t seed = read.seed;
  const bool good = (!member.has("seed") || member.whole("seed", seed, 0, std::numeric_limits<std::uint32_t>::max())) &&
                    read_number(member, "relief", read.relief, 0, world::kMaxRelief) &&
                    read_number(member, "woods", read.woods, 0, 1) && read_water(member, *object, read.water) &&
                    (!member.has("tiles") || read_tiles(member, read.tiles));
  if (!good) return failed();
  read.seed = static_cast<std::uint32_t>(seed);
  std::vector<std::string> unknown;
  (void)member.unknown(unknown);
  for (std::string& line : unknown) {
    constexpr std::string_view kKept = " is kept";
    line.replace(line.size() - kKept.size(), kKept.size(), " is lost when the track is saved");
    warnings.push_back(std::move(line));
  }
  park = std::move(read);
  return true;
}

void drop_member(world::UnknownMembers& kept, std::string_view member) {
  if (kept.json.empty()) return;
  base::Result<Json> tree = read_json(kept.json, "extra");
  if (!tree || !tree->is_object() || tree->erase(std::string(member)) == 0) return;
  kept.json = tree->empty() ? std::string() : json_line(*tree);
}

}  // namespace coaster::exchange
