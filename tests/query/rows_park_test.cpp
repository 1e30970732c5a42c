// Tests the queries of the park (query/rows_park.cpp).
#include <gtest/gtest.h>

#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"
#include "sim/ground/land.h"

namespace coaster::query {
namespace rows_park_test {

class ParkRows : public test::SessionTest {
 protected:
  ParkRows() : SessionTest(world::Document{}) {}
  std::string ask(std::string_view name, std::string_view argument = {}) {
    const FrameStats stats;
    const auto value = find_query(name)->evaluate({session, stats, "", ""}, argument);
    return value ? to_text(*value) : value.status().message;
  }
  double number(std::string_view name, std::string_view argument = {}) {
    return base::parse_double(ask(name, argument)).value_or(-12345);
  }
};

TEST_F(ParkRows, a_plain_track_has_no_park_and_level_ground) {
  EXPECT_EQ(ask("park"), "plain");
  for (const char* const name : {"park.seed", "park.relief", "park.woods", "park.water", "ground.clearance"})
    EXPECT_EQ(ask(name), "none") << name;
  EXPECT_EQ(ask("park.tiles"), "0");
  EXPECT_EQ(ask("ground.height", "12,-30"), "0");
  good("element straight length 40");
  EXPECT_NEAR(number("ground.clearance"), 2, 1e-6) << "new track begins 2 m up";
  EXPECT_EQ(ask("tunnels"), "0");
  EXPECT_EQ(ask("tunnels.length"), "0");
  EXPECT_EQ(ask("trees"), "0");
  EXPECT_EQ(ask("section.earthwork", "@q1"), "automatic");
}

TEST_F(ParkRows, tell_of_a_park) {
  good("park hills");
  EXPECT_EQ(ask("park"), "hills");
  EXPECT_EQ(ask("park.seed"), "7");
  EXPECT_EQ(ask("park.relief"), "1");
  EXPECT_EQ(ask("park.woods"), "0.6");
  EXPECT_EQ(ask("park.water"), "-1.2");
  good("park.water none");
  EXPECT_EQ(ask("park.water"), "none");
  const sim::Land land(session.document.park);
  EXPECT_NEAR(number("ground.height", "100,-60"), land.height(100, -60), 1e-5) << "drawn in float";
  const double trees = number("trees");
  EXPECT_GT(trees, 1000);
  good("park.woods 0");
  EXPECT_LT(number("trees"), 0.5 * trees);
  good("ground.raise at 100 -60 radius 20 by 5");
  EXPECT_NEAR(number("ground.height", "100,-60"), land.height(100, -60) + 5, 0.05);
  EXPECT_GT(number("park.tiles"), 0);
  EXPECT_EQ(ask("ground.height", "100"), "expected X,Z, found \"100\"");
  EXPECT_NE(ask("ground.height", "a,3").find("expected a number (X)"), std::string::npos);
}

TEST_F(ParkRows, a_track_through_a_hill_is_a_tunnel_or_a_cut) {
  good("park meadow");
  for (const char* const line : {"element straight length 30", "element straight length 80"}) good(line);
  good("ground.flatten at 70 0 radius 60 to 25");
  EXPECT_EQ(ask("tunnels"), "1");
  const double length = number("tunnels.length");
  EXPECT_GT(length, 20);
  EXPECT_LT(length, 100);
  EXPECT_GT(number("ground.clearance"), 0.5) << "outside the tunnel";
  good("section.earthwork all to cut");
  EXPECT_EQ(ask("tunnels"), "0");
  EXPECT_EQ(ask("tunnels.length"), "0");
  EXPECT_GT(number("ground.clearance"), 0.5) << "cut open";
  good("section.earthwork all to none");
  EXPECT_LT(number("ground.clearance"), -10) << "within the hill";
  EXPECT_EQ(ask("section.earthwork", "@q2"), "none");
}

}  // namespace rows_park_test
}  // namespace coaster::query
