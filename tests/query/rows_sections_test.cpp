// Tests the queries of sections (query/rows_sections.cpp).
#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"

namespace coaster::query {
namespace rows_sections_test {

class SectionRows : public test::SessionTest {
 protected:
  SectionRows() : SessionTest(world::Document{}) {
    for (const char* line : {"element straight length 30", "element loop right height 18", "append at 100 4 9"})
      good(line);
  }
  std::string ask(std::string_view name, std::string_view argument = {}) {
    const FrameStats stats;
    const auto value = find_query(name)->evaluate({session, stats, "", ""}, argument);
    return value ? to_text(*value) : value.status().message;
  }
};

TEST_F(SectionRows, tell_of_each_section) {
  EXPECT_EQ(ask("sections"), "3");
  EXPECT_EQ(ask("section.kind", "@q1"), "straight");
  EXPECT_EQ(ask("section.kind", "@q2"), "loop");
  EXPECT_EQ(ask("section.kind", "@q3"), "free");
  EXPECT_EQ(ask("section.title", "@q2"), "Loop");
  EXPECT_EQ(ask("section.title", "@q3"), "Hand-shaped");
  EXPECT_EQ(ask("section.value", "@q2.height"), "18");
  EXPECT_EQ(ask("section.value", "@q2.shift"), "3.5");
  EXPECT_EQ(ask("section.value", "@q2.radius"), "none");
  EXPECT_EQ(ask("section.value", "@q3.height"), "none");
  EXPECT_EQ(ask("section.first", "@q1"), "k1");
  EXPECT_EQ(ask("section.last", "@q1"), "k2");
  EXPECT_EQ(ask("section.first", "@q2"), "k2");
  EXPECT_EQ(ask("section.last", "@q3"), world::label_of(session.document, session.document.track.knots.back()));
  EXPECT_EQ(ask("section.of", "@s1"), "q1");
  EXPECT_EQ(ask("section.of", "@s2"), "q2");
  EXPECT_EQ(ask("section.segments", "@q1"), "1");
  EXPECT_NEAR(*base::parse_double(ask("section.length", "@q1")), 30, 1e-6);
  double sum = 0;
  for (const char* name : {"@q1", "@q2", "@q3"}) sum += *base::parse_double(ask("section.length", name));
  EXPECT_NEAR(sum, session.derived.length, 1e-9);
}

TEST_F(SectionRows, tell_what_the_ride_is_like_there) {
  const auto of = [&](std::string_view name, std::string_view section) {
    return *base::parse_double(ask(name, section));
  };
  EXPECT_NEAR(of("section.top", "@q2"), of("section.top", "@q1") + 18, 0.02);
  EXPECT_NEAR(of("section.speed_out", "@q1"), of("section.speed_in", "@q2"), 1e-9);
  EXPECT_EQ(ask("section.speed_out", "@q2"), "none") << "too slow for the loop";
  good("start_speed 25");
  const double in = of("section.speed_in", "@q2");
  EXPECT_NEAR(in, 25, 1e-2);
  EXPECT_GT(of("section.g_most", "@q2"), 3);
  EXPECT_LT(of("section.g_least", "@q2"), of("section.g_most", "@q2"));
  EXPECT_GE(of("section.g_side", "@q2"), 0);
}

TEST_F(SectionRows, name_what_is_not_there) {
  EXPECT_EQ(ask("section.kind", "@q9").rfind("no section @q9", 0), 0u) << ask("section.kind", "@q9");
  EXPECT_EQ(ask("section.kind", "@s1").rfind("expected a section such as @q3", 0), 0u);
  EXPECT_NE(ask("section.value", "@q2.hight").find("did you mean \"height\"?"), std::string::npos);
  EXPECT_EQ(ask("section.value", "@q2"), "expected @section.PARAMETER, found \"@q2\"");
}

}  // namespace rows_sections_test
}  // namespace coaster::query
