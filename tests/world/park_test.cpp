#include "world/park.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "world/document_difference.h"
#include "world/sample_documents.h"

namespace coaster::world {
namespace park_test {

using Tiles = std::vector<std::pair<TilePlace, GroundTile>>;

GroundTile tile_with(std::int16_t height, std::uint8_t woods = 0) {
  GroundTile tile;
  tile.heights[5] = height, tile.woods[9] = woods;
  return tile;
}
Document with_tiles(const Tiles& tiles) {
  Document document = test::sample_document();
  document.park = usual_park(Land::hills, 3);
  document.park.tiles.put(tiles);
  return document;
}

TEST(park, a_plain_land_is_no_park_whatever_its_seed) {
  EXPECT_TRUE(usual_park(Land::plain, 99) == Park());
  EXPECT_TRUE(Park().plain());
  for (std::size_t i = 1; i < base::count_of<Land>(); ++i) {
    const Park park = usual_park(static_cast<Land>(i), 99);
    EXPECT_FALSE(park.plain());
    EXPECT_EQ(park.seed, 99u);
    EXPECT_EQ(park.water, base::row_of(park.land).water);
    EXPECT_EQ(park.woods, base::row_of(park.land).woods);
  }
}

TEST(park, the_square_has_24_tiles_across_about_the_origin) {
  EXPECT_TRUE(in_square({-12, -12}));
  EXPECT_TRUE(in_square({11, 11}));
  for (const TilePlace place : {TilePlace{-13, 0}, {12, 0}, {0, -13}, {0, 12}}) EXPECT_FALSE(in_square(place));
}

TEST(park, copies_share_tiles_and_a_change_copies_only_what_it_changes) {
  GroundTiles tiles;
  EXPECT_TRUE(tiles.empty());
  EXPECT_EQ(tiles.find({0, 0}), nullptr);
  tiles.put(Tiles{{{0, 0}, tile_with(4)}, {{1, -2}, tile_with(7)}});
  GroundTiles copy = tiles;
  EXPECT_EQ(&copy.map(), &tiles.map());
  copy.put(Tiles{{{0, 0}, tile_with(5)}});
  EXPECT_EQ(tiles.find({0, 0})->heights[5], 4);
  EXPECT_EQ(copy.find({0, 0})->heights[5], 5);
  EXPECT_EQ(copy.find({1, -2}), tiles.find({1, -2}));
  EXPECT_FALSE(copy == tiles);
  copy.put(Tiles{{{0, 0}, tile_with(4)}});
  EXPECT_TRUE(copy == tiles) << "the contents count";
  copy.put(Tiles{{{0, 0}, GroundTile()}, {{1, -2}, GroundTile()}});
  EXPECT_TRUE(copy.empty()) << "tiles that hold nothing are taken out";
  EXPECT_TRUE(copy == GroundTiles());
}

TEST(park, every_value_of_it_is_in_the_hash) {
  const Document plain = test::sample_document(), document = with_tiles({{{0, 0}, tile_with(4, 2)}});
  std::vector<Document> all{plain, document};
  const auto other = [&](auto change) {
    all.push_back(document);
    change(all.back().park);
  };
  other([](Park& park) { park.land = Land::snow; });
  other([](Park& park) { park.seed = 4; });
  other([](Park& park) { park.relief = 2; });
  other([](Park& park) { park.woods = 0.1; });
  other([](Park& park) { park.water = kNoWater; });
  other([](Park& park) { park.tiles = {}; });
  other([](Park& park) { park.tiles.put(Tiles{{{0, 0}, tile_with(5, 2)}}); });
  other([](Park& park) { park.tiles.put(Tiles{{{0, 0}, tile_with(4, 3)}}); });
  other([](Park& park) { park.tiles.put(Tiles{{{0, 1}, tile_with(4, 2)}}); });
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(hash(all[i]), hash(all[j])) << i << " " << j;
}

TEST(park, limits_are_invariants) {
  Document document = with_tiles({{{0, 0}, tile_with(32000)}});
  EXPECT_EQ(broken_invariant(document), std::nullopt);
  const auto broken = [&](auto change) {
    Document wrong = document;
    change(wrong.park);
    return broken_invariant(wrong).has_value();
  };
  EXPECT_TRUE(broken([](Park& park) { park.land = Land::plain; }));
  EXPECT_TRUE(broken([](Park& park) { park.relief = 3.1; }));
  EXPECT_TRUE(broken([](Park& park) { park.relief = std::nan(""); }));
  EXPECT_TRUE(broken([](Park& park) { park.woods = -0.1; }));
  EXPECT_TRUE(broken([](Park& park) { park.water = 201; }));
  EXPECT_TRUE(broken([](Park& park) { park.tiles.put(Tiles{{{3, 3}, tile_with(32001)}}); }));
}

TEST(park, an_undo_step_counts_the_tiles_that_it_alone_holds) {
  const Document none = with_tiles({});
  Document one = none;
  one.park.tiles.put(Tiles{{{0, 0}, tile_with(4)}});
  Document two = one;
  two.park.tiles.put(Tiles{{{1, 0}, tile_with(4)}});
  Document other = two;
  other.park.tiles.put(Tiles{{{1, 0}, tile_with(9)}});
  DocumentDifference first = difference_of(none, one), second = difference_of(one, two),
                     third = difference_of(two, other), same = difference_of(other, other);
  const std::size_t least = bytes_of(same);
  constexpr std::size_t kList = 200;  // bytes of entries
  EXPECT_EQ(bytes_of(first), least);
  EXPECT_LT(bytes_of(second), least + kList) << "the tile of the first is shared";
  EXPECT_GT(bytes_of(third), least + sizeof(GroundTile));
  EXPECT_LT(bytes_of(third), least + sizeof(GroundTile) + kList);
  Document document = one;
  exchange(first, document);
  EXPECT_TRUE(document == none);
  EXPECT_GT(bytes_of(first), least + sizeof(GroundTile)) << "now the step holds the tile";
  exchange(first, document);
  EXPECT_TRUE(document == one);
  EXPECT_EQ(bytes_of(first), least);
}

}  // namespace park_test
}  // namespace coaster::world
