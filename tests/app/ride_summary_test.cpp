// Rides round rings by their closed forms.
#include "app/ride_summary.h"

#include <cmath>

#include <fmt/format.h>

#include "edit/session/ride_report.h"
#include "edit/session_fixture.h"
#include "sim/ride/ride.h"
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
    if (session.motion.carts.size() > 0) finish_summary(session, summary);
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
  EXPECT_TRUE(early.end.starts_with("Stopped after 3 s at 4")) << early.end;
  EXPECT_EQ(ride(d, 120 * 20).end, "The train completed the lap.");
  d.start_speed = 4, d.rollback_fails = true;  // over 2 m up the hill, and back
  const RideSummary slow = ride(d, 120 * 20);
  EXPECT_TRUE(slow.end.starts_with("Train c1 rolled back at ")) << slow.end;
}

// Beside short handles felt g spikes within centimetres; riders feel what the low-pass leaves of it.
TEST_F(RideSummaries, g_are_those_that_riders_feel_as_in_the_report) {
  world::Document d = test::ring_document(24, 40.7, 0.0);
  world::Knot& knot = d.entities.get<world::Knot>(d.track.knots[7]);
  knot.in_length = knot.out_length = 0.8f;
  d.start_speed = 14;
  world::add_cart(d, d.track.segments[0], 0);
  start_on(d);
  good("ride.start");
  RideSummary s = begin_summary(session);
  double most = 0;  // not low-passed
  while (s.laps == 0 && s.ticks < 120 * 40) {
    edit::advance(session, 1), measure(session, s);
    const world::Entity train = session.motion.carts.entities()[0];
    const world::TrainMotion& cart = session.motion.carts.items()[0];
    most = std::max(most, std::abs(double{sim::felt(session.document, session.derived, train, cart).left}));
  }
  finish_summary(session, s);
  EXPECT_LT(s.most_side, most - 1);
  EXPECT_GT(s.most_side, 14 * 14 / 40.7 / 9.81);
  const sim::Ratings& ratings = edit::SessionFindings(session).ratings();
  EXPECT_EQ(s.most_up, ratings.up_most.value);
  EXPECT_EQ(s.least_up, ratings.up_least.value);
  EXPECT_EQ(s.most_side, ratings.side_most.value);
  const std::string line = fmt::format("felt g, low-passed at 5 Hz: vertical {:.2f}..{:.2f}, lateral at most {:.2f}\n",
                                       s.least_up, s.most_up, s.most_side);
  EXPECT_NE(to_text(s).find(line), std::string::npos) << to_text(s);
  const std::string report = edit::ride_report(session).value_or("");
  EXPECT_NE(report.find(fmt::format("  {:<22} {:8.2f} g", "most lateral", s.most_side)), std::string::npos) << report;
  EXPECT_NE(report.find(fmt::format("  {:<22} low-passed at 5 Hz, of all cars\n", "felt g")), std::string::npos);
}

}  // namespace ride_summary_test
}  // namespace coaster::app
