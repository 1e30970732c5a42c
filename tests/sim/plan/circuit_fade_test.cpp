// The fade of an end's roll, compared with sums of small steps of its slope.
#include "sim/plan/closing_heights.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace coaster::sim {
namespace circuit_fade_test {

constexpr double kStarts[][3] = {{0.6, 0, 0},        {0, 0.04, 0},        {0, 0, 0.05},
                                 {0.3, -0.02, 0.01}, {-1.2, 0.03, -0.04}, {0, 0, 0}};

TEST(circuit_fade, begins_as_asked_and_ends_with_nothing_left) {
  for (const double length : {3.0, 12.0, 47.0})
    for (const auto& [angle, spin, slope] : kStarts) {
      const RollFade fade(length, angle, spin, slope);
      EXPECT_EQ(fade.angle(0), angle);
      EXPECT_EQ(fade.spin(0), spin);
      EXPECT_EQ(fade.slope(0), slope);
      const double before = length - 1e-9;
      EXPECT_NEAR(fade.angle(before), 0, 1e-9);
      EXPECT_NEAR(fade.spin(before), 0, 1e-8);
      EXPECT_NEAR(fade.slope(before), 0, 1e-8);
      EXPECT_EQ(fade.angle(length), 0);
      EXPECT_EQ(fade.spin(length), 0);
      EXPECT_EQ(fade.slope(length), 0);
    }
}

TEST(circuit_fade, turns_as_its_slope_sums_up) {
  constexpr int kSteps = 20000;
  for (const auto& [angle, spin, slope] : kStarts) {
    const RollFade fade(24, angle, spin, slope);
    double turned = angle, rate = spin;
    for (int i = 0; i < kSteps; ++i) {
      const double step = 24.0 / kSteps, s = step * i, more = step * fade.slope(s + 0.5 * step);
      ASSERT_NEAR(fade.angle(s), turned, 1e-6) << s;
      ASSERT_NEAR(fade.spin(s), rate, 1e-6) << s;
      turned += step * (rate + 0.5 * more), rate += more;
    }
  }
}

// Without jumps of the slope, and straight between the joints, so that a cubic angle represents each part.
TEST(circuit_fade, its_slope_is_straight_between_its_joints) {
  for (const auto& [angle, spin, slope] : kStarts) {
    const RollFade fade(30, angle, spin, slope);
    ASSERT_LT(0, fade.first_joint());
    ASSERT_LT(fade.first_joint(), fade.second_joint());
    const double ends[] = {0, fade.first_joint(), fade.second_joint(), 30};
    for (int part = 0; part < 3; ++part) {
      const double from = ends[part], to = ends[part + 1] - 1e-12, a = fade.slope(from), b = fade.slope(to);
      for (const double u : {0.1, 0.5, 0.8}) EXPECT_NEAR(fade.slope(from + u * (to - from)), a + u * (b - a), 1e-9);
      EXPECT_NEAR(fade.slope(ends[part + 1] + 1e-12), b, 1e-9);
    }
  }
}

TEST(circuit_fade, is_as_long_as_riders_need) {
  for (const double speed : {5.0, 14.0, 27.0})
    for (const auto& [angle, unused, slope] : kStarts) {
      const double length = fade_length(angle, slope, speed * speed);
      EXPECT_GE(length, 12);
      EXPECT_NEAR(fade_length(0, fade_slope(length, speed * speed), speed * speed), length, 1e-9);
      const RollFade fade(length, angle, 0, slope);
      double rate = 0, push = 0;
      for (double s = fade.first_joint(); s < length; s += 0.01)
        rate = std::max(rate, std::abs(fade.spin(s)) * speed), push = std::max(push, std::abs(fade.slope(s)));
      push *= speed * speed;
      const bool both = angle != 0 && slope != 0;
      EXPECT_LT(push, both ? 6.2 : 3.1) << angle << ", " << slope << " at " << speed;
      EXPECT_LT(rate - std::abs(fade.spin(fade.first_joint())) * speed, 1.1)
          << angle << ", " << slope << " at " << speed;
      EXPECT_TRUE(length == 12 || both || push > 2.7 || rate > 0.95) << push << ", " << rate;
    }
}

}  // namespace circuit_fade_test
}  // namespace coaster::sim
