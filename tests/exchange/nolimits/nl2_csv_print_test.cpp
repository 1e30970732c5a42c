// Printed rows of NoLimits 2.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "base/tries.h"
#include "exchange/nolimits/nl2_csv.h"
#include "exchange/nolimits/nl2_header.h"
#include "sim/bends_of.h"
#include "sim/rows_along.h"
#include "sim/tracks.h"

namespace coaster::exchange {
namespace nl2_csv_print_test {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}
// The rows of a text, read by the standard library.
std::vector<sim::FitRow> rows_of(const std::string& text) {
  std::istringstream in(text.substr(text.find('\n') + 1));
  std::vector<sim::FitRow> found;
  glm::dvec3 left;
  for (sim::FitRow r;
       in.ignore(20, '\t') && in >> r.position.x >> r.position.y >> r.position.z >> r.forward.x >> r.forward.y >>
                                  r.forward.z >> left.x >> left.y >> left.z >> r.up.x >> r.up.y >> r.up.z;
       found.push_back(r)) {
    EXPECT_NEAR(glm::distance(glm::cross(r.forward, left), r.up), 0, 3e-6);
    r.forward = glm::normalize(r.forward);
    r.up = glm::normalize(r.up - glm::dot(r.up, r.forward) * r.forward);
  }
  return found;
}
world::Document sample(const std::string& name) {
  std::ifstream in(std::string(COASTER_SOURCE_DIR) + "/tracks/" + name);
  std::ostringstream text;
  text << in.rdbuf();
  auto loaded = parse_track(text.str(), name);
  EXPECT_TRUE(loaded.ok());
  return loaded->document;
}

TEST(nl2_csv_print, rows_are_printed_in_the_columns_and_digits_of_the_format) {
  const world::Document d = test::straight_document({1, 2, 3}, {2.5f, 2, 3});
  const std::vector<std::string> lines = lines_of(print_nl2_csv(d, 0.4));
  ASSERT_EQ(lines.size(), 6u);  // 0, 0.4, 0.8, 1.2 and the end
  EXPECT_EQ(lines[0] + "\n", test::kNl2Header);
  EXPECT_EQ(lines[1],
            "1\t1.000000\t2.000000\t3.000000\t1.000000\t0.000000\t0.000000\t0.000000\t0.000000\t-1.000000\t0.000000\t1."
            "000000\t0.000000");
  EXPECT_TRUE(lines[5].starts_with("5\t2.500000\t2.000000\t3.000000\t")) << lines[5];
  EXPECT_EQ(lines_of(print_nl2_csv(d, 0.5)).size(), 5u);  // the end is a row already
  EXPECT_EQ(lines_of(print_nl2_csv(d, 7.0)).size(), 3u);
}

TEST(nl2_csv_print, a_closed_track_ends_a_remainder_before_its_first_row) {
  const world::Document d = test::ring_document(12, 17.3);
  const std::vector<sim::FitRow> found = rows_of(print_nl2_csv(d, 0.05));
  const double length = world::exact_length(d), remainder = length - 0.05 * static_cast<double>(found.size() - 1);
  EXPECT_GT(remainder, 0);
  EXPECT_LE(remainder, 0.05 + 1e-9);
  EXPECT_NEAR(glm::distance(found.front().position, found.back().position), remainder, 2e-5);
}

TEST(nl2_csv_print, what_has_no_segment_or_too_many_rows_is_not_written) {
  EXPECT_EQ(check_nl2_csv({}, 0.05).code, base::Code::refused);
  const world::Document longest = test::straight_document({-90'000, 0, 0}, {90'000, 0, 0}, 40);
  EXPECT_EQ(check_nl2_csv(longest, 0.05).code, base::Code::refused);
  EXPECT_TRUE(check_nl2_csv(longest, 5).ok());
}

// Exported and imported: every row by the test's own measure.
void expect_round_trip(const world::Document& document, double spacing, double most_knots_per_m) {
  const std::string text = print_nl2_csv(document, spacing);
  EXPECT_EQ(text, print_nl2_csv(document, spacing));
  const auto loaded = parse_nl2_csv(text, "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_EQ(world::broken_invariant(loaded->document), std::nullopt);
  EXPECT_EQ(loaded->document.track.closed, document.track.closed);
  const test::Misses misses = test::misses_of(loaded->document, rows_of(text));
  EXPECT_LE(misses.distance, 0.01);
  EXPECT_LE(misses.angle_deg, 0.5);
  EXPECT_LE(loaded->import->max_error, 0.01);
  EXPECT_LE(loaded->import->frame_error, 0.5);
  const test::Bends bends = test::bends_of(loaded->document, rows_of(text));
  EXPECT_EQ(bends.folds, 0);
  if (spacing < 3) {  // further apart, curvature changes within a step
    EXPECT_LE(bends.excess, 1) << bends.at;
  }
  EXPECT_LE(bends.handle, 0.5);
  const double length = world::exact_length(document);
  EXPECT_NEAR(world::exact_length(loaded->document), length, 0.001 * length);
  EXPECT_LE(loaded->import->knots, 2 + most_knots_per_m * length);
}

TEST(nl2_csv_print, the_sample_tracks_come_back_with_a_knot_every_ten_metres_or_less_often) {
  for (const char* name : {"gentle.json", "helix.json", "loop.json"}) {
    SCOPED_TRACE(name);
    expect_round_trip(sample(name), 0.25, 0.1);
  }
  expect_round_trip(sample("loop.json"), 3.3, 0.4);  // rows further apart
}

// A first fit may use the bounds of 1 cm and 0.5 degrees up to the last. Later ones need not: their rows lie on spans.
TEST(nl2_csv_print, copies_of_copies_stay_near_the_first_and_have_about_as_many_knots) {
  int number = 1;  // so the sanitizers try the fourth alone
  for (const char* name : {"gentle.json", "helix.json", "kingfisher.json", "loop.json", "old_timber.json"}) {
    if (!test::tried(number++)) continue;
    SCOPED_TRACE(name);
    auto last = parse_nl2_csv(print_nl2_csv(sample(name), 0.05), "t.csv");
    ASSERT_TRUE(last.ok());
    const std::string first = print_nl2_csv(last->document, 0.05);
    const int knots = last->import->knots;
    for (int copy = 2; copy < 2 + test::tries(4); ++copy) {
      SCOPED_TRACE(copy);
      const std::string text = print_nl2_csv(last->document, 0.05);
      last = parse_nl2_csv(text, "t.csv");
      ASSERT_TRUE(last.ok());
      EXPECT_LE(last->import->knots, knots + knots / 8 + 1);
      const test::Misses step = test::misses_of(last->document, rows_of(text));
      EXPECT_LE(step.distance, 0.002);
      EXPECT_LE(step.angle_deg, 0.11);
      EXPECT_LE(test::misses_of(last->document, rows_of(first)).distance, 0.01);
    }
  }
}

// The rows with each of their vectors (x, y, z) turned.
template <class Turn>
std::string turned(const std::vector<sim::FitRow>& rows, const Turn& turn) {
  std::string text(test::kNl2Header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const sim::FitRow& r = rows[i];
    text += std::to_string(i + 1);
    for (const glm::dvec3& v : {turn(r.position), turn(r.forward), glm::cross(turn(r.up), turn(r.forward)), turn(r.up)})
      text += fmt::format("\t{:.6f}\t{:.6f}\t{:.6f}", v.x, v.y, v.z);
    text += '\n';
  }
  return text;
}

TEST(nl2_csv_print, rows_with_z_up_are_warned_of_and_turned_or_mirrored_rows_are_not) {
  const auto warned = [](const std::string& text) {
    const auto loaded = parse_nl2_csv(text, "t.csv");
    EXPECT_TRUE(loaded.ok()) << loaded.status().message;
    return loaded && std::any_of(loaded->warnings.begin(), loaded->warnings.end(), [](const std::string& w) {
             return w.find("Up is mostly along Z") != std::string::npos;
           });
  };
  for (const char* name : {"gentle.json", "helix.json", "kingfisher.json", "loop.json", "old_timber.json"}) {
    SCOPED_TRACE(name);
    const std::vector<sim::FitRow> rows = rows_of(print_nl2_csv(sample(name), 1));
    EXPECT_TRUE(warned(turned(rows, [](glm::dvec3 v) { return glm::dvec3(v.x, -v.z, v.y); })));
    EXPECT_FALSE(warned(turned(rows, [](glm::dvec3 v) { return glm::dvec3(v.x, v.y, -v.z); })));
    for (const double angle : {0.0, 0.7, 1.6, 4.0})
      EXPECT_FALSE(warned(turned(rows, [&](glm::dvec3 v) {
        const double c = std::cos(angle), s = std::sin(angle);
        return glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
      })));
  }
}

RC_GTEST_PROP(nl2_csv_print, random_tracks_come_back_within_the_bounds, ()) {
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1'000'000);
  std::mt19937 bits(seed);
  SCOPED_TRACE(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  world::Document d = test::ring_document(5 + static_cast<int>(bits() % 6), uniform(12, 30), uniform(0, 7));
  for (const world::Entity e : d.track.knots) {
    world::Knot& k = d.entities.get<world::Knot>(e);
    world::set_roll(k, uniform(-180, 180));
    k.joint = world::JointKind::aligned;
    k.in_length *= static_cast<float>(uniform(0.7, 1.4)), k.out_length *= static_cast<float>(uniform(0.7, 1.4));
  }
  d.entities.get<world::Segment>(d.track.segments[1]).turns = static_cast<int>(bits() % 3) - 1;
  if (bits() % 2) world::set_closed(d, false);
  expect_round_trip(d, 0.25, 0.4);
  RC_ASSERT(!testing::Test::HasFailure());
}

}  // namespace nl2_csv_print_test
}  // namespace coaster::exchange
