// Fits neither fold nor have more curvature than their rows, at any spacing.
#include <functional>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/bends_of.h"
#include "sim/fit/fit_track.h"
#include "sim/fit/sample_interpolation.h"
#include "sim/rows_along.h"
#include "sim/study/jolt.h"
#include "world/topology.h"

namespace coaster::sim {
namespace fit_bends_test {

using glm::dvec3;

using Rate = std::function<double(double)>;
double none(double) { return 0; }
// Rises from 0 to 1 between two places.
double ramp(double s, double from, double to) { return std::clamp((s - from) / (to - from), 0.0, 1.0); }

// Rises smoothly from 0 to 1 and falls again, within a length.
double swell(double s, double from, double length) {
  return 0.5 - 0.5 * std::cos(2 * M_PI * ramp(s, from, from + length));
}

// Curvatures upwards and to the left (1/m), and the roll (radians) of a track of some length.
struct Shape {
  const char* name;
  double length;
  Rate pitch, yaw, roll;
};

double printed(double x) { return std::round(x * 1e6) / 1e6; }
dvec3 printed(dvec3 v) { return {printed(v.x), printed(v.y), printed(v.z)}; }

// Rows with six decimals, integrated in steps of 1 mm.
std::vector<FitRow> rows_of(const Shape& shape, double spacing) {
  std::vector<FitRow> rows;
  dvec3 position(113.7, 31.3, -47.9), forward = glm::normalize(dvec3(1, 0.1, 0.3)),
                                      up = curve::perpendicular(forward, {0, 1, 0});
  const double h = 0.001;
  for (int i = 0; i * h <= shape.length; ++i) {
    const double s = i * h;
    if (s >= spacing * static_cast<double>(rows.size()) - 1e-9) {
      const dvec3 front = glm::normalize(printed(forward));
      rows.push_back(
          {printed(position), front, curve::perpendicular(front, printed(curve::rotate(up, forward, shape.roll(s))))});
    }
    const dvec3 turn = shape.pitch(s + h / 2) * up + shape.yaw(s + h / 2) * glm::cross(up, forward);
    position += h * glm::normalize(forward + h / 2 * turn);
    forward = glm::normalize(forward + h * turn);
    up = curve::perpendicular(forward, up);
  }
  return rows;
}

const Shape kShapes[] = {
    {"circle", 62, none, [](double) { return 1 / 9.7; }, none},
    {"clothoid loop", 110, [](double s) { return (ramp(s, 20, 45) - ramp(s, 55, 80)) / 7; },
     [](double) { return 0.01; }, none},
    {"rolled straight", 80, none, none,
     [](double s) { return 2 * M_PI * std::pow(ramp(s, 20, 60), 2) * (3 - 2 * ramp(s, 20, 60)); }},
    {"hills", 150, [](double s) { return 0.08 * std::sin(s / 6); }, [](double s) { return 0.05 * std::sin(s / 11); },
     [](double s) { return 0.6 * std::sin(s / 11); }},
    {"bends and straights", 150,
     [](double s) {
       return 0.045 * (swell(s, 12, 18) + swell(s, 84, 16) - swell(s, 104, 16)) - 0.03 * swell(s, 44, 30);
     },
     [](double s) { return 0.02 * swell(s, 120, 20); }, none},
    {"banked bend", 60, none, [](double s) { return s > 20 && s < 35 ? 0.1 : 0.0; },
     [](double s) { return 0.8 * (ramp(s, 18, 22) - ramp(s, 33, 37)); }},
};

TEST(fit_bends, tracks_bend_little_more_than_their_rows_at_any_spacing) {
  int i = 0;
  for (const Shape& shape : kShapes)
    for (const double spacing : {0.05, 0.5, 1.0, 1.5, 2.0, 4.0, 5.0}) {
      if (!test::tried(i++)) continue;
      SCOPED_TRACE(std::string(shape.name) + ", rows every " + std::to_string(spacing) + " m");
      const std::vector<FitRow> rows = rows_of(shape, spacing);
      const FittedTrack fitted = fit_track(rows, false);
      const test::Bends bends = test::bends_of(fitted.document, rows);
      EXPECT_EQ(bends.folds, 0);
      EXPECT_LE(bends.excess, 1) << bends.at;
      EXPECT_LE(bends.handle, 0.5);
      const test::Misses misses = test::misses_of(fitted.document, rows);
      EXPECT_LE(misses.distance, kFitDistance);
      EXPECT_LE(misses.angle_deg, kFitAngle);
    }
}

// Of a train that starts at 20 m/s and keeps within 10 % of it.
double largest_jolt(world::Document document) {
  world::add_cart(document, document.track.segments[0], 0);
  document.start_speed = 20;
  const DerivedTrack derived = shapes_of(document);
  RideCache cache;
  const SimulatedRide* const simulated = cache.ride(document, derived, world::first_cart(document));
  double most = 0;
  for (const Jolt& jolt : jolts(*simulated, 5)) most = std::max(most, jolt.total);
  return most;
}

TEST(fit_bends, joints_of_smooth_tracks_jolt_little_at_any_spacing_of_rows) {
  int i = 0;
  for (const Shape& shape : std::span(kShapes).first<5>())
    for (const double spacing : {0.05, 0.5, 1.0, 1.5, 2.0, 4.0, 5.0}) {
      if (!test::tried(i++)) continue;
      EXPECT_LT(largest_jolt(fit_track(rows_of(shape, spacing), false).document), 1.1)
          << shape.name << ", rows every " << spacing << " m";
    }
}

TEST(fit_bends, limits_are_those_of_the_largest_bend_within_two_metres) {
  const Shape& bend = kShapes[5];
  const std::vector<double> limits = bend_limits(rows_of(bend, 0.25), false);
  ASSERT_EQ(limits.size(), 240u);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double s = 0.25 * static_cast<double>(i);
    // A step may bend as the bend does if all of it is within 2 m of it.
    if (s > 18.01 && s < 36.74) {
      EXPECT_NEAR(limits[i], 1.5 * 0.1 + 0.005, 1e-4) << s;
    } else if (s < 17.74 || s > 37.01) {
      EXPECT_NEAR(limits[i], 0.005, 1e-4) << s;
    }
  }
  // Once round a ring: the bend is near its seam on both sides.
  std::vector<FitRow> ring;
  for (int i = 0; i < 100; ++i) {
    const double a = 2 * M_PI * i / 100, r = 10.5 / M_PI;
    ring.push_back({{r * std::cos(a), 0, r * std::sin(a)}, {-std::sin(a), 0, std::cos(a)}, {0, 1, 0}});
  }
  ring[0].forward = glm::normalize(ring[0].forward + dvec3(0, 0.02, 0));
  const std::vector<double> round = bend_limits(ring, true);
  const double sharp = round[0];
  EXPECT_GT(sharp, round[50]);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(round[i] == sharp, i <= 9 || i >= 90) << i;
}

// Rows at the crests and troughs of waves: their directions are all the same, though each has the wave's largest
// curvature.
TEST(fit_bends, limits_allow_bends_to_either_side_within_a_step) {
  for (const auto& [length, height] : {std::pair(6.0, 0.1), {8.0, 0.3}, {10.0, 0.4}, {14.0, 0.5}}) {
    const double k = 2 * M_PI / length;
    std::vector<FitRow> rows;
    for (int i = 0; i < 12; ++i)
      rows.push_back({{3.7 + 0.5 * length * i, 11.3, (i % 2 == 0 ? 1 : -1) * height}, {1, 0, 0}, {0, 1, 0}});
    const std::vector<double> limits = bend_limits(rows, false);
    for (std::size_t i = 3; i + 3 < limits.size(); ++i) {
      EXPECT_GE(limits[i], height * k * k) << length;
      EXPECT_LE(limits[i], 2 * height * k * k) << length;
    }
  }
}

// Rows on a circle of radius 9.7 m whose plane is tilted, in uneven steps of up to `step` m.
std::vector<FitRow> circle_rows(double step, double angle) {
  const dvec3 u = glm::normalize(dvec3(1, 0.4, -0.2)), v = glm::normalize(glm::cross(u, {0.3, -0.2, 1}));
  std::vector<FitRow> rows;
  for (double a = 0.3; a < 0.3 + angle - 1e-6; a += (rows.size() % 3 == 0 ? 0.7 : 1.0) * step / 9.7) {
    const dvec3 forward = std::cos(a) * v - std::sin(a) * u;
    rows.push_back({9.7 * (std::cos(a) * u + std::sin(a) * v), forward, glm::cross(u, v)});
  }
  return rows;
}

TEST(fit_bends, rows_have_the_curvature_of_the_circle_they_are_on) {
  // Toward the centre, within the arc's length, which is known to the fourth power of the spacing.
  for (const auto& [step, inner, ends] :
       {std::tuple(0.05, 3e-7, 3e-7), {1.0, 2e-6, 2e-6}, {2.0, 2e-6, 2e-6}, {4.0, 2e-5, 2e-5}, {9.7, 5e-4, 5e-4}}) {
    const std::vector<FitRow> rows = circle_rows(step, 4);
    const std::vector<dvec3> curvatures = row_curvatures(rows, false);
    ASSERT_EQ(curvatures.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double s = glm::distance(rows[i].position, rows.front().position),
                   e = glm::distance(rows[i].position, rows.back().position);
      const bool end = i == 0 || i + 1 == rows.size() || s < 1.1 || e < 1.1;
      EXPECT_NEAR(glm::distance(curvatures[i], rows[i].position / (-9.7 * 9.7)), 0, end ? ends : inner)
          << step << " m, row " << i;
    }
  }
  const std::vector<FitRow> ring = circle_rows(2, 2 * M_PI);
  for (std::size_t i = 0; i < ring.size(); ++i)
    EXPECT_NEAR(glm::distance(row_curvatures(ring, true)[i], ring[i].position / (-9.7 * 9.7)), 0, 1e-5) << i;
}

// Rows on a level curve of 60 m with the given curvature to the left, from `start` on in uneven steps of up to `far` m.
struct LevelRows {
  template <class Curvature>
  LevelRows(Curvature curvature, double start, double far) {
    constexpr double kStep = 1e-3;
    double heading = 0, next = start;
    dvec3 place(0);
    for (double s = 0; s < 60; s += kStep) {
      if (s >= next) {
        rows.push_back({place, {std::cos(heading), 0, -std::sin(heading)}, {0, 1, 0}});
        expected.push_back(curvature(s));
        next += rows.size() % 3 == 0 ? 0.7 * far : far;
      }
      const double middle = heading + 0.5 * kStep * curvature(s + 0.5 * kStep);
      place += kStep * dvec3(std::cos(middle), 0, -std::sin(middle));
      heading += kStep * curvature(s + 0.5 * kStep);
    }
  }
  // The largest difference between the rows' curvatures and the curve's, but for the ends.
  double error() const {
    const std::vector<dvec3> found = row_curvatures(rows, false);
    double most = 0;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i)
      most = std::max(most, std::abs(glm::dot(found[i], glm::cross(rows[i].up, rows[i].forward)) - expected[i]));
    return most;
  }
  std::vector<FitRow> rows;
  std::vector<double> expected;
};

TEST(fit_bends, rows_beside_a_bend_that_begins_or_ends_between_rows_do_not_swing) {
  const auto bend = [](double s) { return 0.034 * std::clamp(std::min(s - 20, 28 - s) / 3, 0.0, 1.0); };
  for (double start = 0; start < 16; start += 0.31) EXPECT_LT(LevelRows(bend, start, 5.9).error(), 0.0058) << start;
}

TEST(fit_bends, rows_have_the_curvature_of_a_smooth_curve_beside_open_ends_too) {
  const auto smooth = [](double s) { return 0.06 * std::cos(s / 8); };
  for (double start = 0; start < 5; start += 0.31) EXPECT_LT(LevelRows(smooth, start, 4).error(), 1e-3) << start;
}

TEST(fit_bends, rows_far_apart_have_the_spin_of_a_smooth_roll_and_its_slope) {
  // Left and right on a level circle of radius 9 m, open or closed.
  constexpr double kRound = 18 * M_PI;
  for (const bool closed : {false, true}) {
    std::vector<FitRow> rows;
    std::vector<double> places;
    for (double x = 0; x < kRound - 2; x += rows.size() % 3 == 0 ? 2.2 : 3.1) {
      const double roll = 0.7 * std::sin(x / 9), a = x / 9;
      const dvec3 forward(std::cos(a), 0, std::sin(a));
      rows.push_back({9.0 * dvec3(std::sin(a), 0, -std::cos(a)), forward, curve::rotate({0, 1, 0}, forward, roll)});
      places.push_back(x);
    }
    const RowRolls found = row_rolls(rows, closed);
    ASSERT_EQ(found.spins.size(), rows.size());
    ASSERT_EQ(found.slopes.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      // A natural spline misses the second derivative at open ends; from row to row that falls to about a quarter.
      const std::size_t inward = closed ? rows.size() : std::min(i, rows.size() - 1 - i);
      const double end = 6e-3 * std::pow(0.27, static_cast<double>(inward));
      EXPECT_NEAR(found.spins[i], 0.7 / 9 * std::cos(places[i] / 9), end + 6e-4) << i;
      EXPECT_NEAR(found.slopes[i], -0.7 / 81 * std::sin(places[i] / 9), end + 4e-4) << i;
    }
  }
}

TEST(fit_bends, a_train_passes_the_highest_row_at_ten_metres_a_second) {
  const std::vector<double> speeds = row_speeds(std::vector<FitRow>{{{0, 3, 0}}, {{1, 8, 0}}, {{2, -4.5, 0}}});
  for (const auto& [i, height] : {std::pair(0, 5.0), {1, 0.0}, {2, 12.5}})
    EXPECT_NEAR(speeds[i] * 9.81, 100 + 2 * 9.81 * height, 1e-9);
}

}  // namespace fit_bends_test
}  // namespace coaster::sim
