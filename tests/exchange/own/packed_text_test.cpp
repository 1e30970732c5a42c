// Text packed for addresses.
#include "exchange/own/share_link.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace coaster::exchange {
namespace packed_text_test {

constexpr std::size_t kMost = 1 << 20;

std::string why(std::string_view packed, std::size_t most = kMost) {
  const auto text = unpack(packed, most);
  return text ? "no error" : text.status().message;
}

// Packed by Python 3.11: base64.urlsafe_b64encode(zlib.compressobj(9, zlib.DEFLATED, -15) ...).rstrip(b"=").
TEST(packed_text, another_program_s_text_is_read) {
  EXPECT_EQ(*unpack("AwA", kMost), "");
  EXPECT_EQ(*unpack("SwQA", kMost), "a");
  EXPECT_EQ(*unpack("S85PLC5JLdJRSEZjcAEA", kMost), "coaster, coaster, coaster\n");
  EXPECT_EQ(*unpack("AQMA_P9hYmM", kMost), "abc") << "a block that is stored, not compressed";
}

RC_GTEST_PROP(packed_text, what_is_packed_unpacks_to_the_same, ()) {
  const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
  const std::string packed = pack(bytes);
  RC_ASSERT(packed.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_") ==
            std::string::npos);
  const auto text = unpack(packed, bytes.size());
  RC_ASSERT(text.ok());
  RC_ASSERT(*text == bytes);
}

TEST(packed_text, every_truncation_is_an_error) {
  const std::string packed = pack("no text of this length packs into fewer characters, 0123456789");
  for (std::size_t length = 0; length + 1 < packed.size(); ++length)
    EXPECT_EQ(why(packed.substr(0, length)), "it is cut off") << length;
}

TEST(packed_text, other_characters_are_named_by_their_place) {
  EXPECT_EQ(why("AwA="), "character 4 is none of A-Z, a-z, 0-9, - and _");
  EXPECT_EQ(why(" AwA"), "character 1 is none of A-Z, a-z, 0-9, - and _");
  EXPECT_EQ(why("Aw+"), "character 3 is none of A-Z, a-z, 0-9, - and _");
}

TEST(packed_text, what_follows_the_end_is_damage) {
  EXPECT_EQ(why(pack("text") + "AAAA"), "it is damaged");
  EXPECT_EQ(why("BwA"), "it is damaged") << "a block of the kind that deflate does not have";
}

TEST(packed_text, a_bomb_stops_at_the_limit) {
  const std::string bomb = pack(std::string(std::size_t{65} << 20, '\0'));
  EXPECT_LT(bomb.size(), std::size_t{100'000});
  EXPECT_EQ(why(bomb, std::size_t{64} << 20), "it unpacks to more than 67108864 bytes");
  const std::string text(100'000, 'x');
  EXPECT_EQ(why(pack(text), 99'999), "it unpacks to more than 99999 bytes");
  EXPECT_EQ(why(pack(text), 100'000), "no error");
}

}  // namespace packed_text_test
}  // namespace coaster::exchange
