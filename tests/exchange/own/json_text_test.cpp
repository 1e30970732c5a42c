// Printed JSON.
#include "exchange/own/json.h"

#include <gtest/gtest.h>

namespace coaster::exchange {
namespace json_text_test {

TEST(json_text, a_file_has_its_members_in_their_order_on_lines_of_their_own) {
  Json tree = Json::object();
  tree["name"] =
      "Stra\xc3\x9f"
      "e";
  tree["list"] = {1, 2.5};
  tree["empty"] = Json::object();
  EXPECT_EQ(json_file(tree),
            "{\n  \"name\": \"Stra\xc3\x9f"
            "e\",\n  \"list\": [\n    1,\n    2.5\n  ],\n  \"empty\": {}\n}\n");
  EXPECT_EQ(json_file(tree["list"], 0), "[\n1,\n2.5\n]\n");
  EXPECT_EQ(json_line(tree),
            "{\"name\":\"Stra\xc3\x9f"
            "e\",\"list\":[1,2.5],\"empty\":{}}");
}

TEST(json_text, what_is_no_utf8_is_replaced_and_the_rest_reads_back) {
  EXPECT_EQ(json_string("a\"\n\x01"), "\"a\\\"\\n\\u0001\"");
  EXPECT_EQ(json_string("a\xff"
                        "b"),
            "\"a\xEF\xBF\xBD"
            "b\"");
  Json tree;
  tree["a\xff"] = "\xc3";
  for (const std::string& text : {json_file(tree), json_line(tree)}) {
    const auto back = read_json(text, "text");
    ASSERT_TRUE(back) << back.status().message;
    EXPECT_EQ(back->begin().key(), "a\xEF\xBF\xBD");
    EXPECT_EQ(back->begin()->get<std::string>(), "\xEF\xBF\xBD");
  }
}

}  // namespace json_text_test
}  // namespace coaster::exchange
