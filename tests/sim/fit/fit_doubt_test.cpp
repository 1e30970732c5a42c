// What riders may feel more or less than rows far apart say, by closed forms.
#include "sim/fit/sample_interpolation.h"

#include <gtest/gtest.h>

#include "world/motion.h"

namespace coaster::sim {
namespace fit_doubt_test {

using glm::dvec3;

TEST(fit_doubt, quick_rolls_between_rows_far_apart_are_in_doubt) {
  const auto doubt = [](double width, double spacing) {
    const auto roll = [&](double s) {
      const double u = std::clamp((s - 40) / width, 0.0, 1.0);
      return 1.2 * u * u * u * (10 - 15 * u + 6 * u * u);
    };
    std::vector<FitRow> rows;
    for (double s = 0; s < 100 + 1e-9; s += spacing) {
      const dvec3 forward(0.6, 0, 0.8);
      rows.push_back({dvec3(3.1, 20.3, -7) + s * forward, forward, curve::rotate({0, 1, 0}, forward, roll(s))});
    }
    const std::vector<double> speeds(rows.size(), 400 / world::kGravity);  // 20 m/s
    double most = 0;
    for (const double d : roll_doubts(rows, false, row_rolls(rows, false), speeds, 1.1)) most = std::max(most, d);
    return most;
  };
  EXPECT_GT(doubt(14, 4.5), 0.4);
  EXPECT_LT(doubt(40, 4.5), 0.1);
  // Four times h^2 / 12 of the fourth derivative, which is largest where the roll begins and ends, at 20 / 3 Hz.
  const double passed = 1 / std::sqrt(1 + std::pow(20 / 3.0 / 5, 8));
  EXPECT_NEAR(doubt(14, 1.5) / (2 * passed),
              2 * 1.5 * 1.5 / 12 * 1.2 * 360 / std::pow(14, 4) * 1.1 * 400 / world::kGravity, 0.03);
  EXPECT_LT(doubt(14, 0.05), 1e-3) << "close rows hold all that riders feel";
}

// A roll c s^4 / 24 from an open end on, whose second derivative is c s^2 / 2.
TEST(fit_doubt, a_roll_that_changes_fast_at_an_open_end_is_in_doubt_by_how_much_it_is_missed) {
  constexpr double kFourth = 0.2, kHeart = 1.1, kV2 = 12;  // rad/m^4, m, m
  for (const double spacing : {0.5, 0.8})
    for (const bool from_start : {true, false}) {
      SCOPED_TRACE(::testing::Message() << spacing << from_start);
      std::vector<FitRow> rows;
      const double start = from_start ? 0 : -5 * spacing;
      for (int i = 0; i < 6; ++i) {
        const double s = start + i * spacing;
        const dvec3 forward(0.6, 0, 0.8);
        rows.push_back({s * forward, forward, curve::rotate({0, 1, 0}, forward, kFourth * s * s * s * s / 24)});
      }
      const RowRolls rolls = row_rolls(rows, false);
      const std::size_t end = from_start ? 0 : rows.size() - 1;
      const double missed = std::abs(rolls.slopes[end]) * kHeart * kV2;  // 0 in truth
      const std::vector<double> doubts = roll_doubts(rows, false, rolls, std::vector<double>(rows.size(), kV2), kHeart);
      EXPECT_GT(missed, 0.4);
      EXPECT_GT(doubts[end], 0.7 * missed);
      EXPECT_LT(doubts[end], 1.5 * missed);
    }
}

// The largest doubt on rows every `spacing` m, but for the ends, of waves that hardly bend.
double waves_doubt(double k, double amplitude, double spacing, double v2) {
  std::vector<FitRow> rows;
  const dvec3 ahead(0.8, 0, -0.6), side(0.6, 0, 0.8);
  for (double x = 0; x < 200; x += spacing) {
    const dvec3 forward = glm::normalize(ahead + amplitude * k * std::cos(k * x) * side);
    rows.push_back({dvec3(3.1, 20.3, -7) + x * ahead + amplitude * std::sin(k * x) * side, forward, {0, 1, 0}});
  }
  const std::vector<double> doubts = bend_doubts(rows, false, std::vector<double>(rows.size(), v2));
  double most = 0;
  for (std::size_t i = 8; i + 8 < rows.size(); ++i) most = std::max(most, doubts[i]);
  return most;
}

// On cos(kx) the spline of degree 5 through places and slopes with a continuous third derivative has, at knots t = kh
// apart, the second derivative k^2 S(t) of the wave: -s(-1) + 6 s(0) - s(1) = 20 (f(-1) - 2 f(0) + f(1)) / h^2 -
// 8 (f'(1) - f'(-1)) / h. Midway between knots 2h apart, at a crest, it is the even curve's 3/2 f'(h) / h - s(h) / 2.
TEST(fit_doubt, bends_are_in_doubt_by_what_every_second_row_leaves_out) {
  const auto spline = [](double t) {
    return (40 * (std::cos(t) - 1) / (t * t) + 16 * std::sin(t) / t) / (6 - 2 * std::cos(t));
  };
  const double v2 = 17.3, k = 2 * M_PI / 30;
  for (const double h : {2.0, 2.5, 3.1, 4.0}) {
    const double t = k * h, midway = -1.5 * std::sin(t) / t - 0.5 * std::cos(t) * spline(2 * t);
    const double expected = std::abs(midway - spline(t)) * 0.01 * k * k * v2;
    EXPECT_NEAR(waves_doubt(k, 0.01, h, v2) / expected, 1, 0.02) << h;
  }
}

TEST(fit_doubt, closed_rows_are_in_doubt_at_their_seam_as_elsewhere) {
  for (const int count : {40, 41}) {
    std::vector<FitRow> rows;
    for (int i = 0; i < count; ++i) {
      const double a = 2 * M_PI * i / count, wave = 0.4 * std::sin(10 * a), slope = 4 * std::cos(10 * a);
      const dvec3 out(std::cos(a), 0, std::sin(a)), along(-std::sin(a), 0, std::cos(a));
      rows.push_back({(20 + wave) * out, glm::normalize((20 + wave) * along + slope * out), {0, 1, 0}});
    }
    const std::vector<double> v2(rows.size(), 10.0), doubts = bend_doubts(rows, true, v2);
    const int turn = 4;
    std::rotate(rows.begin(), rows.begin() + turn, rows.end());
    const std::vector<double> turned = bend_doubts(rows, true, v2);
    double most = 0;
    for (int i = 0; i < count; ++i) {
      most = std::max(most, doubts[i]);
      // With an odd number of rows two kept rows are neighbours at the seam, which moves with it.
      if (count % 2 == 0) {
        EXPECT_NEAR(turned[i], doubts[(i + turn) % count], 1e-6) << i;
      }
    }
    EXPECT_GT(most, 0.06) << count;
  }
}

}  // namespace fit_doubt_test
}  // namespace coaster::sim
