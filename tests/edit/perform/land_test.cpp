// Commands on a land: heights over it, what they warn of, and that the plane keeps its words.
#include "edit/session/findings.h"
#include "edit/session_fixture.h"
#include "sim/ground/ground.h"
#include "sim/lands.h"
#include "sim/study/ratings.h"

namespace coaster::edit {
namespace land_test {

struct OnLand : test::SessionTest {
  static double slope(double x, double z) { return 4.5 + 0.06 * x - 0.09 * z; }
  world::Document sloping(world::Document document = test::sample_document()) {
    test::shape_land(document, slope);
    return document;
  }
  const world::Knot& k(int number) const {
    return world::knot(session.document,
                       world::find(session.document, {world::EntityKind::knot, static_cast<std::uint32_t>(number)}));
  }
};

TEST_F(OnLand, drop_puts_knots_on_the_land_as_people_left_it_however_often) {
  start_on(sloping());
  good("drop @k3,@k5");
  const glm::vec3 once = k(3).position;
  const sim::Land land(session.document.park);
  for (const int i : {3, 5})
    EXPECT_NEAR(k(i).position.y, land.height(double{k(i).position.x}, double{k(i).position.z}), 1e-4) << i;
  EXPECT_LT(SessionFindings(session).ground().height(double{once.x}, double{once.z}), double{once.y} - 1)
      << "where the ground is cut to the track";
  good("drop @k3");
  EXPECT_EQ(k(3).position, once);
  good("drop @k3 to 2.5");
  EXPECT_NEAR(k(3).position.y, once.y + 2.5f, 1e-4);
}

TEST_F(OnLand, the_first_knot_stands_two_metres_over_the_land_or_its_water) {
  start_on(sloping(world::Document{}));
  good("add_curve");
  EXPECT_NEAR(session.document.entities.pool<world::Knot>().items()[0].position.y, 6.5, 1e-6);
  world::Document lake = sloping(world::Document{});
  lake.park.water = 9;
  start_on(lake);
  good("add_curve");
  EXPECT_EQ(session.document.entities.pool<world::Knot>().items()[0].position.y, 11);
}

// An element that dives below y = 0: a warning on the plane, a cut on a land, a warning again under water.
TEST_F(OnLand, elements_below_zero_are_warned_of_on_the_plane_and_under_water_alone) {
  world::Document low = test::straight_document({0, 3, 0}, {30, 3, 0});
  const auto said = [&] {
    start_on(low);
    good("element dive height 8");
    const std::string text = session.notices.list.back().text;
    return text;
  };
  EXPECT_NE(said().find("below the ground"), std::string::npos);
  test::shape_land(low, [](double, double) { return 4.0; });
  EXPECT_EQ(said().find("below"), std::string::npos);
  low.park.water = 3.5;
  EXPECT_NE(said().find("under water"), std::string::npos);
}

// A circuit through a hill is rated with its tunnel; the same circuit on the plane has the ratings it always had.
TEST_F(OnLand, ratings_count_tunnels_and_are_those_of_the_plane_without_a_land) {
  circuit();
  const sim::Ratings plane = SessionFindings(session).ratings();
  EXPECT_EQ(plane.tunnels, 0);
  EXPECT_EQ(plane.close, 0);
  world::Document hill = session.document;
  test::shape_land(hill, [](double, double) { return 40.0; });
  start_on(hill);
  const sim::Ratings under = SessionFindings(session).ratings();
  EXPECT_GE(under.tunnels, 1);
  EXPECT_GT(under.in_tunnels, 100);
  EXPECT_GT(under.excitement, plane.excitement);
  EXPECT_EQ(under.intensity, plane.intensity);
  EXPECT_EQ(under.nausea, plane.nausea);
  hill.park = {};
  start_on(hill);
  EXPECT_EQ(SessionFindings(session).ratings().excitement, plane.excitement);
}

}  // namespace land_test
}  // namespace coaster::edit
