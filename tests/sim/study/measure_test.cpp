#include "sim/study/measure.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/tracks.h"
#include "world/evaluation.h"

namespace coaster::sim {
namespace measure_test {

// A clock that counts: each reading is `step` seconds after the one before.
struct Counter {
  double now = 0, step = 1;
  int readings = 0;
  Clock clock() {
    return [this] {
      ++readings;
      return now += step;
    };
  }
};

Measurement finished(const Derived& derived, const Clock& clock) {
  Measurement m = start_measurement(derived);
  for (int i = 0; i < 1000 && m.running; ++i) measure_next(m, clock);
  return m;
}

std::size_t processor_rows() {
  std::size_t rows = 0;
  for (const curve::Evaluator& e : curve::evaluators()) rows += e.evaluated_by == curve::EvaluatedBy::processor;
  return rows;
}

TEST(measure, nothing_runs_that_was_not_asked_for) {
  Measurement m;
  Counter counter;
  measure_next(m, counter.clock());
  EXPECT_EQ(counter.readings, 0);
  EXPECT_EQ(progress(m), 0);
  EXPECT_TRUE(m.rows.empty());
}

TEST(measure, an_empty_track_has_nothing_to_measure) {
  const Measurement m = start_measurement(test::derived_of(world::Document{}));
  EXPECT_FALSE(m.running);
  EXPECT_TRUE(m.rows.empty());
}

TEST(measure, every_processor_row_is_measured_at_every_number_of_steps) {
  const Derived derived = test::derived_of(test::ring_document(5, 23.7));
  Counter counter;
  const Measurement m = finished(derived, counter.clock());
  EXPECT_FALSE(m.running);
  EXPECT_EQ(progress(m), 1);
  ASSERT_EQ(m.rows.size(), processor_rows());
  for (const MeasuredRow& row : m.rows) {
    EXPECT_EQ(base::row_of(row.evaluator).evaluated_by, curve::EvaluatedBy::processor);
    for (std::size_t i = 0; i < kMeasuredSteps.size(); ++i) {
      const MeasuredCell& cell = row.cells[i];
      EXPECT_EQ(cell.rounds, kMeasureRounds);
      // Two readings, one second apart, around at least kMeasuredPoints points of whole polylines.
      const int vertices = kMeasuredSteps[i] + 1, segments = std::max(1, kMeasuredPoints / vertices);
      EXPECT_NEAR(cell.ns_per_point, 1e9 / (segments * vertices), 1e-6);
    }
  }
  EXPECT_EQ(counter.readings, 2 * kMeasureRounds * static_cast<int>(kMeasuredSteps.size() * processor_rows()));
  EXPECT_NE(m.checksum, 0);
}

TEST(measure, the_cell_is_the_median_of_its_rounds) {
  const Derived derived = test::derived_of(test::ring_document(5, 23.7));
  double now = 0;
  int reading = 0;
  // Every third round takes a hundred times as long: the median does not care.
  const int per_round = 2 * static_cast<int>(kMeasuredSteps.size() * processor_rows());
  const Clock clock = [&] { return now += (reading++ / per_round) % 3 == 2 ? 100.0 : 1.0; };
  const Measurement m = finished(derived, clock);
  const int segments = kMeasuredPoints / 17;
  for (const MeasuredRow& row : m.rows) EXPECT_NEAR(row.cells[0].ns_per_point, 1e9 / (segments * 17), 1e-6);
}

TEST(measure, the_worst_error_is_that_of_the_worst_vertex) {
  const Derived derived = test::derived_of(test::ring_document(5, 23.7));
  const Measurement m = finished(derived, {});
  const auto id = *base::value_named<curve::EvaluatorId>("forward_differences");
  const MeasuredRow* const row = row_of(m, id);
  ASSERT_NE(row, nullptr);
  for (std::size_t i = 0; i < kMeasuredSteps.size(); ++i) {
    // What derive() finds for the same evaluator and steps.
    world::Settings settings;
    settings.evaluation->evaluator = id, settings.evaluation->steps = kMeasuredSteps[i];
    EXPECT_DOUBLE_EQ(row->cells[i].worst_error, test::derived_of(test::ring_document(5, 23.7), settings).deviation);
    EXPECT_EQ(row->cells[i].ns_per_point, 0);  // no clock, no time
  }
  EXPECT_GT(row->cells[4].worst_error, 3 * row->cells[0].worst_error);
}

TEST(measure, stopping_keeps_what_is_done) {
  const Derived derived = test::derived_of(test::ring_document(5, 23.7));
  Counter counter;
  Measurement m = start_measurement(derived);
  for (int i = 0; i < 2; ++i) measure_next(m, counter.clock());
  m.running = false;
  const int readings = counter.readings;
  measure_next(m, counter.clock());
  EXPECT_EQ(counter.readings, readings);
  EXPECT_EQ(m.next, 2);
  EXPECT_NEAR(progress(m), 2.0 / (kMeasureRounds * 5), 1e-12);
  for (const MeasuredRow& row : m.rows) {
    EXPECT_EQ(row.cells[1].rounds, 1);
    EXPECT_EQ(row.cells[2].rounds, 0);
  }
  const std::string csv = to_csv(m, "a machine");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2 + 2 * static_cast<std::ptrdiff_t>(m.rows.size()));
}

TEST(measure, few_curves_stand_for_a_long_track) {
  EXPECT_EQ(start_measurement(test::derived_of(test::ring_document(40, 90))).curves.size(), kMeasuredCurves);
  EXPECT_EQ(start_measurement(test::derived_of(test::ring_document(3, 20))).curves.size(), 3u);
}

TEST(measure, csv_is_a_header_and_a_line_a_cell) {
  Measurement m;
  MeasuredRow row;
  row.evaluator = *base::value_named<curve::EvaluatorId>("horner");
  row.cells[1] = {3.25, 1.5e-6, 9};
  m.rows.push_back(row);
  EXPECT_EQ(
      to_csv(m, "Some processor; gcc"),
      "# Some processor; gcc\r\nevaluator,steps,ns_per_point,worst_error_m,rounds\r\nhorner,64,3.25,1.5e-06,9\r\n");
}

}  // namespace measure_test
}  // namespace coaster::sim
