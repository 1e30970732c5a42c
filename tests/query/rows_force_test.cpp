// Tests the queries of force sections (query/rows_sections.cpp).
#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"

namespace coaster::query {
namespace rows_force_test {

class ForceRows : public test::SessionTest {
 protected:
  ForceRows() : SessionTest(world::Document{}) {
    for (const char* line :
         {"start_speed 5", "element climb height 32 equipment lift speed 5", "element straight length 8",
          "element dive height 28", "force.add length 60", "force @q4 vertical key 1 at 0",
          "force @q4 vertical key 3 at 20", "force @q4 vertical key 0.5 at 45", "force @q4 lateral key 0 at 5",
          "force @q4 lateral key 0.3 at 25", "force @q4 roll key 0 at 10", "force @q4 roll key 1 at 30",
          "force @q4 roll key 0 at 50"})
      good(line);
  }
  std::string ask(std::string_view name, std::string_view argument = {}) {
    const FrameStats stats;
    const auto value = find_query(name)->evaluate({session, stats, "", ""}, argument);
    return value ? to_text(*value) : value.status().message;
  }
  double number(std::string_view name, std::string_view argument) {
    const auto value = base::parse_double(ask(name, argument));
    EXPECT_TRUE(value) << name << " " << argument << ": " << ask(name, argument);
    return value.value_or(1e9);
  }
};

TEST_F(ForceRows, tell_what_is_asked_for_and_what_is_felt) {
  good("force.length @q4 to 54");
  EXPECT_EQ(ask("section.kind", "@q4"), "force");
  EXPECT_EQ(ask("force.over", "@q4"), "distance");
  EXPECT_EQ(ask("force.length", "@q4"), "54");
  EXPECT_EQ(ask("force.tolerance", "@q4"), "0.05");
  EXPECT_EQ(ask("force.keys", "@q4.vertical"), "3");
  EXPECT_EQ(ask("force.stopped", "@q4"), "none");
  EXPECT_NEAR(number("force.speed", "@q4"), number("section.speed_in", "@q4"), 0.05);
  EXPECT_LE(number("force.error", "@q4"), 0.05);
  EXPECT_LT(number("force.shape_error", "@q4"), 0.01);
  EXPECT_NEAR(number("force.asked", "@q4.vertical/20"), 3, 1e-6);
  EXPECT_NEAR(number("force.asked", "@q4.vertical/10"), 2, 1e-6) << "half of the smooth step";
  for (const char* const place :
       {"@q4.vertical/5", "@q4.vertical/20", "@q4.vertical/45", "@q4.lateral/25", "@q4.roll/30"})
    EXPECT_NEAR(number("force.met", place), number("force.asked", place), 0.06) << place;
  EXPECT_EQ(ask("geometric_min"), "G2");
}

TEST_F(ForceRows, tell_why_a_section_is_shorter) {
  good("force @q4 vertical key -1 at 45");
  good("force @q4 vertical key 1 at 20");
  EXPECT_NE(ask("force.stopped", "@q4").find("the track would run into the ground there"), std::string::npos);
  EXPECT_LT(number("section.length", "@q4"), 59);
  EXPECT_EQ(ask("force.length", "@q4"), "60");
}

TEST_F(ForceRows, wrong_arguments_are_errors) {
  EXPECT_EQ(ask("force.speed", "@q1"), "none") << "no force section";
  EXPECT_NE(ask("force.speed", "@q9").find("no section @q9"), std::string::npos);
  for (const char* const place : {"@q4", "@q4.vertical", "@q4.up/3", "@q4.vertical/x", "", "/", "."})
    EXPECT_EQ(ask("force.asked", place).rfind("expected ", 0), 0u) << place;
  EXPECT_NE(ask("force.keys", "@q4.up").find("expected vertical, lateral or roll"), std::string::npos);
}

}  // namespace rows_force_test
}  // namespace coaster::query
