// Rows with few decimals, against the tracks that they were taken from.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "base/as_job.h"
#include "base/tries.h"
#include "exchange/nolimits/nl2_csv.h"
#include "exchange/nolimits/nl2_header.h"
#include "exchange/nolimits/nl2_rounded.h"
#include "exchange/nolimits/nl2_spline.h"
#include "sim/ride/simulated_ride.h"
#include "sim/study/ratings.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace nl2_csv_rounded_test {

using test::Rounding;

// A sample without its equipment and losses, at a speed that takes a car round.
world::Document sample_track(const std::string& name, double speed) {
  std::ifstream in(std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  std::ostringstream file;
  file << in.rdbuf();
  world::Document document = parse_track(file.str(), name)->document;
  for (const world::Entity segment : document.track.segments) document.entities.pool<world::Equipment>().erase(segment);
  document.entities.pool<world::Train>().put(world::first_cart(document), {document.track.segments[0]});
  document.resistance = {};
  document.start_speed = speed;
  return document;
}

// What riders feel in a lap, low-passed at 5 Hz.
sim::Ratings felt(const world::Document& document) {
  const sim::DerivedTrack derived = sim::shapes_of(document);
  sim::RideCache cache;
  const sim::SimulatedRide* const simulated = cache.ride(document, derived, world::first_cart(document));
  EXPECT_TRUE(simulated->lap || !document.track.closed) << "the ride ends early";
  return sim::rate(*simulated, cache.tables(document, derived), 5);
}

// The largest distance of the rows' positions from the document's curve, by brute force.
double largest_distance(const world::Document& document, const std::vector<test::Row>& rows) {
  const sim::DerivedTrack derived = sim::shapes_of(document);
  std::vector<glm::dvec3> places;
  for (double s = 0; s < derived.length; s += 0.02) places.push_back(place_on(derived, s).position);
  places.push_back(place_on(derived, derived.length).position);
  double most = 0;
  std::size_t at = 0;
  for (const test::Row& row : rows) {
    const glm::dvec3 target(row[0], row[1], row[2]);
    double least = 1e9;
    const std::size_t from = at > 30 ? at - 30 : 0, to = std::min(places.size() - 1, at + 150);
    for (std::size_t k = from; k < to; ++k) {
      const glm::dvec3 chord = places[k + 1] - places[k];
      const double t = std::clamp(glm::dot(target - places[k], chord) / glm::dot(chord, chord), 0.0, 1.0);
      if (const double off = glm::distance(places[k] + t * chord, target); off < least) least = off, at = k;
    }
    if (document.track.closed) least = std::min(least, glm::distance(places[0], target));
    most = std::max(most, least);
  }
  return most;
}

struct Sample {
  const char* name;
  double speed;
  std::vector<Rounding> roundings;
};

TEST(nl2_csv_rounded, riders_feel_about_the_same_and_rows_are_within_one_and_a_half_steps) {
  const Sample samples[] = {{"kingfisher", 21, {{3, 6, 1}, {2, 6, 20}, {2, 2, 20}, {1, 1, 40}, {2, 2, 4, 0, false, 2}}},
                            {"old_timber", 28.5, {{3, 3, 10}, {2, 3, 10, 0, true}, {1, 1, 10}, {6, 2, 20}}},
                            {"loop", 6, {{2, 2, 1}, {4, 4, 10}, {3, 6, 10, 50000}, {6, 1, 10}}},
                            {"helix", 6, {{3, 6, 1}, {1, 1, 10}, {2, 2, 20}, {6, 2, 20}}}};
  int number = 0;
  for (const Sample& sample : samples) {
    const world::Document original = sample_track(sample.name, sample.speed);
    const std::string text = print_nl2_csv(original, kNl2Spacing);
    // Six decimals are no worse than the fit itself: its joints are sharper or softer than those of the original.
    world::Document exact = parse_nl2_csv(test::rounded(text, {6, 6, 10}), "t.csv")->document;
    exact.start_speed = original.start_speed;
    const sim::Ratings right = felt(original);
    const double jolt = std::max(right.jolt_most.value, felt(exact).jolt_most.value);
    for (const Rounding& as : sample.roundings) {
      if (!test::tried(number++)) continue;
      SCOPED_TRACE(fmt::format("{}: {} and {} decimals, every {} rows, {} m away, 1 of {} parts", sample.name,
                               as.positions, as.directions, as.every, as.away, as.part));
      const std::string rows = test::rounded(text, as);
      const auto loaded = parse_nl2_csv(rows, "t.csv");
      ASSERT_TRUE(loaded.ok()) << loaded.status().message;
      world::Document document = loaded->document;
      EXPECT_EQ(document.track.closed, as.part == 1);
      document.start_speed = original.start_speed;
      const sim::Ratings got = felt(document);
      EXPECT_LT(got.jolt_most.value, std::max(1.5 * jolt, jolt + 0.3));
      const double most = as.directions <= 2 ? 0.35 : 0.12;  // g
      if (as.part == 1) {
        EXPECT_NEAR(got.side_most.value, right.side_most.value, most);
        EXPECT_NEAR(got.up_most.value, right.up_most.value, most);
        EXPECT_NEAR(got.up_least.value, right.up_least.value, most);
      }
      const double step = as.away > 0 ? 0.00390625 : as.positions < 6 ? std::pow(0.1, as.positions) : 0.01 / 1.5;
      EXPECT_LE(largest_distance(document, test::rows_of(rows)), 1.5 * step);
      EXPECT_LE(loaded->import->max_error, 1.5 * step);
      ASSERT_GE(loaded->warnings.size(), 1u);
      EXPECT_NE(loaded->warnings[0].find("export with six decimals"), std::string::npos) << loaded->warnings[0];
    }
  }
}

TEST(nl2_csv_rounded, warnings_name_the_steps_of_positions_and_directions) {
  const std::string text = print_nl2_csv(sample_track("loop", 6), kNl2Spacing);
  const auto told = [&](const Rounding& as) { return parse_nl2_csv(test::rounded(text, as), "t.csv")->warnings[0]; };
  EXPECT_TRUE(told({3, 6, 20}).starts_with("t.csv:2: warning: positions are rounded to steps of 0.001 m: "));
  EXPECT_TRUE(told({6, 3, 20}).starts_with("t.csv:2: warning: directions are rounded to steps of 0.001: "));
  EXPECT_TRUE(told({2, 3, 20})
                  .starts_with("t.csv:2: warning: positions are rounded to steps of 0.01 m, directions are rounded to "
                               "steps of 0.001: "));
  EXPECT_EQ(told({2, 3, 20, 0, true}), told({2, 3, 20}));
  EXPECT_TRUE(told({6, 6, 20, 50000}).starts_with("t.csv:2: warning: positions are rounded to steps of 0.00391 m: "));
  EXPECT_TRUE(told({3, 6, 20, 50000}).starts_with("t.csv:2: warning: positions are rounded to steps of 0.00391 m: "));
  EXPECT_TRUE(parse_nl2_csv(test::rounded(text, {6, 6, 20}), "t.csv")->warnings.empty());
  EXPECT_TRUE(parse_nl2_csv(test::rounded(text, {5, 5, 20}), "t.csv")->warnings.empty());
}

// Straights whose numbers are multiples of a step because they are exact.
TEST(nl2_csv_rounded, rows_that_only_look_rounded_stay_as_they_are) {
  std::string exact(test::kNl2Header), shifted(exact);
  for (int i = 0; i < 60; ++i) {
    const char* const frame = "\t1\t0\t0\t0\t0\t-1\t0\t1\t0\n";
    exact += fmt::format("{}\t{}\t4.5\t-3.5{}", i + 1, 0.5 * i, frame);
    shifted += fmt::format("{}\t{:.6f}\t4.500001\t-3.500000{}", i + 1, 0.5 * i, frame);
  }
  const auto loaded = parse_nl2_csv(exact, "t.csv");
  EXPECT_TRUE(loaded->warnings.empty());
  EXPECT_EQ(loaded->import->knots, parse_nl2_csv(shifted, "t.csv")->import->knots);
  EXPECT_LT(loaded->import->max_error, 1e-9);
}

// A frame that leans by 30 degrees at once, in rows of a level ring with three decimals.
TEST(nl2_csv_rounded, jumps_of_the_frame_stay_and_are_told) {
  std::string text(test::kNl2Header);
  for (int i = 0; i < 400; ++i) {
    const double a = 0.005 * i, c = std::cos(a), s = std::sin(a), lean = i < 200 ? 0 : 0.5,
                 w = std::sqrt(1 - lean * lean);
    text += fmt::format("{}\t{:.3f}\t4\t{:.3f}\t{:.3f}\t0\t{:.3f}\t{:.3f}\t{:.3f}\t{:.3f}\t{:.3f}\t{:.3f}\t{:.3f}\n",
                        i + 1, 10 * s, -10 * c, c, s, w * s, lean, -w * c, -lean * s, w, lean * c);
  }
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  ASSERT_EQ(loaded->warnings.size(), 2u);
  EXPECT_TRUE(loaded->warnings[1].starts_with("t.csv:202: warning: the frame jumps by 30.")) << loaded->warnings[1];
  EXPECT_LE(loaded->import->frame_error, 0.5);
}

TEST(nl2_csv_rounded, reversed_rows_with_few_decimals_are_refused_as_others) {
  std::string text(test::kNl2Header);
  for (int i = 0; i < 20; ++i)
    text += fmt::format("{}\t{:.2f}\t{:.2f}\t0\t-0.96\t-0.29\t0\t0\t0\t1\t-0.29\t0.96\t0\n", i + 1, 0.48 * i, 0.14 * i);
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_FALSE(loaded.ok());
  EXPECT_NE(loaded.status().message.find("rows in the direction of Front"), std::string::npos)
      << loaded.status().message;
}

TEST(nl2_csv_rounded, smoothing_reports_and_can_be_cancelled) {
  static base::JobProgress progress;
  static int told = 0;
  static double last = 0;
  const std::string text = test::rounded(print_nl2_csv(sample_track("loop", 6), kNl2Spacing), {2, 2, 20});
  progress.told = [](double done) { EXPECT_GE(done, last), last = done, ++told; };
  const auto watched = test::as_job(progress, [&] { return parse_nl2_csv(text, "t.csv"); });
  EXPECT_TRUE(watched->document == parse_nl2_csv(text, "t.csv")->document);
  EXPECT_EQ(progress.done, 1.0);
  // Cancelled while it smooths, it says nothing more.
  progress.done = last = told = 0;
  progress.told = [](double) { progress.cancelled = ++told == 5; };
  const auto cancelled = test::as_job(progress, [&] { return parse_nl2_csv(text, "t.csv"); });
  EXPECT_EQ(cancelled.status().message, "t.csv: the import was cancelled");
  EXPECT_EQ(told, 5);
  EXPECT_LT(progress.done, 0.1);
}

}  // namespace nl2_csv_rounded_test
}  // namespace coaster::exchange
