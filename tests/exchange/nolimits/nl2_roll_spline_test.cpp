// The spline through roll points.
#include "exchange/nolimits/nl2_spline.h"

#include <random>

#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_rule.h"

namespace coaster::exchange {
namespace nl2_roll_spline_test {

TEST(nl2_roll_spline, is_the_clamped_cubic_spline_and_rests_at_strict_points) {
  std::mt19937 bits(5);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  for (int run = 0; run < 40; ++run) {
    std::vector<RollPoint> points;
    std::vector<double> s, angle;
    std::vector<bool> strict;
    for (int i = 0; i < 2 + run % 9; ++i) {
      points.push_back({(i > 0 ? points.back().s : 3) + uniform(0.2, 20), uniform(-4, 4), uniform(0, 1) < 0.25});
      s.push_back(points.back().s), angle.push_back(points.back().angle), strict.push_back(points.back().strict);
    }
    const RollSpline spline(points);
    const test::RuleRollSpline rule(s, angle, strict);
    for (int k = 0; k <= 300; ++k) {
      const double at = s.front() + (s.back() - s.front()) * k / 300;
      ASSERT_NEAR(spline.at(at).angle, rule.angle(at), 1e-9) << run;
      ASSERT_NEAR(spline.at(at).rate, rule.angle(at, 1), 1e-9) << run;
    }
    for (const RollPoint& p : points) {
      EXPECT_NEAR(spline.at(p.s).angle, p.angle, 1e-12);
      EXPECT_TRUE(!p.strict || std::abs(spline.at(p.s).rate) < 1e-12);
    }
    EXPECT_EQ(spline.at(s.front() - 1).angle, angle.front());
    EXPECT_EQ(spline.at(s.back() + 1).angle, angle.back());
    EXPECT_EQ(spline.at(s.back() + 1).rate, 0);
  }
  EXPECT_EQ(RollSpline({{4, 2.5, false}}).at(7).angle, 2.5);
}

// A strict point is as good as two points 1/512 m apart.
TEST(nl2_roll_spline, a_strict_point_counts_twice) {
  const std::vector<double> s{0, 5, 5 + 1 / 512.0, 19, 30}, angle{0.3, -1, -1, 2, 0};
  const test::RuleRollSpline twice(s, angle, std::vector<bool>(5));
  const RollSpline once({{0, 0.3, false}, {5, -1, true}, {19, 2, false}, {30, 0, false}});
  for (int k = 0; k <= 300; ++k) EXPECT_NEAR(once.at(k / 10.0).angle, twice.angle(k / 10.0), 1e-3) << k;
}

}  // namespace nl2_roll_spline_test
}  // namespace coaster::exchange
