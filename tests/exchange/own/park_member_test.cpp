#include "exchange/own/park_member.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "exchange/bad_file.h"
#include "exchange/own/share_link.h"
#include "exchange/own/track_file.h"
#include "sim/ground/brush.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace park_member_test {

using world::GroundTile;

world::Document in_a_park() {
  world::Document document = test::sample_document();
  document.park = world::usual_park(world::Land::hills, 7);
  return document;
}

// A park's text in place of the sample's one.
std::string with_park(const std::string& member) {
  std::string text = print_track(in_a_park());
  const std::string usual = R"({"land": "hills-1", "seed": 7})";
  const std::size_t at = text.find(usual);
  EXPECT_NE(at, std::string::npos) << text;
  return text.replace(at, usual.size(), member);
}
void expect_error(const std::string& member, std::string_view expected) {
  test::expect_bad_file(parse_track(with_park(member), "t.json"), "t.json", expected);
}
world::Document read(const std::string& text) {
  const auto loaded = parse_track(text, "t.json");
  EXPECT_TRUE(loaded) << loaded.status().message;
  EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
  return loaded ? loaded->document : world::Document();
}

// Tiles as a brush leaves them, with steep places, gaps and woods.
world::GroundTiles some_tiles(std::uint32_t seed) {
  std::mt19937 bits(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<int>(bits() % n); };
  std::vector<std::pair<world::TilePlace, GroundTile>> tiles;
  for (int i = 0, count = 1 + below(6); i < count; ++i) {
    GroundTile tile;
    const int kept = below(4);
    for (std::int16_t& height : tile.heights)
      if (below(4) >= kept) height = static_cast<std::int16_t>(below(2) == 0 ? below(64001) - 32000 : below(90) - 40);
    for (std::uint8_t& woods : tile.woods) woods = static_cast<std::uint8_t>(below(3) == 0 ? below(256) : 0);
    tile.heights[0] = static_cast<std::int16_t>(below(2) == 0 ? -32000 : 32000);
    tiles.emplace_back(
        world::TilePlace{static_cast<std::int16_t>(below(24) - 12), static_cast<std::int16_t>(below(24) - 12)}, tile);
  }
  world::GroundTiles all;
  all.put(tiles);
  return all;
}

TEST(park_member, a_document_without_a_park_is_written_as_before) {
  const std::string text = print_track(test::sample_document());
  EXPECT_EQ(text.find("park"), std::string::npos);
  EXPECT_EQ(version_of(test::sample_document()), 3);
  EXPECT_EQ(version_of(in_a_park()), 4);
}

TEST(park_member, what_is_usual_for_a_land_is_left_out) {
  world::Document document = in_a_park();
  EXPECT_EQ(park_member(document.park), R"({"land": "hills-1", "seed": 7})");
  document.park.relief = 1.5, document.park.woods = 0.25, document.park.water = world::kNoWater;
  EXPECT_EQ(park_member(document.park),
            R"({"land": "hills-1", "seed": 7, "relief": 1.5, "woods": 0.25, "water": "none"})");
  for (std::size_t i = 1; i < base::count_of<world::Land>(); ++i) {
    document.park = world::usual_park(static_cast<world::Land>(i), 4294967295u);
    for (const double water : {document.park.water, world::kNoWater, -3.25}) {
      document.park.water = water;
      const world::Document again = read(print_track(document));
      EXPECT_TRUE(again.park == document.park) << i;
      EXPECT_EQ(world::hash(again), world::hash(document));
    }
  }
  EXPECT_EQ(read(with_park(R"({"land": "snow-1"})")).park.seed, 7u);
  EXPECT_TRUE(read(with_park(R"({"land": "plain"})")).park == world::Park());
  EXPECT_FALSE(std::signbit(read(with_park(R"({"land": "hills-1", "relief": -0.0})")).park.relief));
}

TEST(park_member, tiles_come_back_the_same_from_files_and_links) {
  const int tries = test::tries(12);
  for (int seed = 0; seed < tries; ++seed) {
    world::Document document = in_a_park();
    document.park.tiles = some_tiles(static_cast<std::uint32_t>(seed));
    const std::string text = print_track(document);
    const world::Document again = read(text);
    EXPECT_TRUE(again.park == document.park) << seed;
    EXPECT_EQ(world::hash(again), world::hash(document));
    EXPECT_EQ(print_track(again), text);
    const auto linked = parse_link(print_link(document, {}));
    ASSERT_TRUE(linked) << linked.status().message;
    EXPECT_TRUE(linked->document.park == document.park);
  }
}

TEST(park_member, links_stay_short_for_a_seed_and_grow_with_strokes) {
  const std::size_t before = print_link(test::sample_document(), {}).size();
  world::Document document = in_a_park();
  EXPECT_LT(print_link(document, {}).size(), before + 70);
  for (int i = 0; i < 10; ++i) {
    const glm::dvec2 at(30 * i - 140, 17 * i - 90);
    document.park.tiles = sim::raised(sim::Land(document.park), {at, 24}, i % 2 == 0 ? 6 : -4);
  }
  // 10 strokes of 24 m touch some 25 tiles: about 7 KB.
  EXPECT_GT(pack_tiles(document.park.tiles).size(), 1000u);
  EXPECT_LT(pack_tiles(document.park.tiles).size(), 8000u);
}

TEST(park_member, values_beyond_their_limits_are_refused_with_their_place) {
  expect_error("3", "park: expected an object, found 3");
  expect_error("{}", "park.land: missing; expected a text");
  expect_error(R"({"land": 3})", "park.land: expected a text, found 3");
  expect_error(R"({"land": "hills-1", "seed": -1})", "park.seed: expected a whole number from 0 to 4294967295");
  expect_error(R"({"land": "hills-1", "seed": 4294967296})", "park.seed");
  expect_error(R"({"land": "hills-1", "seed": 1.5})", "park.seed");
  expect_error(R"({"land": "hills-1", "relief": 3.01})", "park.relief: expected a number from 0 to 3");
  expect_error(R"({"land": "hills-1", "relief": NaN})", "t.json:");
  expect_error(R"({"land": "hills-1", "relief": null})", "park.relief: expected a number");
  expect_error(R"({"land": "hills-1", "woods": -0.1})", "park.woods: expected a number from 0 to 1");
  expect_error(R"({"land": "hills-1", "water": 201})", "park.water: expected a number from -1000 to 200");
  expect_error(R"({"land": "hills-1", "water": "dry"})", "park.water: expected a number, or \"none\"");
  expect_error(R"({"land": "hills-1", "tiles": 3})", "park.tiles: expected a text, found 3");
  expect_error(R"({"land": "hills-1", "tiles": "?"})", "park.tiles: character 1 is none of");
}

// Packs tiles of one moved vertex each.
std::string tiles_at(std::initializer_list<std::pair<int, int>> places, int steps = 5) {
  std::string bytes;
  for (const auto& [x, z] : places) {
    bytes += static_cast<char>(x + 12), bytes += static_cast<char>(z + 12);
    bytes += '\1' + std::string(127, '\0');
    const int folded = steps < 0 ? -2 * steps - 1 : 2 * steps;
    bytes += static_cast<char>(folded & 255), bytes += static_cast<char>(folded >> 8);
    bytes += std::string(256, '\0');
  }
  return pack(bytes);
}

TEST(park_member, damaged_tiles_are_refused_with_the_reason) {
  const auto why = [](const std::string& text) {
    const auto tiles = unpack_tiles(text);
    return tiles ? std::string() : tiles.status().message;
  };
  EXPECT_EQ(why(tiles_at({{-12, -12}, {0, 3}, {11, 11}})), "");
  EXPECT_EQ(why(tiles_at({{12, 0}})), "tile (12, 0) is outside the park");
  EXPECT_EQ(why(tiles_at({{0, -13}})), "tile (0, 243) is outside the park") << "-1 is the byte 255";
  EXPECT_EQ(why(tiles_at({{1, 1}, {1, 1}})), "tile (1, 1) is out of order");
  EXPECT_EQ(why(tiles_at({{1, 1}, {0, 1}})), "tile (0, 1) is out of order");
  EXPECT_EQ(why(tiles_at({{0, 0}}, 32000)), "");
  EXPECT_EQ(why(tiles_at({{0, 0}}, 32001)), "a height of tile (0, 0) is beyond 1000 m");
  EXPECT_EQ(why(tiles_at({{0, 0}}, -32001)), "a height of tile (0, 0) is beyond 1000 m");
  EXPECT_EQ(why(pack(std::string("\14\14", 2) + std::string(128 + 256, '\0'))), "tile (0, 0) holds nothing");
  EXPECT_EQ(why(pack("abc")), "the last tile is cut off");
  EXPECT_EQ(why(pack(std::string(8 << 20, '\0'))), "it unpacks to more than 1401984 bytes") << "a bomb";
  const std::string good = tiles_at({{0, 0}});
  EXPECT_NE(why(good.substr(0, good.size() / 2)), "");
}

TEST(park_member, every_damage_of_a_byte_is_refused_or_gives_tiles_within_the_limits) {
  world::Document document = in_a_park();
  std::string bytes = *unpack(pack_tiles(some_tiles(3)), 1 << 22);
  std::mt19937 bits(5);
  for (int i = 0; i < test::tries(300); ++i) {
    std::string wrong = bytes;
    wrong[bits() % wrong.size()] = static_cast<char>(bits());
    const auto tiles = unpack_tiles(pack(wrong));
    if (!tiles) continue;
    document.park.tiles = *tiles;
    EXPECT_EQ(world::broken_invariant(document), std::nullopt);
    EXPECT_EQ(*unpack(pack_tiles(*tiles), 1 << 22), wrong) << "one text for each land";
  }
}

TEST(park_member, a_land_of_a_later_version_opens_plain_and_is_kept) {
  const std::string later = R"({"land":"hills-2","seed":3,"caves":[1]})";
  const auto loaded = parse_track(with_park(later), "t.json");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_TRUE(loaded->document.park.plain());
  ASSERT_EQ(loaded->warnings.size(), 2u);
  EXPECT_EQ(loaded->warnings[0],
            "t.json: warning: park.land: this program does not know \"hills-2\": the land is plain");
  EXPECT_EQ(loaded->warnings[1], "t.json: warning: unknown member \"park\" is kept");
  const std::string saved = print_track(loaded->document);
  EXPECT_NE(saved.find("\"park\": " + later), std::string::npos) << saved;
  world::Document document = loaded->document;
  drop_member(document.extra, "park");
  EXPECT_EQ(document.extra, test::sample_document().extra);
}

TEST(park_member, an_unknown_member_of_a_park_is_told_of) {
  const auto loaded = parse_track(with_park(R"({"land": "hills-1", "paths": []})"), "t.json");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(loaded->document.park.land, world::Land::hills);
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_EQ(loaded->warnings[0], "t.json: warning: park: unknown member \"paths\" is lost when the track is saved");
}

}  // namespace park_member_test
}  // namespace coaster::exchange
