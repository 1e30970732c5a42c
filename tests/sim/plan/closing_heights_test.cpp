#include "sim/plan/closing_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coaster::sim {
namespace closing_heights_test {

constexpr double kLevelEnd = 12;  // m: two shortest bends, where nothing is to be bent

// The largest slope of a smooth step is 35/16 times its mean, so a bend of that radius takes this length.
double bend(double change, double radius) { return 35.0 / 16.0 * std::abs(change) * radius; }

TEST(circuit_heights, track_that_begins_steeper_than_a_closing_section_may_be_goes_on_as_steep_to_its_level) {
  const HeightLimits limits{30, 20, 0.6};
  for (const double sign : {1.0, -1.0}) {
    const double out = bend(1, sign > 0 ? limits.crest : limits.valley), steady = 20,
                 rise = sign * (steady + 0.5 * out);
    HeightEnds ends{steady + out + kLevelEnd + 1e-6, 60, 60 + rise, sign, 0};
    const auto heights = heights_by_way_of(ends.to, ends, limits);
    ASSERT_TRUE(heights) << sign << ": the shortest way has a closed form";
    EXPECT_NEAR(heights->length(), ends.length, 1e-9);
    double least_radius = 1e9;
    for (double u = 0; u <= ends.length; u += 0.01) {
      const HeightProfile::At at = heights->at(u);
      EXPECT_NEAR(at.slope, u < steady ? sign : std::clamp(at.slope, -1.0, 1.0), 1e-12) << u;
      if (at.change != 0) least_radius = std::min(least_radius, 1 / std::abs(at.change));
    }
    EXPECT_NEAR(least_radius, sign > 0 ? limits.crest : limits.valley, 1e-3);
    EXPECT_NEAR(heights->at(ends.length).height, ends.to, 1e-9);
    ends.length = steady + out - 1e-5;
    EXPECT_FALSE(heights_by_way_of(ends.to, ends, limits)) << sign << ": there is none shorter";
  }
}

// The heights are the integral of the slopes, and those of their changes, by an independent sum.
TEST(circuit_heights, heights_slopes_and_changes_agree) {
  const HeightEnds ends{300, 20, 8, 0.3, -0.2};
  for (const auto& heights : {steady_heights(ends, {}), heights_by_way_of(14, ends, {})}) {
    ASSERT_TRUE(heights);
    EXPECT_NEAR(heights->at(0).height, ends.from, 1e-12);
    EXPECT_NEAR(heights->at(0).slope, ends.slope_from, 1e-12);
    EXPECT_NEAR(heights->at(ends.length).height, ends.to, 1e-9);
    EXPECT_NEAR(heights->at(ends.length).slope, ends.slope_to, 1e-12);
    constexpr double kStep = 1e-3;
    for (double u = kStep; u < ends.length - kStep; u += 0.37) {
      const HeightProfile::At before = heights->at(u - kStep), at = heights->at(u), after = heights->at(u + kStep);
      EXPECT_NEAR((after.height - before.height) / (2 * kStep), at.slope, 1e-7) << u;
      EXPECT_NEAR((after.slope - before.slope) / (2 * kStep), at.change, 1e-6) << u;
    }
  }
}

}  // namespace closing_heights_test
}  // namespace coaster::sim
