// Keys of force sections on the clipboard.
#include "exchange/own/track_file.h"

#include <gtest/gtest.h>

namespace coaster::exchange {
namespace force_text_test {

TEST(force_text, copied_keys_are_read_as_they_were_written) {
  const CopiedForceKeys copied{world::ForceDomain::time, {{0.5, 1}, {2, 3.5, 0.1, 0.25, 0}, {60, -10}}};
  const std::string text = print_keys(copied);
  EXPECT_EQ(text, R"({"force-keys": "time", "keys": [[0.5, 1], [2, 3.5, 0.1, 0.25, 0], [60, -10]]})");
  const auto read = parse_keys(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->over, copied.over);
  EXPECT_EQ(read->keys, copied.keys);
}

TEST(force_text, keys_of_curvature_are_marked) {
  const CopiedForceKeys copied{world::ForceDomain::distance, {{2, 0.02}}, world::ForceQuantity::curvature};
  const std::string text = print_keys(copied);
  EXPECT_EQ(text, R"({"force-keys": "distance", "of": "curvature", "keys": [[2, 0.02]]})");
  const auto read = parse_keys(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->of, copied.of);
  EXPECT_TRUE(parse_keys(R"({"force-keys": "distance", "of": "curvature", "keys": [[2, 3000]]})")) << "degrees";
  EXPECT_FALSE(parse_keys(R"({"force-keys": "distance", "keys": [[2, 3000]]})"));
  EXPECT_FALSE(parse_keys(R"({"force-keys": "distance", "of": "shape", "keys": [[2, 0]]})"));
}

TEST(force_text, what_is_no_list_of_keys_is_refused_with_the_reason) {
  const auto refused = [](std::string_view text, std::string_view why) {
    const auto read = parse_keys(text);
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.status().message.find(why), std::string::npos) << read.status().message;
  };
  refused("", "clipboard");
  refused("words", "clipboard");
  refused("[]", "expected an object");
  refused(R"({"format": "coaster-track"})", "force-keys");
  refused(R"({"force-keys": "miles", "keys": [[0, 1]]})", "distance");
  refused(R"({"force-keys": "time"})", "keys");
  refused(R"({"force-keys": "time", "keys": []})", "no keys");
  refused(R"({"force-keys": "time", "keys": [[0]]})", "expected 2 or 5 numbers");
  refused(R"({"force-keys": "time", "keys": [[0, "1"]]})", "expected 2 or 5 numbers");
  refused(R"({"force-keys": "time", "keys": [[1, 0], [0, 0]]})", "roll");
  refused(R"({"force-keys": "time", "keys": [[0, 1e999]]})", "clipboard");
  std::string many = R"({"force-keys": "distance", "keys": [[0, 0])";
  for (int i = 1; i < 10'000; ++i) many += ", [" + std::to_string(i) + ", 0]";
  refused(many + "]}", "200");
}

}  // namespace force_text_test
}  // namespace coaster::exchange
