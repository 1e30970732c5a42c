// Checked getters for the members of a JSON object.
#include "exchange/own/json.h"

#include <gtest/gtest.h>

namespace coaster::exchange {
namespace json_fields_test {

const Json& sample() {
  static const Json json =
      Json::parse(R"({"t":"x","f":true,"n":2.5,"w":3,"v":[1,2.5,-3],"l":[1],"u":18446744073709551615,"odd":{"a":1}})");
  return json;
}

template <class Get>
std::string error_of(Get get) {
  std::string error;
  JsonFieldReader fields(sample(), {"knots", 3}, error);
  EXPECT_FALSE(get(fields));
  return error;
}

TEST(json_fields, getters_fill_their_values) {
  std::string error, text;
  bool flag = false;
  double number = 0;
  std::int64_t whole = 0;
  glm::dvec3 vector;
  float length = 0;
  JsonFieldReader fields(sample(), {}, error);
  EXPECT_TRUE(fields.text("t", text) && fields.flag("f", flag) && fields.number("n", number, 2.5, 2.5) &&
              fields.whole("w", whole, 3, 3) && fields.vector("v", vector, 3) && fields.length("n", length, 0.01f, 10));
  EXPECT_EQ(text, "x");
  EXPECT_TRUE(flag);
  EXPECT_EQ(number, 2.5);
  EXPECT_EQ(whole, 3);
  EXPECT_EQ(vector, glm::dvec3(1, 2.5, -3));
  EXPECT_EQ(length, 2.5f);
  ASSERT_NE(fields.list("l"), nullptr);
  EXPECT_EQ(error, "");
}

TEST(json_fields, errors_name_place_expectation_and_finding) {
  std::string text;
  double number = 0;
  std::int64_t whole = 0;
  bool flag = false;
  glm::dvec3 vector;
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.text("n", text); }), "knots[3].n: expected a text, found 2.5");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.text("q", text); }), "knots[3].q: missing; expected a text");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.flag("t", flag); }),
            "knots[3].t: expected true or false, found \"x\"");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.number("n", number, 3, 4); }),
            "knots[3].n: expected a number from 3 to 4, found 2.5");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.whole("n", whole, 0, 9); }),
            "knots[3].n: expected a whole number from 0 to 9, found 2.5");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.whole("u", whole, -9, 9); }),
            "knots[3].u: expected a whole number from -9 to 9, found 18446744073709551615");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.vector("l", vector, 9); }),
            "knots[3].l: expected 3 finite numbers, found an array of 1");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.vector("v", vector, 2.75); }),
            "knots[3].v[2]: expected a number from -2.75 to 2.75, found -3");
  EXPECT_EQ(error_of([&](JsonFieldReader& f) { return f.list("t") != nullptr; }),
            "knots[3].t: expected an array, found \"x\"");
}

TEST(json_fields, what_is_no_object_fails_every_getter) {
  std::string error, text;
  const Json json = Json::array({1});
  JsonFieldReader fields(json, {"carts", 0}, error);
  EXPECT_FALSE(fields.text("t", text));
  EXPECT_EQ(error, "carts[0]: expected an object, found an array of 1");
}

TEST(json_fields, members_never_asked_for_are_unknown_and_kept) {
  std::string error, text;
  std::vector<std::string> warnings;
  const Json json = Json::parse(R"({"t":"x","zz":[1.5],"aa":{"b":null}})");
  JsonFieldReader fields(json, {"knots", 7}, error);
  ASSERT_TRUE(fields.text("t", text));
  EXPECT_EQ(fields.unknown(warnings), R"({"zz":[1.5],"aa":{"b":null}})");
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0], "knots[7]: unknown member \"zz\" is kept");
}

}  // namespace json_fields_test
}  // namespace coaster::exchange
