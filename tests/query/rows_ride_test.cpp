// The queries of a ride for a cart on a level circle: v^2 / r to the inside, 1 g up, nothing forwards.
#include <cmath>
#include <map>
#include <string>

#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"
#include "query/rows.h"
#include "sim/tracks.h"

namespace coaster::query {
namespace rows_ride_test {

constexpr double kRadius = 20.3, kSpeed = 11.7;

class RideRows : public test::SessionTest {
 protected:
  double number(std::string_view name, std::string_view argument = {}) {
    return std::get<double>(*find_query(name)->evaluate({session, stats, "", ""}, argument));
  }
  FrameStats stats;
  void start_on_a_circle(bool to_the_right) {
    world::Document d = test::ring_document(64, kRadius, 0.0);
    if (to_the_right) world::reverse(d);
    d.start_speed = kSpeed;
    world::add_cart(d, d.track.segments[3], 0.37);
    start_on(d);
  }
};

TEST_F(RideRows, forces_on_a_level_circle_are_the_closed_form_in_both_directions) {
  for (const bool to_the_right : {false, true}) {
    start_on_a_circle(to_the_right);
    const double inward = kSpeed * kSpeed / kRadius / 9.81;
    EXPECT_NEAR(number("ride.g_side"), to_the_right ? -inward : inward, 5e-3);
    EXPECT_NEAR(number("ride.g_up"), 1, 1e-3);
    EXPECT_NEAR(number("ride.g_forward"), 0, 1e-3);
    EXPECT_NEAR(number("ride.speed"), kSpeed, 1e-9);
  }
}

TEST_F(RideRows, wheels_on_a_level_circle_push_the_train_inwards_and_carry_more_outside) {
  for (const bool to_the_right : {false, true}) {
    start_on_a_circle(to_the_right);
    const double inward = 0.5 * kSpeed * kSpeed / kRadius, weight = 0.5 * 9.81;  // kN on 500 kg
    const std::string_view inner = to_the_right ? "right" : "left", outer = to_the_right ? "left" : "right";
    EXPECT_NEAR(number("wheels.side", inner), inward, 0.03);
    EXPECT_NEAR(number("wheels.side", outer), 0, 1e-9);
    EXPECT_NEAR(number("wheels.road", outer), weight / 2 + inward * 1.1 / 1.2, 0.03);
    EXPECT_NEAR(number("wheels.road", "car") - number("wheels.up_stop", "car"), weight, 0.01);
    EXPECT_NEAR(number("wheels.road", "front"), number("wheels.road", "rear"), 0.02);
  }
  const auto wrong = find_query("wheels.road")->evaluate({session, stats, "", ""}, "middle");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.status().message.find("front_left"), std::string::npos);
}

TEST_F(RideRows, a_second_on_a_level_circle_is_as_far_as_the_speed_says) {
  start_on_a_circle(false);
  const double from = number("ride.distance");
  good("ride.start");
  edit::advance(session, 120);
  EXPECT_NEAR(number("ride.travelled"), kSpeed, 1e-3);
  EXPECT_NEAR(number("ride.distance"), from + kSpeed, 1e-3);
  edit::advance(session, static_cast<int>(120 * 2 * M_PI * kRadius / kSpeed));
  EXPECT_EQ(number("ride.lap"), 1);
  EXPECT_NEAR(number("ride.energy"), 0.5 * kSpeed * kSpeed + 9.81 * (number("ride.height") - number("datum")), 1e-3);
}

// Scripts that wait for one of these rows rely on it.
TEST_F(RideRows, stand_still_unless_the_ride_is_running) {
  start_on_a_circle(false);
  const auto values = [&] {
    std::map<std::string_view, std::string> all;
    for (const Query& row : ride_rows())
      if (row.name.starts_with("ride.") && row.name != "ride.cost")  // of this machine
        all[row.name] = to_text(*row.evaluate({session, stats, "", ""}, ""));
    return all;
  };
  const auto before = values();
  edit::advance(session, 240);
  EXPECT_EQ(values(), before);
  good("ride.start");
  edit::advance(session, 240);
  const auto after = values();
  for (const char* const name : {"ride.state", "ride.distance", "ride.travelled", "ride.segment"})
    EXPECT_NE(after.at(name), before.at(name)) << name;
  good("ride.pause");
  const auto paused = values();
  edit::advance(session, 240);
  EXPECT_EQ(values(), paused);
}

}  // namespace rows_ride_test
}  // namespace coaster::query
