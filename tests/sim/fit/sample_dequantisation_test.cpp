#include "sim/fit/sample_dequantisation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coaster::sim {
namespace sample_dequantisation_test {

using glm::dvec3;

dvec3 to_steps(dvec3 v, double step) { return step > 0 ? step * glm::round(v / step) : v; }

// A helix of radius 9 m whose frame leans more and more.
FitRow helix(double s) {
  const double a = s / 10, c = std::cos(a), n = std::sin(a), rise = std::sqrt(0.19);
  const dvec3 forward(0.9 * c, rise, 0.9 * n), lean = curve::rotate({0, 1, 0}, forward, 0.02 * s);
  return {dvec3(9 * n + 3.3, rise * s + 2.7, -9 * c), forward, curve::perpendicular(forward, lean)};
}

struct Off {
  double place = 0, angle = 0, bend = 0;  // m, degrees, 1/m
};

Off off_by(RowSteps steps, double apart) {
  std::vector<FitRow> exact, rows;
  for (double s = 0; s < 80; s += apart) {
    exact.push_back(helix(s));
    const FitRow& row = exact.back();
    const dvec3 forward = glm::normalize(to_steps(row.forward, steps.direction));
    rows.push_back({to_steps(row.position, steps.position), forward,
                    curve::perpendicular(forward, to_steps(row.up, steps.direction))});
  }
  const RowSteps given = steps;
  const UnroundedRows smooth = unrounded_rows(rows, false, steps);
  EXPECT_EQ(steps, given);
  Off off;
  for (std::size_t k = 0; k < smooth.rows.size(); ++k) {
    const FitRow &row = smooth.rows[k], &was = exact[smooth.from[k]];
    const dvec3 miss = row.position - was.position;  // places along the track are the rows' own
    off.place = std::max(off.place, glm::length(curve::across(miss, was.forward)));
    off.angle = std::max(off.angle, frame_angle_deg({row.forward, row.up}, {was.forward, was.up}));
    if (k == 0) continue;
    const FitRow& last = smooth.rows[k - 1];
    const double bend = glm::distance(row.forward, last.forward) / glm::distance(row.position, last.position);
    off.bend = std::max(off.bend, std::abs(bend - 0.09));
  }
  return off;
}

TEST(fit_rounding, rows_of_a_helix_are_found_again_nearer_than_their_steps) {
  for (const double apart : {0.05, 0.5, 1.0})
    for (const RowSteps steps : {RowSteps{0.001, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}, {0.1, 0.1}}) {
      SCOPED_TRACE(testing::Message() << apart << " m apart, " << steps.position << " m, " << steps.direction);
      const Off off = off_by(steps, apart);
      const double turn = std::max({steps.direction, 0.3 * steps.position, 3e-4});
      EXPECT_LT(off.place, std::max(0.75 * steps.position, 2e-4));
      EXPECT_LT(off.angle, 1.2 * glm::degrees(turn));  // of roll and direction together
      EXPECT_LT(off.bend, 0.02);
    }
}

TEST(fit_rounding, exact_and_reversed_rows_leave_nothing) {
  std::vector<FitRow> exact, reversed;
  for (int i = 0; i < 100; ++i) {
    exact.push_back({dvec3(0.5 * i, 4.5, 0), {1, 0, 0}, {0, 1, 0}});
    reversed.push_back({dvec3(-0.5 * i, 4.5, 0), {1, 0, 0}, {0, 1, 0}});
  }
  for (const std::vector<FitRow>& rows : {exact, reversed}) {
    RowSteps steps{0.01, 0};
    EXPECT_TRUE(unrounded_rows(rows, false, steps).rows.empty());
    EXPECT_FALSE(steps.rounded());
  }
}

// Rows of a level ring, closed: the first rows go on where the last ones end. The last row is 3 cm before the first.
TEST(fit_rounding, closed_rows_meet_at_their_seam) {
  std::vector<FitRow> rows;
  for (int i = 0; i < 630; ++i) {
    const double a = 2 * M_PI * i / 629.3, c = std::cos(a), n = std::sin(a);
    const dvec3 forward = glm::normalize(to_steps({c, 0, n}, 0.1));
    rows.push_back({to_steps({10 * n, 4, -10 * c}, 0.1), forward, {0, 1, 0}});
  }
  RowSteps steps{0.1, 0.1};
  const UnroundedRows smooth = unrounded_rows(rows, true, steps);
  ASSERT_GT(smooth.rows.size(), 300u);
  const FitRow &first = smooth.rows.front(), &last = smooth.rows.back();
  for (std::size_t k = 0; k < smooth.rows.size(); ++k)
    EXPECT_GT(glm::distance(smooth.rows[k].position, smooth.rows[(k + 1) % smooth.rows.size()].position), 0.1) << k;
  const double gap = glm::distance(first.position, last.position);
  EXPECT_LT(glm::distance(first.forward, last.forward), 0.13 * gap);
  EXPECT_LT(glm::length(curve::across(first.position - last.position, glm::normalize(first.forward + last.forward))),
            0.01 * gap);
}

}  // namespace sample_dequantisation_test
}  // namespace coaster::sim
