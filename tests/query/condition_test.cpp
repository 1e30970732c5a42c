// What holds: operators, tolerances, words for ranks and switches.
#include "query/condition.h"

#include <gtest/gtest.h>

namespace coaster::query {
namespace condition_test {

// The condition "QUERY rest" held against a value; -1: refused.
int holds_for(const std::string& rest, const query::Value& value, const std::string& query = "name") {
  std::vector<base::Token> tokens;
  base::TextError error;
  EXPECT_TRUE(base::tokenise(query + " " + rest, tokens, error));
  base::Words words(tokens, error);
  Condition condition;
  EXPECT_TRUE(parse_condition(words, condition)) << rest << ": " << error.message;
  const base::Result<bool> result = holds(condition, value);
  return result ? *result : -1;
}

TEST(condition, numbers_compare_with_and_without_tolerance) {
  EXPECT_EQ(holds_for("== 3", 3.0), 1);
  EXPECT_EQ(holds_for("== 3", 3.0001), 0);
  EXPECT_EQ(holds_for("== 3 +-0.001", 3.0001), 1);
  EXPECT_EQ(holds_for("== 3 +- 0.00005", 3.0001), 0);
  EXPECT_EQ(holds_for("== -3.7 +- 0.1", -3.65), 1);
  EXPECT_EQ(holds_for("!= 3 +-0.001", 3.0001), 0);
  EXPECT_EQ(holds_for("!= 3", 3.0001), 1);
  EXPECT_EQ(holds_for("< 1e-4", 9e-5), 1);
  EXPECT_EQ(holds_for("< 3", 3.0), 0);
  EXPECT_EQ(holds_for("<= 3", 3.0), 1);
  EXPECT_EQ(holds_for("<= 3 +-0.1", 3.05), 1);
  EXPECT_EQ(holds_for("> 2.5", 2.6), 1);
  EXPECT_EQ(holds_for(">= 2.5", 2.4), 0);
  EXPECT_EQ(holds_for(">= 2.5 +-0.2", 2.4), 1);
  EXPECT_EQ(holds_for(">= 2.5 +-0.05", 2.4), 0);
  EXPECT_EQ(holds_for(">= 0.7", static_cast<double>(0.7f)), 1) << "0.7f is below 0.7";
  EXPECT_EQ(holds_for("<= 0.1", static_cast<double>(0.1f)), 1) << "0.1f is above 0.1";
  EXPECT_EQ(holds_for("== 0.1", static_cast<double>(0.1f)), 1) << "a value kept in single precision equals its text";
  EXPECT_EQ(holds_for("== 16777217", 16777216.0), 0) << "whole numbers are exact";
  EXPECT_EQ(holds_for("== nonsense", 1.0), -1);
  EXPECT_EQ(holds_for("== on", 1.0), 1);
}

TEST(condition, texts_compare_and_contain) {
  EXPECT_EQ(holds_for("== \"Red Comet\"", std::string("Red Comet")), 1);
  EXPECT_EQ(holds_for("== Red Comet", std::string("Red Comet")), 1);
  EXPECT_EQ(holds_for("!= Red", std::string("Red Comet")), 1);
  EXPECT_EQ(holds_for("~ \"LIMIT\"", std::string("move: the limit is 100000 m")), 1);
  EXPECT_EQ(holds_for("~ \"limits\"", std::string("move: the limit is 100000 m")), 0);
  EXPECT_EQ(holds_for("== @k4", std::string("k4")), 1);
  EXPECT_EQ(holds_for("== k4", std::string("@k4")), 1);
  EXPECT_EQ(holds_for("== true", std::string("on")), 1);
  EXPECT_EQ(holds_for("== off", std::string("on")), 0);
  EXPECT_EQ(holds_for("== 5a1c09e27733d0b1", std::string("5a1c09e27733d0b1")), 1);
  EXPECT_EQ(holds_for("== 1234567890123456", std::string("1234567890123457")), 0) << "hashes are texts, never numbers";
  EXPECT_EQ(holds_for("< b", std::string("a")), -1);
}

// The error of a condition that cannot be parsed; empty if it can.
std::string parse_error(const std::string& line) {
  std::vector<base::Token> tokens;
  base::TextError error;
  EXPECT_TRUE(base::tokenise(line, tokens, error));
  base::Words words(tokens, error);
  Condition condition;
  return parse_condition(words, condition) ? "" : std::to_string(error.column) + ": " + error.message;
}

TEST(condition, values_that_a_query_never_has_are_refused_when_parsed) {
  EXPECT_EQ(parse_error("camera_mode != rid"),
            "16: expected orbit, ride, chase or fly, found \"rid\"; did you mean \"ride\"?");
  EXPECT_EQ(parse_error("ride.state == Running"),
            "15: expected stopped, running, paused, ended or failed, found \"Running\"; did you mean \"running\"?");
  EXPECT_EQ(parse_error("joint @k3 == smoth"),
            "14: expected smooth, aligned or automatic, found \"smoth\"; did you mean \"smooth\"?");
  EXPECT_EQ(parse_error("length == abc"), "11: expected a number (m), found \"abc\"");
  EXPECT_EQ(parse_error("length > 1,5"),
            "10: expected a number (m), found \"1,5\": decimals follow a point, not a comma");
  EXPECT_EQ(parse_error("position @k3 == 1 2 z"), "21: expected a number (m), found \"z\"");
  for (const char* const fine : {"camera_mode == ride", "camera_mode ~ rid", "ride.ghost_end == ran off the open end",
                                 "ride.state == none", "equipment @s1 != none", "fold.at == none", "length == 3 m",
                                 "length ~ 3", "position @k3 == 1 2 +3 +- 0.1", "name == abc", "knots == 3"})
    EXPECT_EQ(parse_error(fine), "") << fine;
}

TEST(condition, continuity_compares_by_rank) {
  const query::Value g1 = query::Ranked{1, "G1"};
  EXPECT_EQ(holds_for(">= G1", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("< G2", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("== G0", g1, "geometric @k1"), 0);
  EXPECT_EQ(holds_for("== g1", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("!= G2", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for(">= G1", query::Ranked{-1, "none"}, "geometric @k1"), 0) << "an open end joins nothing";
  EXPECT_EQ(holds_for("== none", g1, "geometric @k1"), 0);
  EXPECT_EQ(holds_for(">= C1", g1, "geometric @k1"), -1) << "C1 is a rank of another scale";
  EXPECT_EQ(holds_for("== on", query::Value(query::Ranked{1, "on"})), 1);
  EXPECT_EQ(holds_for("== false", query::Value(query::Ranked{0, "off"})), 1);
}

TEST(condition, vectors_compare_by_component) {
  const query::Value v = glm::dvec3(1.25, -3.1f, 7);
  EXPECT_EQ(holds_for("== 1.25 -3.1 7", v), 1);
  EXPECT_EQ(holds_for("== 1.25 -3.2 7", v), 0);
  EXPECT_EQ(holds_for("== 1.3 -3.2 7 +- 0.11", v), 1);
  EXPECT_EQ(holds_for("!= 1.25 -3.2 7", v), 1);
  EXPECT_EQ(holds_for("< 1 2 3", v), -1);
  EXPECT_EQ(holds_for("== 1 2", v), -1);
}

}  // namespace condition_test
}  // namespace coaster::query
