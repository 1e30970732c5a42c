// Smooth rolls and rows between rows, by closed forms.
#include "sim/fit/sample_interpolation.h"

#include <gtest/gtest.h>

#include "base/portable_math.h"

namespace coaster::sim {
namespace sample_interpolation_test {

using glm::dvec3;

// Rows on a level straight, of any roll over the places, radians.
template <class Roll>
std::vector<FitRow> straight_rows(Roll roll, double length, double spacing) {
  std::vector<FitRow> rows;
  for (int i = 0; i * spacing <= length + 1e-9; ++i) {
    const dvec3 forward(0.6, 0, 0.8);
    rows.push_back(
        {dvec3(3.1, 20.3, -7) + i * spacing * forward, forward, curve::rotate({0, 1, 0}, forward, roll(i * spacing))});
  }
  return rows;
}

TEST(fit_smooth, a_roll_that_starts_at_once_is_spread_as_far_as_the_rows_allow) {
  constexpr double kStart = 10, kSpacing = 0.05;
  for (const double w : {0.08, 0.21, 0.5}) {
    SCOPED_TRACE(w);
    const std::vector<FitRow> rows =
        straight_rows([&](double s) { return w * std::max(0.0, s - kStart); }, 20, kSpacing);
    const RowRolls rolls = row_rolls(rows, false);
    // The step w of the rate, averaged with the weights of a triangle that reaches a to either side.
    const double a = 6 * kMostLean / w;
    double most = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double x = kSpacing * static_cast<double>(i) - kStart, near = std::max(0.0, 1 - std::abs(x) / a);
      EXPECT_NEAR(rolls.spins[i], w * (x > 0 ? 1 - near * near / 2 : near * near / 2), 1e-3 * w) << x;
      EXPECT_NEAR(rolls.leans[i], w * a * near * near * near / 6, 1e-5) << x;
      most = std::max(most, rolls.leans[i]);
    }
    EXPECT_NEAR(most, kMostLean, 1e-5);
  }
}

TEST(fit_smooth, smooth_rolls_keep_their_rates_and_jumps_do_not_turn_the_rows_beside_them) {
  const auto even = [](double s) { return 0.7 * std::sin(s / 9); };
  const std::vector<FitRow> rows = straight_rows(even, 40, 0.05);
  const RowRolls rolls = row_rolls(rows, false);
  for (std::size_t i = 20; i + 20 < rows.size(); ++i) {
    const double s = 0.05 * static_cast<double>(i);
    EXPECT_NEAR(rolls.spins[i], 0.7 / 9 * std::cos(s / 9), 1e-4) << s;  // the mean over 0.6 m to either side
    EXPECT_NEAR(rolls.leans[i], -0.7 / 81 * std::sin(s / 9) * 0.36 / 12, 1e-5) << s;
  }
  const RowRolls jump = row_rolls(straight_rows([](double s) { return s > 10 ? 0.5 : 0.0; }, 20, 0.05), false);
  for (std::size_t i = 0; i < jump.spins.size(); ++i) {
    EXPECT_LE(std::abs(jump.spins[i]), 0.3) << i;
    EXPECT_LE(std::abs(jump.leans[i]), 1.1 * kMostLean) << i;
  }
}

TEST(fit_smooth, open_ends_within_a_roll_keep_its_rate) {
  constexpr double kAcceleration = 0.11, kRate = -0.9;  // rad/m^2, rad/m
  for (const double spacing : {0.05, 0.2, 0.5, 2.0}) {
    SCOPED_TRACE(spacing);
    const std::vector<FitRow> rows =
        straight_rows([&](double s) { return kRate * s + 0.5 * kAcceleration * s * s; }, 8, spacing);
    const RowRolls rolls = row_rolls(rows, false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(rolls.spins[i], kRate + kAcceleration * spacing * static_cast<double>(i), 1e-6) << i;
      EXPECT_NEAR(rolls.slopes[i], kAcceleration, 1e-6) << i;
    }
  }
}

// A level curve whose direction turns by turn(s), by Simpson's rule, with rows at the places.
template <class Turn>
std::vector<FitRow> level_rows(Turn turn, const std::vector<double>& places) {
  std::vector<FitRow> rows;
  dvec3 at(3.1, 20.3, -7);
  double s = 0;
  const auto along = [&](double x) { return dvec3(std::cos(turn(x)), 0, -std::sin(turn(x))); };
  for (const double place : places) {
    constexpr int kParts = 400;
    const double h = (place - s) / kParts;
    for (int i = 0; i < kParts; ++i, s += h) at += h / 6 * (along(s) + 4.0 * along(s + h / 2) + along(s + h));
    rows.push_back({at, along(place), {0, 1, 0}});
    s = place;
  }
  return rows;
}

// To the left of a level curve is (sin, 0, cos) of minus its angle, so that it turns by k (-sin, 0, -cos).
dvec3 level_bend(double angle, double k) { return k * dvec3(-std::sin(angle), 0, -std::cos(angle)); }

TEST(fit_smooth, curvatures_are_those_of_circles_and_clothoids) {
  for (const double radius : {9.0, 40.0}) {
    std::vector<double> places;
    for (int i = 0; i < 40; ++i) places.push_back(2 * M_PI * radius * i / 40);
    const auto turn = [&](double s) { return s / radius; };
    const std::vector<dvec3> bends = row_curvatures(level_rows(turn, places), true);
    for (std::size_t i = 0; i < bends.size(); ++i)
      EXPECT_LT(glm::distance(bends[i], level_bend(turn(places[i]), 1 / radius)), 1e-5 / radius) << i;
  }
  // Uneven steps; close rows are left out, as positions are rounded.
  std::vector<double> places;
  for (int i = 0; i < 60; ++i) places.push_back(1.7 * i + (i % 3 == 0 ? 0.3 : 0.0));
  places.insert(places.begin() + 30, places[29] + 0.02);
  const auto turn = [](double s) { return 0.02 * s - 0.0004 * s * s; };
  const std::vector<dvec3> bends = row_curvatures(level_rows(turn, places), false);
  for (std::size_t i = 5; i + 5 < bends.size(); ++i)
    EXPECT_LT(glm::distance(bends[i], level_bend(turn(places[i]), 0.02 - 0.0008 * places[i])), 2e-5) << i;
}

TEST(fit_smooth, curvatures_of_straights_and_single_rows_are_0) {
  for (const dvec3& bend : row_curvatures(straight_rows([](double s) { return s; }, 20, 2), false))
    EXPECT_LT(glm::length(bend), 1e-12);
  const std::vector<FitRow> one = straight_rows([](double) { return 0.0; }, 1, 2);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(row_curvatures(one, false).at(0), dvec3(0));
}

TEST(fit_smooth, rows_between_are_on_the_helix_of_the_rows) {
  // Radius 14 m, rising by 0.3 rad, with the roll 0.4 sin(s / 8) to its right against the rotation-minimising frame.
  const double slope = 0.3, turn = std::cos(slope) / 14;
  const auto at = [&](double s) {
    const double a = turn * s;
    return FitRow{{14 * std::sin(a), s * std::sin(slope), -14 * std::cos(a)},
                  {std::cos(slope) * std::cos(a), std::sin(slope), std::cos(slope) * std::sin(a)},
                  {}};
  };
  constexpr int kFine = 1000;  // steps per m
  std::vector<FitRow> fine;
  curve::Frame frame{at(0).forward, curve::perpendicular(at(0).forward, {0, 1, 0})};
  for (int i = 0; i <= 80 * kFine; ++i) {
    const double s = static_cast<double>(i) / kFine;
    FitRow row = at(s);
    if (i > 0) frame = curve::transport(frame, fine.back().position, row.position, row.forward);
    row.up = curve::rotate(frame.up, row.forward, 0.4 * std::sin(s / 8));
    fine.push_back(row);
  }
  std::vector<FitRow> rows;
  for (double s = 0; s <= 80; s += rows.size() % 3 == 0 ? 3.9 : 4.6)
    rows.push_back(fine[static_cast<std::size_t>(std::lround(s * kFine))]);
  const FilledRows filled = fill_rows(rows, false);
  ASSERT_EQ(filled.rows.size(), 2 * rows.size() - 1);
  for (std::size_t i = 0; i < filled.rows.size(); ++i) {
    EXPECT_EQ(filled.given(i), i % 2 == 0);
    EXPECT_EQ(filled.from[i], i / 2);
    const FitRow& row = filled.rows[i];
    double nearest = 1e9, angle = 0;
    for (const FitRow& known : fine)
      if (const double d = glm::distance(known.position, row.position); d < nearest)
        nearest = d, angle = frame_angle_deg({known.forward, known.up}, {row.forward, row.up});
    const bool inner = i > 4 && i + 5 < filled.rows.size();  // at open ends the spline's second derivative is 0
    EXPECT_LT(nearest, inner ? 1.5e-3 : 6e-3) << i;
    EXPECT_LT(angle, inner ? 0.1 : 0.5) << i;
  }
  const std::vector<FitRow> far{at(0), at(12), at(15.6), at(40)};
  EXPECT_EQ(fill_rows(far, false).rows.size(), 4u) << "gaps stay, and so do short steps";
}

}  // namespace sample_interpolation_test
}  // namespace coaster::sim
