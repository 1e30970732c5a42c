// The window of rolls that a span's rows allow.
#include "sim/fit/sample_span_fit.h"

#include <gtest/gtest.h>

namespace coaster::sim {
namespace {

using glm::dvec2, glm::dvec3;

double printed(double x) { return std::round(x * 1e6) / 1e6; }
dvec3 printed(dvec3 v) { return {printed(v.x), printed(v.y), printed(v.z)}; }

double area(const RollWindow& window) {
  double twice = 0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const dvec2 a = window[i], b = window[(i + 1) % window.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

// All rows of a straight allow the same rolls: those of its ends. Their lines meet in two corners of the square, but
// for rounding, and would cut 5,000 corners there.
TEST(FitSpan, AStraightLeavesAWindowOfFewCorners) {
  constexpr std::size_t kRows = 5000;
  const dvec3 forward = glm::normalize(dvec3(0.7648, 0.01, 0.6442)),
              up = glm::normalize(curve::perpendicular(forward, {0, 1, 0}));
  std::vector<FitRow> rows;
  std::vector<double> distances;
  for (std::size_t i = 0; i < kRows; ++i) {
    const double s = 0.1 * static_cast<double>(i);
    const dvec3 front = glm::normalize(printed(forward));
    rows.push_back({printed(s * forward), front, glm::normalize(curve::perpendicular(front, printed(up)))});
    distances.push_back(s);
  }
  const std::vector<char> free(kRows, 0);
  const std::vector<double> bends(kRows, 1.0), spins(kRows, 0.0), speeds(kRows, 20.0);
  const std::vector<dvec3> curvatures(kRows, dvec3(0));
  SpanBounds bounds;
  bounds.free = free, bounds.bends = bends, bounds.spins = bounds.slopes = bounds.leans = spins, bounds.speeds = speeds,
  bounds.curvatures = curvatures;
  SpanScratch scratch;
  const SpanFit fit = fit_span(rows, distances, 0, kRows - 1, -bounds.angle, bounds.angle, bounds, scratch);
  ASSERT_TRUE(fit.within);
  EXPECT_LT(fit.window.size(), 200u);
  const double side = 2 * 0.25 * bounds.angle;  // a quarter of the bound about the smooth roll
  EXPECT_NEAR(area(fit.window), side * side, 1e-3 * side * side);
}

TEST(FitSpan, LinesThatMeetInTwoCornersCutNoneButTheirOwn) {
  constexpr double kHalf = 0.0083;
  RollWindow window{{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}}, spare;
  for (int i = 1; i < 5000; ++i) {
    const double share = i / 5000.0, rounding = 1e-13 * std::sin(7.0 * i);
    clip(window, {1 - share, share}, kHalf + rounding, spare);
    clip(window, {share - 1, -share}, kHalf - rounding, spare);
  }
  EXPECT_LT(window.size(), 200u);
  EXPECT_NEAR(area(window), 4 * kHalf * kHalf, 1e-3 * kHalf * kHalf);
  clip(window, {0, 1}, 0, spare);
  EXPECT_NEAR(area(window), 2 * kHalf * kHalf, 1e-3 * kHalf * kHalf);
  EXPECT_NEAR(second_rolls(window).low, -kHalf, 1e-9);
  EXPECT_NEAR(second_rolls(window).high, 0, 1e-9);
  EXPECT_EQ(first_roll(window, -0.001, 0.002), 0.002);
  EXPECT_NEAR(first_roll(window, -0.001, 0.02), kHalf, 1e-9);
}

}  // namespace
}  // namespace coaster::sim
