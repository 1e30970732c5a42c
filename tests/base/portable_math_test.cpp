#include "base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace coaster::base {
namespace portable_math_test {

TEST(portable_math, sine_and_cosine_agree_with_long_double) {
  std::mt19937_64 random(3);
  double worst = 0;
  for (double range : {0.8, 7.0, 1e4}) {
    std::uniform_real_distribution<double> angle(-range, range);
    for (int i = 0; i < 100'000; ++i) {
      const double x = angle(random);
      const SinCos sc = sin_cos(x);
      worst = std::max(worst, std::abs(static_cast<double>(sc.sin - sinl(x))));
      worst = std::max(worst, std::abs(static_cast<double>(sc.cos - cosl(x))));
    }
  }
  EXPECT_LT(worst, 1e-15);
}

// At the end of the range an angle is some 640,000 quarter turns: what three parts of pi/2 are for.
TEST(portable_math, large_angles_lose_no_digits) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(9e5, 1e6);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = i % 2 ? angle(random) : -angle(random);
    worst = std::max(worst, std::abs(static_cast<double>(sin_cos(x).sin - sinl(x))));
  }
  EXPECT_LT(worst, 4e-16);
}

TEST(portable_math, arc_tangent_agrees_with_long_double_all_round) {
  double worst = 0;
  for (int i = -18'000; i < 18'000; ++i) {
    const long double angle = 3.14159265358979323846L * (i + 0.377L) / 18'000;
    const double x = static_cast<double>(13.7L * cosl(angle)), y = static_cast<double>(13.7L * sinl(angle));
    worst = std::max(worst, std::abs(static_cast<double>(arc_tangent(y, x) - atan2l(y, x))));
  }
  EXPECT_LT(worst, 1e-15);
  EXPECT_EQ(arc_tangent(0, 0), 0);
  EXPECT_EQ(arc_tangent(0, 2), 0);
  EXPECT_NEAR(arc_tangent(0, -2), kPi, 1e-15);
}

TEST(portable_math, what_is_not_finite_gives_the_angle_zero) {
  for (double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(sin_cos(x).sin, 0);
    EXPECT_EQ(sin_cos(x).cos, 1);
    EXPECT_EQ(arc_tangent(x, 1), 0);
  }
}

}  // namespace portable_math_test
}  // namespace coaster::base
