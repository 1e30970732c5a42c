// Rows whose positions are some milliradians off their Fronts, as beside the ends of tracks in files of NoLimits 2,
// bend a span of one step, but no longer one.
#include "sim/fit/span_partition.h"

#include <gtest/gtest.h>

#include "sim/rows_along.h"

namespace coaster::sim {
namespace span_partition_test {

using glm::dvec3;

FitState work_of(std::vector<FitRow> rows) {
  FitState w;
  w.free.assign(rows.size(), 0);
  w.bends = bend_limits(rows, false);
  w.row_rolls = row_rolls(rows, false);
  w.speeds = row_speeds(rows), w.curvatures = row_curvatures(rows, false);
  w.distances.assign(rows.size(), 0);
  for (std::size_t i = 1; i < rows.size(); ++i)
    w.distances[i] = w.distances[i - 1] + glm::distance(rows[i - 1].position, rows[i].position);
  w.rows = std::move(rows);
  return w;
}

// Rows every 5 cm of a wave of this height. The steps between the last six turn at once, by milliradians times `share`,
// and their Fronts a little later.
std::vector<FitRow> wave_with_an_end(int count, double height, double share) {
  const auto wave = [=](double s) { return dvec3(s, 20, height * std::sin(s / 5)); };
  const auto up = [](double) { return dvec3(0, 1, 0); };
  std::vector<FitRow> rows = test::rows_along(wave, up, 0.05, count);
  double moved = 0;
  std::size_t next = 5;
  for (const double off : {0.0015, 0.0018, 0.0012, 0.0007, 0.0003}) {
    FitRow& row = rows[rows.size() - next--];
    moved += share * off * 0.05;
    row.position += moved * glm::cross(row.up, row.forward);
  }
  return rows;
}

TEST(fit_work, two_steps_take_handles_that_bend_little_where_one_bends_too_much) {
  FitState w = work_of(wave_with_an_end(100, 1.5, 0.9));
  const RollRange all{-0.008, 0.008};
  const SpanFit one = w.fit(97, 98, all), two = w.fit(97, 99, all);
  EXPECT_TRUE(one.within);
  EXPECT_TRUE(one.bent);
  EXPECT_TRUE(two.within);
  EXPECT_FALSE(two.bent);
}

// The first row is 0.3 mm beside the circle of the others, which at that spacing is a bend of 0.06/m to the next one.
TEST(fit_work, a_step_at_an_open_end_bends_within_the_bound_where_a_cubic_can) {
  const auto circle = [](double s) { return 28.0 * dvec3(std::sin(s / 28), 0.7, std::cos(s / 28)); };
  const auto up = [](double) { return dvec3(0, 1, 0); };
  for (const double off : {0.0003, -0.0003}) {
    std::vector<FitRow> rows = test::rows_along(circle, up, 0.25, 40);
    rows[0].position += off * glm::cross(rows[0].up, rows[0].forward);
    FitState w = work_of(std::move(rows));
    const SpanFit first = w.fit(0, 1, {-0.008, 0.008});
    EXPECT_TRUE(first.within) << off;
    EXPECT_FALSE(first.bent) << off;
  }
}

TEST(fit_work, a_span_ends_earlier_where_the_next_one_would_bend_too_much) {
  constexpr std::size_t kRows = 349;  // the longest first span ends five rows before the last
  FitState w = work_of(wave_with_an_end(kRows, 0.5, 1));
  fit_spans(w);
  EXPECT_EQ(w.spans.size(), 2u);
  EXPECT_EQ(w.spans.front().first, 0u);
  for (std::size_t i = 0; i < w.spans.size(); ++i) {
    EXPECT_FALSE(w.spans[i].fit.bent) << "from row " << w.spans[i].first;
    EXPECT_EQ(w.spans[i].last, i + 1 < w.spans.size() ? w.spans[i + 1].first : kRows - 1);
  }
}

}  // namespace span_partition_test
}  // namespace coaster::sim
