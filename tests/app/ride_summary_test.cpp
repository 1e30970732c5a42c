// Rides round rings by their closed forms.
#include "app/ride_summary.h"

#include <cmath>

#include "edit/session_fixture.h"
#include "sim/tracks.h"

namespace coaster::app {
namespace ride_summary_test {

class RideSummaries : public test::SessionTest {
 protected:
  RideSummary ride(const world::Document& document, int ticks) {
    start_on(document);
    good("ride.start");
    RideSummary summary = begin_summary(session);
    for (int i = 0; i < ticks; ++i) edit::advance(session, 1), measure(session, summary);
    return summary;
  }
};

TEST_F(RideSummaries, a_level_circle_to_the_right_has_its_side_force_as_a_size) {
  const double radius = 20.3, speed = 11.7;
  world::Document d = test::ring_document(64, radius, 0.0);
  world::reverse(d);
  d.start_speed = speed;
  world::add_cart(d, d.track.segments[3], 0.37);
  const RideSummary s = ride(d, 240);
  EXPECT_NEAR(s.most_side, speed * speed / radius / 9.81, 1e-2);
  EXPECT_NEAR(s.top_speed, speed, 1e-6);
  EXPECT_NEAR(s.distance, 2 * speed, 1e-3);
  EXPECT_NE(to_json(s).find("\"time_s\": 2"), std::string::npos) << to_json(s);
  EXPECT_EQ(s.ticks, 240);
}

TEST_F(RideSummaries, heights_are_those_of_the_hills) {
  world::Document d = test::ring_document(24, 40.7, 4.3);
  d.start_speed = 16.3;
  world::add_cart(d, d.track.segments[0], 0.2);
  const RideSummary s = ride(d, 120 * 20);
  EXPECT_GE(s.laps, 1);
  EXPECT_NEAR(s.highest, 21.7 + 4.3, 0.05);
  EXPECT_NEAR(s.lowest, 21.7 - 4.3, 0.05);
}

TEST_F(RideSummaries, say_why_the_ride_stopped) {
  world::Document d = test::ring_document(24, 40.7, 4.3);
  start_on(d);
  EXPECT_EQ(begin_summary(session).end, "The track has no train.");
  d.start_speed = 16.3;
  world::add_cart(d, d.track.segments[0], 0.2);
  const RideSummary early = ride(d, 120 * 3);
  EXPECT_TRUE(end_of_ride(session, early).starts_with("Stopped after 3 s at 4")) << end_of_ride(session, early);
  EXPECT_EQ(end_of_ride(session, ride(d, 120 * 20)), "The train completed the lap.");
  d.start_speed = 4, d.rollback_fails = true;  // over 2 m up the hill, and back
  const RideSummary slow = ride(d, 120 * 20);
  EXPECT_TRUE(end_of_ride(session, slow).starts_with("Train c1 rolled back at ")) << end_of_ride(session, slow);
}

}  // namespace ride_summary_test
}  // namespace coaster::app
