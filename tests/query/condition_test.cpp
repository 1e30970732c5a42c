// What holds: operators, tolerances, words for ranks and switches.
#include "query/condition.h"

#include <gtest/gtest.h>

#include "world/element_rows.h"

namespace coaster::query {
namespace condition_test {

// The condition "QUERY rest" held against a value, of a query that has such values; -1: refused.
int holds_for(const std::string& rest, const query::Value& value, std::string query = {}) {
  constexpr const char* kQueries[] = {"knots", "name", "closed", "tangent @k1"};  // in the order of Value's types
  if (query.empty()) query = kQueries[value.index()];
  std::vector<base::Token> tokens;
  base::TextError error;
  EXPECT_TRUE(base::tokenise(query + " " + rest, tokens, error));
  base::WordReader words(tokens, error);
  Condition condition;
  if (!parse_condition(words, condition)) return -1;
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
  base::WordReader words(tokens, error);
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
                                 "closed == true", "closed != 0", "geometric @k3 >= g1", "parametric @k3 == none",
                                 "length ~ 3", "position @k3 == 1 2 +3 +- 0.1", "name == abc", "knots == 3"})
    EXPECT_EQ(parse_error(fine), "") << fine;
}

TEST(condition, the_values_have_the_type_of_the_query) {
  EXPECT_EQ(parse_error("knots == abc"), "10: expected a number, found \"abc\"");
  EXPECT_EQ(parse_error("knots == 1 2"), "10: expected one number, found \"1 2\"");
  EXPECT_EQ(parse_error("position @k3 == 1 2"), "17: expected three numbers (m), found \"1 2\"");
  EXPECT_EQ(parse_error("position @k3 > 1 2 3"), "14: a vector can be compared only with == and !=, found \">\"");
  EXPECT_EQ(parse_error("length == 3 km"), "11: expected one number (m), found \"3 km\"");
  EXPECT_EQ(parse_error("name < 3"), "6: a text can be compared only with ==, != and ~, found \"<\"");
  EXPECT_EQ(parse_error("knotz == 3"), "1: no query \"knotz\"; did you mean \"knots\"?");
  EXPECT_EQ(parse_error("lap_time == 3"), "1: no query \"lap_time\"; did you mean \"ride.lap_time\"?");
  EXPECT_EQ(parse_error("qqqqqq == 3"), "1: no query \"qqqqqq\"; coaster --help-script lists all");
  EXPECT_EQ(parse_error("closed == onn"), "11: expected off or on, found \"onn\"; did you mean \"on\"?");
  EXPECT_EQ(parse_error("closed == none"), "11: expected off or on, found \"none\"");
  EXPECT_EQ(parse_error("geometric @k3 >= C1"), "18: expected none, G0, G1 or G2, found \"C1\"; did you mean \"G1\"?");
  EXPECT_EQ(parse_error("shown comb == maybe").substr(0, 25), "15: expected off or on, f");
}

TEST(condition, switches_are_asked_for_by_value_and_widgets_by_opposites) {
  const query::Value on = query::Ranked{1, "on"}, off = query::Ranked{0, "off"};
  EXPECT_EQ(holds_for("on", on), 1);
  EXPECT_EQ(holds_for("off", on), 0);
  EXPECT_EQ(holds_for("off", off), 1);
  EXPECT_EQ(holds_for("3", 3.0, "knots"), -1) << "numbers want an operator";
  for (const std::string query : {"visible", "enabled"}) {
    const std::string opposite = query == "visible" ? "hidden" : "disabled";
    EXPECT_EQ(holds_for("Track", on, query), 1);
    EXPECT_EQ(holds_for("Track", on, opposite), 0);
    EXPECT_EQ(holds_for("Track off", off, query), 1);
    EXPECT_EQ(holds_for("Track", off, opposite), 1);
    EXPECT_EQ(holds_for("Track", off, "not " + opposite), 0);
  }
}

TEST(condition, a_parameter_of_an_element_is_a_number_or_one_of_its_choices) {
  EXPECT_EQ(parse_error("section.value @q1.height == tall"), "29: expected a number, found \"tall\"");
  EXPECT_EQ(parse_error("element.value height <= 3"), "");
  EXPECT_EQ(parse_error("element.value radius == none"), "");
  EXPECT_EQ(parse_error("element.value ends == rising"), "23: expected level or falling, found \"rising\"");
  EXPECT_EQ(parse_error("section.value @q1.ends == fallng").substr(0, 26), "27: expected level or fall");
  EXPECT_EQ(parse_error("section.value @q1.ends < level"),
            "24: a text can be compared only with ==, != and ~, found \"<\"");
  for (const world::ElementRow& row : world::rows_of(world::ElementKind{}))
    for (const world::ElementParameter& p : row.parameters) {
      std::vector<std::string> choices;
      for (const base::NameRow& choice : p.names) choices.emplace_back(choice.name);
      EXPECT_EQ(values_with(*find_query("element.value"), p.name).words, choices) << row.name << " " << p.name;
    }
}

TEST(condition, an_argument_is_what_the_query_takes) {
  EXPECT_EQ(parse_error("position @s1 == 1 2 3"), "10: expected a knot such as @k3, found \"@s1\"");
  EXPECT_EQ(parse_error("hash documents == 1"),
            "6: expected document or motion, found \"documents\"; did you mean \"document\"?");
  const std::string parameter = parse_error("section.value @q1.hight == 3");
  EXPECT_EQ(parameter.substr(0, 13), "19: expected ") << parameter;
  EXPECT_NE(parameter.find(", found \"hight\"; did you mean \"height\"?"), std::string::npos) << parameter;
  EXPECT_EQ(parse_error("section.value @q1 == 3"), "15: expected @section.PARAMETER, found \"@q1\"");
  EXPECT_NE(parse_error("shown suports == on").find("did you mean \"supports\"?"), std::string::npos);
  EXPECT_EQ(parse_error("force.met @q3.vertcal/4 > 0"),
            "15: expected vertical, lateral or roll, found \"vertcal\"; did you mean \"vertical\"?");
  EXPECT_EQ(parse_error("force.met @q3.vertical/x > 0"), "24: expected a number (PLACE), found \"x\"");
  EXPECT_EQ(parse_error("force.met @q3.vertical > 0"), "11: expected @section.CHANNEL/PLACE, found \"@q3.vertical\"");
  EXPECT_EQ(parse_error("seat.jerk 60/roof > 0"),
            "14: expected front, middle, back, least, most or 1 to 32, found \"roof\"");
  EXPECT_EQ(parse_error("measure.error horner/63 < 1").substr(0, 37), "22: expected 16, 64, 256, 1024 or 409");
  EXPECT_EQ(parse_error("complete.length 4 > 0"), "17: expected 1 to 3, found \"4\"");
  EXPECT_EQ(parse_error("position == 1 2 3"), "10: expected @knot, found \"==\"");
  for (const char* const fine :
       {"position k3 == 1 2 3", "seat.jerk 60 > 0", "seat.jerk 60.5/32 > 0", "force.met @q3.vertical/4.5 > 0"})
    EXPECT_EQ(parse_error(fine), "") << fine;
}

TEST(condition, none_is_another_value_than_any_number) {
  EXPECT_EQ(holds_for("== none", 3.0), 0);
  EXPECT_EQ(holds_for("!= none", 3.0), 1);
  EXPECT_EQ(holds_for("< none", 3.0), -1);
  EXPECT_EQ(parse_error("fold.at >= none"), "9: none can be compared only with == and !=, found \">=\"");
}

TEST(condition, none_meets_only_a_comparison_with_none) {
  for (const std::string query : {"fold.at", "selected", "geometric @k1", "construction_point", "card.end"}) {
    const bool vector = query == "construction_point", text = query == "selected" || query == "card.end";
    const std::string value = query == "geometric @k1" ? "G1" : vector ? "0 0 0" : query == "card.end" ? "lap" : "0";
    for (const std::string op : {"==", "!=", "<", "<=", ">", ">=", "~"}) {
      if ((vector || text) && op != "==" && op != "!=" && op != "~") continue;
      EXPECT_EQ(holds_for(op + " " + value, NoValue{}, query), 0) << query << " " << op;
      EXPECT_EQ(holds_for(op + " " + value, NoValue{}, "not " + query), 0) << "not " << query << " " << op;
    }
    EXPECT_EQ(holds_for("", NoValue{}, query), 0) << query;
    EXPECT_EQ(holds_for("", NoValue{}, "not " + query), 0) << query;
    EXPECT_EQ(holds_for("~ none", NoValue{}, query), 0) << query;
    EXPECT_EQ(holds_for("== none", NoValue{}, query), 1) << query;
    EXPECT_EQ(holds_for("!= none", NoValue{}, query), 0) << query;
    EXPECT_EQ(holds_for("== none", NoValue{}, "not " + query), 0) << query;
    EXPECT_EQ(holds_for("!= none", NoValue{}, "not " + query), 1) << query;
  }
  EXPECT_EQ(holds_for("== none", std::string("none"), "name"), 1) << "a track may have that name";
}

TEST(condition, what_was_found_is_said_with_its_unit_or_why_it_is_none) {
  EXPECT_EQ(describe(*find_query("length"), 3.5), "found 3.5 m");
  EXPECT_EQ(describe(*find_query("name"), std::string("Skew")), "found \"Skew\"");
  EXPECT_EQ(describe(*find_query("fold.at"), NoValue{"there is no fold"}), "but fold.at is none: there is no fold");
  EXPECT_EQ(describe(*find_query("fold.at"), NoValue{}), "but fold.at is none");
}

TEST(condition, a_text_with_a_tolerance_compares_by_the_number_it_begins_with) {
  const auto text = [](const std::string& rest, const char* shown) {
    return holds_for(rest, std::string(shown), "text \"Ride/Speed\"");
  };
  EXPECT_EQ(text("== 6 +- 0.1", "6.05 m/s"), 1);
  EXPECT_EQ(text("== 6 +- 0.1", "6.25 m/s"), 0);
  EXPECT_EQ(text("!= 6 +- 0.1", "6.25 m/s"), 1);
  EXPECT_EQ(text("== 1884 +- 3", "1885"), 1);
  EXPECT_EQ(text("== -0.5 +-0.03", "-0.52 g"), 1);
  EXPECT_EQ(text("== 12 +- 1", "12.5%"), 1);
  EXPECT_EQ(text("== 3 +- 1", "+3.5 m"), 1);
  EXPECT_EQ(text("== 1e-5 +- 1e-6", "1.05e-05 m"), 1);
  EXPECT_EQ(text("== 6 +- 0", "6 e"), 1) << "the unit may begin with e";
  EXPECT_EQ(text("== 3 +- 0.5", "3.2, 7.5"), 1) << "the first of several";
  for (const char* const without : {"--", "", "fast", "on", "inf", "nan", "-", "about 6"})
    EXPECT_EQ(text("== 6 +- 100", without), -1) << without;
  EXPECT_EQ(text("!= 6 +- 100", "--"), -1) << "no number is not another number";
  EXPECT_EQ(text("== 6", "6.0"), 0) << "without a tolerance it is a text";
  EXPECT_EQ(parse_error("text \"A\" == 6 m +- 1"), "13: expected one number, found \"6 m\"");
  EXPECT_EQ(parse_error("text \"A\" == abc +- 1"), "13: expected a number, found \"abc\"");
  EXPECT_EQ(parse_error("ride.state == running +- 1"), "15: a tolerance needs a number, found \"running\"");
  EXPECT_EQ(parse_error("geometric @k1 == G1 +- 1"), "18: a tolerance needs a number, found \"G1\"");
  EXPECT_EQ(parse_error("closed == on +- 1"), "11: a tolerance needs a number, found \"on\"");
  EXPECT_EQ(parse_error("fold.at == none +- 1"), "12: a tolerance needs a number, found \"none\"");
}

TEST(condition, continuity_compares_by_rank) {
  const query::Value g1 = query::Ranked{2, "G1"};
  EXPECT_EQ(holds_for(">= G1", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("< G2", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("== G0", g1, "geometric @k1"), 0);
  EXPECT_EQ(holds_for("== g1", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("!= G2", g1, "geometric @k1"), 1);
  EXPECT_EQ(holds_for("< G2", NoValue{}, "geometric @k1"), 0) << "an open end joins nothing";
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
