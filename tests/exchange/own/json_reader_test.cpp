// JSON text parsed into a tree.
#include "exchange/own/json.h"

#include <gtest/gtest.h>

namespace coaster::exchange {
namespace json_reader_test {

std::string error_of(std::string_view text) {
  const auto result = read_json(text, "f.json");
  return result ? "" : result.status().message;
}
bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(json_reader, good_text_becomes_a_tree_in_the_order_of_its_members) {
  const auto tree = read_json(R"( {"z": [1, -2.5, "ä\u00e9", null], "a": {"b": true}} )", "f.json");
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->dump(), R"({"z":[1,-2.5,"äé",null],"a":{"b":true}})");
}

TEST(json_reader, objects_in_lists_of_the_root_are_offered_once_and_leave_null_where_they_are_taken) {
  constexpr const char* kText = R"({"a": [{"x": [{"y": 1}]}, 7, {"x": 2}], "b": {"c": [{"z": 1}]}, "d": [[{"z": 2}]]})";
  std::string offered;
  const auto tree =
      read_json(kText, "f.json", [&](const Json& root, std::string_view list, std::size_t index, const Json& element) {
        EXPECT_EQ(&root.at(std::string(list)).at(index), &element);
        offered += std::string(list) + std::to_string(index) + element.dump();
        return index == 0;
      });
  ASSERT_TRUE(tree);
  EXPECT_EQ(offered, R"(a0{"x":[{"y":1}]}a2{"x":2})");
  EXPECT_EQ(tree->dump(), R"({"a":[null,7,{"x":2}],"b":{"c":[{"z":1}]},"d":[[{"z":2}]]})");
  EXPECT_EQ(read_json(R"([[{"a": 1}]])", "f.json", [](auto&&...) { return true; })->dump(), R"([[{"a":1}]])");
}

TEST(json_reader, a_byte_order_mark_is_skipped) { ASSERT_TRUE(read_json("\xef\xbb\xbf{\"a\":1}", "f.json")); }

TEST(json_reader, errors_tell_line_and_column) {
  EXPECT_TRUE(contains(error_of("{\n  \"a\": }\n"), "f.json:2:8: error: ")) << error_of("{\n  \"a\": }\n");
  EXPECT_TRUE(contains(error_of("[1, 2] x"), "f.json:1:8: error: ")) << error_of("[1, 2] x");
  EXPECT_TRUE(contains(error_of("[1, 2"), "f.json:1:6: error: ")) << error_of("[1, 2");
  EXPECT_TRUE(contains(error_of(""), "f.json:1:1: error: the file is empty"));
  EXPECT_TRUE(contains(error_of(" \n\t"), "f.json:2:2: error: the file is empty"));
}

TEST(json_reader, what_json_does_not_have_is_refused) {
  for (const char* text : {"[NaN]",
                           "[Infinity]",
                           "[-Infinity]",
                           "[1e999]",
                           "[-1e999]",
                           "[01]",
                           "[1.]",
                           "[.5]",
                           "[+1]",
                           "[1,]",
                           "{\"a\":1,}",
                           "{'a':1}",
                           "{a:1}",
                           "// c\n[]",
                           "[\"\xff\"]",
                           "[\"\xc3\"]",
                           "[\"\xed\xa0\x80\"]",
                           "[\"\\ud800\"]",
                           "[\"\n\"]",
                           "[\"a]",
                           "[]]",
                           "[] []",
                           "\xff",
                           "nul"})
    EXPECT_TRUE(contains(error_of(text), ": error: ")) << text;
  EXPECT_TRUE(contains(error_of("[1e999]"), "1e999 is out of range"));
}

TEST(json_reader, messages_hold_printable_ascii_alone) {
  for (const std::string& text : {std::string("[\"\xff\x01"), std::string("\0\0", 2), std::string("{\"\x7f\": \xff")}) {
    const std::string error = error_of(text);
    ASSERT_FALSE(error.empty());
    for (const char c : error) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << error;
  }
}

TEST(json_reader, duplicate_members_are_refused_with_their_place) {
  EXPECT_EQ(error_of(R"({"a": 1, "a": 2})"), "f.json: error: member \"a\" appears twice");
  EXPECT_EQ(error_of(R"({"knots": [{"x":1}, {"id": {"q":1,"q":1}}]})"),
            "f.json: error: knots[1].id: member \"q\" appears twice");
  EXPECT_EQ(error_of(R"([{"a":1},{"a":1}])"), "");
}

TEST(json_reader, nesting_is_refused_at_the_33rd_level_however_deep_it_goes) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(error_of(nested(32)), "");
  EXPECT_TRUE(contains(error_of(nested(33)), "nesting deeper than the limit of 32"));
  EXPECT_TRUE(contains(error_of(std::string(1'000'000, '[')), "nesting"));
  std::string objects;
  for (int i = 0; i < 300'000; ++i) objects += "{\"a\":";
  EXPECT_TRUE(contains(error_of(objects), "nesting"));
}

TEST(json_reader, an_object_of_many_members_takes_no_quadratic_time) {
  std::string text = "{";
  for (int i = 0; i < 100'000; ++i) text += "\"m" + std::to_string(i) + "\":0,";
  text += "\"end\":1}";
  const auto tree = read_json(text, "f.json");  // quadratic would be minutes: the test's time limit
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->size(), 100'001u);
}

TEST(json_reader, values_and_members_are_limited) {
  const auto of_values = [](std::size_t values) {  // the array is one of them
    std::string zeros = "[0";
    for (std::size_t i = 2; i < values; ++i) zeros += ",0";
    return read_json(zeros + "]", "f.json", {}, 1000);
  };
  EXPECT_TRUE(of_values(1000));
  const auto many = of_values(1001);
  ASSERT_FALSE(many);
  EXPECT_EQ(many.status().message, "f.json: error: more than the limit of 1000 values");
  EXPECT_EQ(kMaxValues, 8'000'000u);
  std::string members = "{";
  for (std::size_t i = 0; i < kMaxMembers + 5; ++i) members += "\"m" + std::to_string(i) + "\":0,";
  const auto wide = read_json(members + "\"end\":1}", "f.json");
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.status().message.find("limit of 200000 members"), std::string::npos) << wide.status().message;
}

TEST(json_reader, describe_says_what_a_value_is) {
  EXPECT_EQ(describe(nullptr), "null");
  EXPECT_EQ(describe(1.5), "1.5");
  EXPECT_EQ(describe("a\"b"), "\"a\\\"b\"");
  EXPECT_EQ(describe(Json::array({1, 2})), "an array of 2");
  EXPECT_EQ(describe(Json::object()), "an object");
  EXPECT_LT(describe(std::string(10'000, 'x')).size(), 100u);
}

}  // namespace json_reader_test
}  // namespace coaster::exchange
