#include "sim/fit/fit_track.h"

#include <thread>

#include <gtest/gtest.h>

#include "base/as_job.h"
#include "base/tries.h"
#include "sim/rows_along.h"

namespace coaster::sim {
namespace fit_track_test {

using glm::dvec3;
using test::rows_along;

const dvec3 kOrigin(113.7, 31.3, -47.9);
dvec3 sky(double) { return {0.01, 1, 0.02}; }

// Checks the bounds by the test's own measure, and that the report agrees with it; returns the fit.
FittedTrack expect_fit(const std::vector<FitRow>& rows, bool closed) {
  FittedTrack fitted = fit_track(rows, closed);
  EXPECT_EQ(world::broken_invariant(fitted.document), std::nullopt);
  EXPECT_EQ(fitted.document.track.closed, closed);
  EXPECT_EQ(fitted.report.knots, static_cast<int>(fitted.document.track.knots.size()));
  EXPECT_LE(fitted.report.max_error, kFitDistance);
  EXPECT_LE(fitted.report.frame_error, kFitAngle);
  const test::Misses misses = test::misses_of(fitted.document, rows);
  // At a knot the report uses the worse of the two sides. A row there is some micrometres from both.
  EXPECT_LE(misses.distance, fitted.report.max_error + 1e-9);
  EXPECT_NEAR(misses.distance, fitted.report.max_error, 1e-5);
  // So it does with angles: handles of 2 cm at 100 m turn by 4e-4 rad when they are rounded to float.
  EXPECT_LE(misses.angle_deg, fitted.report.frame_error + 1e-6);
  EXPECT_NEAR(misses.angle_deg, fitted.report.frame_error, 0.03);
  EXPECT_EQ(fitted.report.distances.count, rows.size());
  EXPECT_NEAR(misses.distance_rms, fitted.report.distances.root(), 1e-5);
  EXPECT_NEAR(misses.angle_rms_deg, fitted.report.angles.root(), 0.01);
  return fitted;
}

double length_of(const FittedTrack& fitted) { return world::exact_length(fitted.document); }

std::function<dvec3(double)> straight(dvec3 direction) {
  return [direction](double s) { return kOrigin + s * glm::normalize(direction); };
}
// Roll by degrees about a straight's direction.
std::function<dvec3(double)> rolled(dvec3 direction, const std::function<double(double)>& degrees) {
  direction = glm::normalize(direction);
  const dvec3 start = curve::perpendicular(direction, {0.1, 1, 0.2});
  return [=](double s) {
    const double a = degrees(s) * M_PI / 180;
    return std::cos(a) * start + std::sin(a) * glm::cross(direction, start);
  };
}

TEST(fit_track, a_straight_takes_two_knots_upside_down_and_vertical_too) {
  for (const dvec3 direction : {dvec3(1, 0.2, -0.3), dvec3(0, 1, 0), dvec3(0, -1, 0)})
    for (const dvec3 up : {dvec3(0.3, 1, 0.1), dvec3(0.2, -1, 0.4)}) {
      const FittedTrack fitted = expect_fit(rows_along(
                                                straight(direction), [=](double) { return up; }, 0.05, 1000),
                                            false);
      EXPECT_EQ(fitted.report.knots, 2);
      EXPECT_NEAR(length_of(fitted), 49.95, 1e-3);
    }
}

TEST(fit_track, an_even_roll_of_many_turns_takes_two_knots_and_whole_turns) {
  const dvec3 direction(0.6, 0.1, 0.7);
  for (const double turns : {2.37, -3.81}) {
    const auto up = rolled(direction, [=](double s) { return 360 * turns * s / 60; });
    const FittedTrack fitted = expect_fit(rows_along(straight(direction), up, 0.05, 1201), false);
    EXPECT_EQ(fitted.report.knots, 2);
    EXPECT_NE(world::segment(fitted.document, fitted.document.track.segments[0]).turns, 0);
  }
}

TEST(fit_track, a_roll_by_a_parabola_takes_one_span_and_one_that_wavers_a_few) {
  const dvec3 direction(0.6, 0.1, 0.7);
  const auto up = rolled(direction, [](double s) { return 60 * s * s / 1600; });
  const FittedTrack fitted = expect_fit(rows_along(straight(direction), up, 0.05, 801), false);
  EXPECT_LE(fitted.report.knots, 3);  // the spin at an end is half a step off: at most one more
  // A sine of 30 degrees with 4 half waves: the error of a Hermite over h is h^4 f/384, f = 30 (4 pi / 40)^4:
  // 6.4 m for half a degree at the crests.
  const auto wave = rolled(direction, [](double s) { return 30 * std::sin(4 * M_PI * s / 40); });
  const FittedTrack waved = expect_fit(rows_along(straight(direction), wave, 0.05, 801), false);
  EXPECT_GE(waved.report.knots, 4);
  EXPECT_LE(waved.report.knots, 8);
}

TEST(fit_track, a_helix_and_a_corkscrew_take_a_knot_every_five_metres_or_less_often) {
  const double radius = 11.3, climb = 0.13;
  const double scale = 1 / std::sqrt(radius * radius + climb * climb * radius * radius);
  const auto helix = [=](double s) {
    const double a = s * scale;
    return kOrigin + dvec3(radius * std::cos(a), climb * radius * a, radius * std::sin(a));
  };
  const FittedTrack fitted = expect_fit(rows_along(helix, sky, 0.05, 3001), false);
  EXPECT_LE(fitted.report.knots, 30);
  EXPECT_GE(fitted.report.knots, 8);  // a cubic cannot go three times round
  EXPECT_NEAR(length_of(fitted), 150, 0.05);
  // Round a horizontal axis, heads to the axis: upside down at the top, and never far from vertical in between.
  const double small = 3.1, along = 0.9;
  const double step = 1 / (small * std::sqrt(1 + along * along));
  const auto screw = [=](double s) {
    const double a = s * step;
    return kOrigin + dvec3(along * small * a, -small * std::cos(a), small * std::sin(a));
  };
  const auto inwards = [=](double s) { return dvec3(0, std::cos(s * step), -std::sin(s * step)); };
  const FittedTrack corkscrew = expect_fit(rows_along(screw, inwards, 0.05, 1200), false);
  EXPECT_LE(corkscrew.report.knots, 60);
}

TEST(fit_track, progress_changes_nothing_grows_to_the_end_and_can_be_cancelled) {
  const auto place = [](double s) { return glm::dvec3(20 * std::cos(s / 25), 8 + s / 30, 20 * std::sin(s / 25)); };
  const auto rows = test::rows_along(
      place, [](double) { return glm::dvec3(0, 1, 0); }, 0.2, 2000);
  base::JobProgress progress;
  const FittedTrack watched = test::as_job(progress, [&] { return fit_track(rows, false); }),
                    alone = fit_track(rows, false);
  EXPECT_TRUE(watched.document == alone.document);
  EXPECT_EQ(progress.done, 1.0);
  base::JobProgress cancelled;
  cancelled.cancelled = true;
  EXPECT_TRUE(test::as_job(cancelled, [&] { return fit_track(rows, false); }).document.track.knots.empty());
  EXPECT_EQ(cancelled.done, 0.0);
  // Cancelled by another thread, while it works.
  base::JobProgress halfway;
  std::thread canceller([&] {
    while (halfway.done == 0) std::this_thread::yield();
    halfway.cancelled = true;
  });
  const FittedTrack broken_off = test::as_job(halfway, [&] { return fit_track(rows, false); });
  canceller.join();
  EXPECT_TRUE(broken_off.document.track.knots.empty() || halfway.done == 1.0);  // it may have been done by then
}

TEST(fit_track, a_closed_loop_closes_exactly_whatever_step_is_left) {
  const double radius = 9.7;
  const auto circle = [=](double s) {
    return kOrigin + radius * dvec3(std::sin(s / radius), -std::cos(s / radius), 0.0);
  };
  const auto inwards = [=](double s) { return dvec3(-std::sin(s / radius), std::cos(s / radius), 0.0); };
  const int count = static_cast<int>(2 * M_PI * radius / 0.05) + 1;  // 1219 rows; the last step is 0.0168 m
  const std::vector<FitRow> rows = rows_along(circle, inwards, 0.05, count);
  ASSERT_TRUE(rows_close(rows));
  const FittedTrack fitted = expect_fit(rows, true);
  EXPECT_LE(fitted.report.knots, 12);
  EXPECT_NEAR(length_of(fitted), 2 * M_PI * radius, 0.05);
  EXPECT_EQ(fitted.document.track.segments.size(), fitted.document.track.knots.size());
}

TEST(fit_track, only_rows_that_lead_back_to_the_first_one_close) {
  const auto circle = [](double s) { return kOrigin + 9.7 * dvec3(std::sin(s / 9.7), 0, std::cos(s / 9.7)); };
  const std::vector<FitRow> all = rows_along(circle, sky, 0.05, 1219);
  EXPECT_TRUE(rows_close(all));
  EXPECT_FALSE(rows_close(std::vector<FitRow>(all.begin(), all.end() - 2)));
  EXPECT_FALSE(rows_close(std::vector<FitRow>(all.begin(), all.begin() + 600)));
  EXPECT_FALSE(rows_close(rows_along(circle, sky, 0.05, 1224)));  // beyond the first row
  EXPECT_FALSE(rows_close(rows_along(straight({1, 0, 0}), sky, 0.05, 3)));
}

TEST(fit_track, a_jump_of_up_costs_a_few_knots_and_nothing_beyond_half_a_metre) {
  const dvec3 direction(0.6, 0.1, 0.7);
  const auto up = rolled(direction, [](double s) { return s < 20.02 ? 0.0 : 40.0; });
  const std::vector<FitRow> rows = rows_along(straight(direction), up, 0.05, 801);
  EXPECT_LE(expect_fit(rows, false).report.knots, 6);
  const std::vector<char> near = near_jumps(rows, false, kJumpReach);
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(near[i] != 0, std::abs(0.05 * static_cast<double>(i) - 20.025) <= 0.5) << i;
}

TEST(fit_track, a_quick_roll_is_no_jump_and_is_followed_at_every_row) {
  // 90 degrees within 1.6 m, at up to 105 degrees/m, which changes by no more than 15 from row to row.
  const dvec3 direction(0.6, 0.1, 0.7);
  const auto up = rolled(direction, [](double s) {
    const double u = std::clamp((s - 9.98) / 1.6, 0.0, 1.0);
    return 90 * u * u * u * (10 - 15 * u + 6 * u * u);
  });
  for (const double step : {0.05, 0.1}) {
    const std::vector<FitRow> rows = rows_along(straight(direction), up, step, static_cast<int>(20 / step));
    const std::vector<double> jumps = row_jumps(rows, false);
    EXPECT_EQ(*std::max_element(jumps.begin(), jumps.end()), 0) << step;
    const FittedTrack fitted = fit_track(rows, false);
    EXPECT_EQ(fitted.report.jump_error, 0) << step;
    EXPECT_LE(test::misses_of(fitted.document, rows).angle_deg, kFitAngle) << step;
  }
}

TEST(fit_track, a_jump_at_the_seam_of_a_closed_track_is_near_on_both_sides_of_it) {
  const auto circle = [](double s) { return kOrigin + 9.7 * dvec3(std::sin(s / 9.7), 0, std::cos(s / 9.7)); };
  const auto up = [](double s) {
    return s < 30 ? dvec3(0, 1, 0) : dvec3(0.5 * std::sin(s / 9.7), 1, 0.5 * std::cos(s / 9.7));
  };
  const std::vector<FitRow> rows =
      rows_along(circle, up, 0.05, 1219);  // leans from row 600 on, and jumps back at the seam
  const std::vector<char> near = near_jumps(rows, true, kJumpReach);
  const std::vector<bool> counted = test::counted_rows(rows, true);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(near[i] != 0, !counted[i]) << i;
  EXPECT_TRUE(near[0] && near[9] && !near[10] && near[1218] && near[1209] && !near[1208] && near[600] && near[599]);
  expect_fit(rows, true);
}

TEST(fit_track, corners_and_gaps_of_the_rows_are_within_a_centimetre_still) {
  const auto corner = [](double s) {
    return kOrigin + (s < 20.02 ? dvec3(s, 0, 0) : dvec3(20.02 + (s - 20.02) * 0.8, 0, (s - 20.02) * 0.6));
  };
  expect_fit(rows_along(corner, sky, 0.05, 801), false);
  const auto gap = [](double s) { return kOrigin + dvec3(s, 0, s < 20.02 ? 0.0 : 0.7); };
  expect_fit(rows_along(gap, sky, 0.05, 801), false);
}

TEST(fit_track, rows_far_apart_and_few_rows_are_met_exactly) {
  const auto circle = [](double s) { return kOrigin + 30.0 * dvec3(std::sin(s / 30), 0.2 * s / 30, std::cos(s / 30)); };
  expect_fit(rows_along(circle, sky, 5, 40), false);
  const FittedTrack two = expect_fit(rows_along(circle, sky, 5, 2), false);
  EXPECT_EQ(two.report.knots, 2);
}

TEST(fit_track, rows_closer_than_the_shortest_handle_are_passed_over) {
  const auto circle = [](double s) { return kOrigin + 30.0 * dvec3(std::sin(s / 30), 0.2 * s / 30, std::cos(s / 30)); };
  EXPECT_LE(expect_fit(rows_along(circle, sky, 0.001, 4000), false).report.knots, 3);
}

TEST(fit_track, no_knot_is_a_short_step_before_the_end) {
  // Open tracks of rising length: wherever the last span but one would end, the last one is long enough for its
  // handles.
  const auto wave = [](double s) { return kOrigin + dvec3(s, 3 * std::sin(s / 7), 2 * std::cos(s / 5)); };
  for (int count = 300; count < 300 + test::tries(120); ++count) {
    const FittedTrack fitted = fit_track(rows_along(wave, sky, 0.05, count), false);
    const auto& knots = fitted.document.track.knots;
    const glm::vec3 a = world::knot(fitted.document, knots[knots.size() - 2]).position,
                    b = world::knot(fitted.document, knots.back()).position;
    EXPECT_GE(glm::distance(a, b), 0.05f) << count;
  }
}

TEST(fit_track, the_same_rows_give_the_same_bits) {
  const auto wave = [](double s) { return kOrigin + dvec3(s, 3 * std::sin(s / 7), 2 * std::cos(s / 5)); };
  const std::vector<FitRow> rows = rows_along(wave, sky, 0.05, 1000);
  EXPECT_EQ(world::hash(fit_track(rows, false).document), world::hash(fit_track(rows, false).document));
  EXPECT_LE(expect_fit(rows, false).report.knots, 30);
}

TEST(fit_track, frame_angles_are_those_of_the_rotation) {
  const curve::Frame a{{1, 0, 0}, {0, 1, 0}};
  EXPECT_NEAR(frame_angle_deg(a, {{1, 0, 0}, {0, -1, 0}}), 180, 1e-9);
  const double t = 0.013;
  EXPECT_NEAR(frame_angle_deg(a, {{std::cos(t), std::sin(t), 0}, {-std::sin(t), std::cos(t), 0}}), t * 180 / M_PI,
              1e-9);
  EXPECT_EQ(frame_angle_deg(a, a), 0);
}

}  // namespace fit_track_test
}  // namespace coaster::sim
