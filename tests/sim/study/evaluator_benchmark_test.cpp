#include "sim/study/evaluator_benchmark.h"

#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "exchange/formats.h"
#include "sim/tracks.h"
#include "world/evaluation_settings.h"

namespace coaster::sim {
namespace evaluator_benchmark_test {

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

Measurement finished(const DerivedTrack& derived, const Clock& clock) {
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

TEST(measure, every_row_is_measured_at_every_number_of_steps) {
  const DerivedTrack derived = test::derived_of(test::ring_document(5, 23.7));
  Counter counter;
  const Measurement m = finished(derived, counter.clock());
  EXPECT_FALSE(m.running);
  EXPECT_EQ(progress(m), 1);
  ASSERT_EQ(m.rows.size(), curve::evaluators().size());
  for (const MeasuredRow& row : m.rows) {
    for (std::size_t i = 0; i < kMeasuredSteps.size(); ++i) {
      const MeasuredCell& cell = row.cells[i];
      EXPECT_EQ(cell.rounds, kMeasureRounds);
      // Two readings, one second apart, around at least kMeasuredPoints points of whole polylines.
      const int vertices = kMeasuredSteps[i] + 1, segments = std::max(1, kMeasuredPoints / vertices);
      EXPECT_NEAR(cell.ns_per_point, row.is_timed() ? 1e9 / (segments * vertices) : 0, 1e-6);
      EXPECT_GT(cell.worst_error, 0);
    }
  }
  EXPECT_EQ(counter.readings, 2 * kMeasureRounds * static_cast<int>(kMeasuredSteps.size() * processor_rows()));
  EXPECT_NE(m.checksum, 0);
}

TEST(measure, the_cell_is_the_median_of_its_rounds) {
  const DerivedTrack derived = test::derived_of(test::ring_document(5, 23.7));
  double now = 0;
  int reading = 0;
  // Every third round takes a hundred times as long: the median does not care.
  const int per_round = 2 * static_cast<int>(kMeasuredSteps.size() * processor_rows());
  const Clock clock = [&] { return now += (reading++ / per_round) % 3 == 2 ? 100.0 : 1.0; };
  const Measurement m = finished(derived, clock);
  const int segments = kMeasuredPoints / 17;
  for (const MeasuredRow& row : m.rows)
    EXPECT_NEAR(row.cells[0].ns_per_point, row.is_timed() ? 1e9 / (segments * 17) : 0, 1e-6);
}

TEST(measure, the_worst_error_is_that_of_the_worst_vertex) {
  const DerivedTrack derived = test::derived_of(test::ring_document(5, 23.7));
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
  const DerivedTrack derived = test::derived_of(test::ring_document(5, 23.7));
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

world::Document sample(const std::string& name) {
  base::Files files;
  auto track = exchange::load_track(files, std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  EXPECT_TRUE(track) << name;
  return std::move(track->document);
}

// The largest error over all segments and vertices, of each row on its own.
double brute_force(const DerivedTrack& derived, const curve::Evaluator& evaluator, int steps) {
  double worst = 0;
  std::vector<glm::vec3> points(static_cast<std::size_t>(steps) + 1);
  for (const world::Entity segment : derived.order) {
    const SegmentShape& shape = derived.shape(segment);
    evaluator.polyline(shape.curve, points, {});
    for (int i = 0; i <= steps; ++i)
      worst = std::max(worst, glm::length(glm::dvec3(points[static_cast<std::size_t>(i)]) -
                                          curve::point_long_double(shape.key.cubic, static_cast<double>(i) / steps)));
  }
  return worst;
}

// More segments than are timed; on the ring the errors of 4096 steps take several parts.
TEST(measure, the_errors_are_the_largest_of_all_segments) {
  for (const world::Document& document : {sample("loop"), sample("kingfisher"), test::ring_document(70, 300)}) {
    const DerivedTrack derived = test::derived_of(document);
    EXPECT_GT(derived.order.size(), kTimedCurves);
    const Measurement m = finished(derived, {});
    EXPECT_EQ(progress(m), 1);
    for (const MeasuredRow& row : m.rows)
      for (std::size_t i = 0; i < kMeasuredSteps.size(); ++i)
        EXPECT_DOUBLE_EQ(row.cells[i].worst_error, brute_force(derived, base::row_of(row.evaluator), kMeasuredSteps[i]))
            << base::name_of(row.evaluator) << "/" << kMeasuredSteps[i];
  }
}

TEST(measure, a_part_is_short_on_a_long_track) {
  Measurement m = start_measurement(test::derived_of(test::ring_document(7000, 30'000)));
  measure_next(m, {});
  EXPECT_EQ(m.searched, 0u);  // 7000 x 17 points are one part
  measure_next(m, {});
  EXPECT_EQ(m.searched, static_cast<std::size_t>(kErrorPoints / 65));  // of 64 steps
  EXPECT_EQ(m.rows[0].cells[0].rounds, 1);
  EXPECT_EQ(m.rows[0].cells[1].rounds, 0);
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
  m.rows[0].evaluator = *base::value_named<curve::EvaluatorId>("gpu_vertex");
  EXPECT_NE(to_csv(m, "").find("\r\ngpu_vertex,64,,1.5e-06,9\r\n"), std::string::npos);
}

}  // namespace evaluator_benchmark_test
}  // namespace coaster::sim
