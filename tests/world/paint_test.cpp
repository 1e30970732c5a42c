#include "world/paint.h"

#include <set>

#include <gtest/gtest.h>

#include "world/coaster_kind.h"
#include "world/document.h"

namespace coaster::world {
namespace paint_test {

TEST(paint, colours_are_read_as_they_are_written) {
  for (const std::int32_t rgb : {-1, 0, 1, 0x0000ff, 0x00ff00, 0xd9452f, 0xffffff}) {
    const auto read = parse_colour(to_text(Colour{rgb}));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->rgb, rgb);
  }
  EXPECT_EQ(to_text(Colour{0x00070f}), "#00070f");
  EXPECT_EQ(parse_colour("#D9452F"), Colour{0xd9452f});
  for (const char* wrong : {"", "#", "red", "#d9452", "#d9452ff", "d9452f7", "#d9452g", "# d9452", "OWN"})
    EXPECT_FALSE(parse_colour(wrong)) << wrong;
}

TEST(paint, palettes_differ_and_are_known_by_their_colours) {
  EXPECT_EQ(base::count_of<Palette>(), 13u) << "twelve and the kind's own";
  for (std::size_t i = 0; i < std::size(kPalettes); ++i) {
    EXPECT_EQ(palette_of(kPalettes[i].paint), static_cast<Palette>(i)) << kPalettes[i].name;
    for (const Colour Paint::*const member : Paint::kMembers)
      EXPECT_EQ((kPalettes[i].paint.*member).own(), i > 0) << kPalettes[i].name;
  }
  Paint of_section = kPalettes[3].paint;
  of_section.train = {};
  EXPECT_EQ(palette_of(of_section), static_cast<Palette>(3));
  of_section.spine = {};
  EXPECT_FALSE(palette_of(of_section));
  Paint mixed = kPalettes[2].paint;
  mixed.rails = {0x123456};
  EXPECT_FALSE(palette_of(mixed));
}

TEST(paint, a_section_shows_the_tracks_paint_where_it_has_none) {
  const Paint track{{1}, {2}, {3}, {4}};
  EXPECT_EQ(over({}, track), track);
  EXPECT_EQ(over({{9}, {}, {8}, {}}, track), (Paint{{9}, {2}, {8}, {4}}));
}

TEST(paint, of_black_is_a_colour_and_counts_in_the_hash) {
  Document plain, black;
  black.paint.rails = {0};
  EXPECT_TRUE(black.paint.rails.own());
  EXPECT_NE(hash(plain), hash(black));
  std::set<std::uint64_t> hashes{hash(plain)};
  for (std::size_t kind = 1; kind < base::count_of<CoasterKind>(); ++kind) {
    plain.kind = static_cast<CoasterKind>(kind);
    EXPECT_TRUE(hashes.insert(hash(plain)).second) << kind;
  }
}

}  // namespace paint_test
}  // namespace coaster::world
