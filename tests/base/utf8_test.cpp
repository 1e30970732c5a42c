// UTF-8 text.
#include "base/text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace coaster::base {
namespace utf8_test {

TEST(utf8, a_character_has_one_to_four_bytes) {
  EXPECT_EQ(utf8_length("a"), 1u);
  EXPECT_EQ(utf8_length("\xc3\xa4rger"), 2u);
  EXPECT_EQ(utf8_length("\xe2\x82\xac"), 3u);
  EXPECT_EQ(utf8_length("\xf0\x9f\x8e\xa2!"), 4u);
  EXPECT_EQ(utf8_length(""), 0u);
}

TEST(utf8, what_is_ill_formed_is_no_character) {
  for (const char* text : {"\x80", "\xc3", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
                           "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xe2\x28\xac", "\xff"})
    EXPECT_EQ(utf8_length(text), 0u) << text;
}

TEST(utf8, every_code_point_but_surrogates_is_told_by_its_length) {
  for (std::uint32_t point = 0; point < 0x110000; ++point) {
    std::string text;
    if (point < 0x80) text = {char(point)};
    else if (point < 0x800) text = {char(0xc0 | point >> 6), char(0x80 | (point & 63))};
    else if (point < 0x10000)
      text = {char(0xe0 | point >> 12), char(0x80 | (point >> 6 & 63)), char(0x80 | (point & 63))};
    else
      text = {char(0xf0 | point >> 18), char(0x80 | (point >> 12 & 63)), char(0x80 | (point >> 6 & 63)),
              char(0x80 | (point & 63))};
    ASSERT_EQ(utf8_length(text), point >= 0xd800 && point < 0xe000 ? 0 : text.size()) << point;
  }
}

TEST(utf8, a_printable_text_stays_and_any_other_becomes_printable) {
  EXPECT_EQ(printable_utf8("Stra\xc3\x9f"
                           "e 7"),
            "Stra\xc3\x9f"
            "e 7");
  EXPECT_EQ(printable_utf8("a\tb\x7f"), "a_b_");
  EXPECT_EQ(printable_utf8("a\xe2\x82"), "a\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_FALSE(is_printable_utf8("a\n"));
  EXPECT_FALSE(is_printable_utf8("\xe2\x82"));
  EXPECT_TRUE(is_printable_utf8(""));
}

TEST(utf8, a_start_ends_with_a_whole_character) {
  const std::string text = "a\xc3\xa4\xe2\x82\xac";
  const std::size_t whole[] = {0, 1, 1, 3, 3, 3, 6, 6};
  for (std::size_t most = 0; most < std::size(whole); ++most)
    EXPECT_EQ(utf8_start(text, most), text.substr(0, whole[most])) << most;
}

RC_GTEST_PROP(Utf8, any_bytes_become_printable_once_and_for_all, (const std::string& bytes)) {
  const std::string printable = printable_utf8(bytes);
  RC_ASSERT(is_printable_utf8(printable));
  RC_ASSERT(printable_utf8(printable) == printable);
  RC_ASSERT(!is_printable_utf8(bytes) || printable == bytes);
}

}  // namespace utf8_test
}  // namespace coaster::base
