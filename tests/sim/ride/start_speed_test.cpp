// Start speeds by the energy needed for the highest point.
#include "sim/ride/simulated_ride.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace start_speed_test {

constexpr double kG = 9.81;

// The least whole number whose square is over 2 g h, and 1 more.
double over(double height) { return std::floor(std::sqrt(2 * kG * height)) + 2; }

TEST(completing_speed, takes_the_train_over_the_highest_hill_of_a_ring) {
  for (const double hill : {1.3, 4.3, 17.9}) {
    world::Document d = test::ring_document(48, 40.7, hill);
    world::add_cart(d, d.track.segments[0], 0);
    const double start = world::knot(d, d.track.knots[0]).position.y;
    const auto speed = completing_speed(d);
    ASSERT_TRUE(speed);
    EXPECT_EQ(*speed, over(21.7 + hill - start)) << hill;
  }
}

TEST(completing_speed, reaches_the_end_of_a_climb_and_gives_up_on_one_that_is_too_high) {
  world::Document d = test::straight_document({3.3f, 7.1f, -2.9f}, {30.3f, 61.1f, 5.1f}, 3);
  EXPECT_FALSE(completing_speed(d)) << "no train";
  world::add_cart(d, d.track.segments[0], 0);
  EXPECT_EQ(completing_speed(d), over(54.0));
  // 150 m/s rise to 1146.8 m.
  for (const auto& [top, found] : {std::pair{1140.0f, true}, {1160.0f, false}}) {
    world::Document high = test::straight_document({0, 0, 0}, {900, top, 0}, 40);
    world::add_cart(high, high.track.segments[0], 0);
    EXPECT_EQ(completing_speed(high).has_value(), found) << top;
  }
}

TEST(completing_speed, counts_losses) {
  world::Document d = test::straight_document({0, 0, 0}, {400, 0, 0}, 8);
  world::add_cart(d, d.track.segments[0], 0);
  d.resistance.rolling = 0.03;  // v^2 / 2 = 0.03 g 400 m
  EXPECT_EQ(completing_speed(d), over(0.03 * 400));
}

}  // namespace start_speed_test
}  // namespace coaster::sim
