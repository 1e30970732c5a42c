#include "exchange/points/points.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "curve/tight_places.h"
#include "world/document.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace points_test {

base::Result<LoadedTrack> parse(std::string_view text,
                                const ImportOptions& import = {.up = world::Axis::y, .scale = 1}) {
  return parse_points(text, "a.xyz", import);
}

TEST(points, handles_are_those_of_the_catmull_rom_spline) {
  const auto loaded = parse("# a bend\nx,y,z\n0,5,0\n30 5 0\n60\t8\t12\n90;8;12\n");
  ASSERT_TRUE(loaded) << loaded.status().message;
  const world::Document& d = loaded->document;
  const glm::dvec3 p[]{{-30, 5, 0}, {0, 5, 0}, {30, 5, 0}, {60, 8, 12}, {90, 8, 12}, {120, 8, 12}};
  ASSERT_EQ(d.track.knots.size(), 4u);
  EXPECT_FALSE(d.track.closed);
  for (std::size_t i = 0; i < 4; ++i) {
    const world::Knot& k = world::knot(d, d.track.knots[i]);
    EXPECT_EQ(glm::dvec3(k.position), p[i + 1]);
    const glm::dvec3 handle = (p[i + 2] - p[i]) / 6.0;
    EXPECT_LT(glm::distance(glm::dvec3(world::out_handle(k)), p[i + 1] + handle), 1e-5) << i;
    EXPECT_LT(glm::distance(glm::dvec3(world::in_handle(k)), p[i + 1] - handle), 1e-5) << i;
  }
}

TEST(points, ends_that_meet_close_the_track_and_repeated_points_are_counted) {
  const auto ring = parse("0 0 0\n50 0 0\n50 0 0\n50 0 50\n0 0 50\n0 0 0\n");
  ASSERT_TRUE(ring) << ring.status().message;
  EXPECT_TRUE(ring->document.track.closed);
  EXPECT_EQ(ring->document.track.knots.size(), 4u);
  EXPECT_NE(ring->note.find("4 points, closed"), std::string::npos) << ring->note;
  EXPECT_NE(ring->note.find("Left out 1 repeated point."), std::string::npos) << ring->note;
  EXPECT_TRUE(parse("0 0 0\n50 0 0\n50 0 50\n0 0 50\n")->document.track.closed) << "one usual step apart";
  EXPECT_FALSE(parse("0 0 0\n50 0 0\n100 0 50\n150 0 50\n")->document.track.closed);
}

TEST(points, a_wrong_row_or_count_is_refused_with_its_line) {
  const auto error = [](std::string_view text) { return parse(text).status().message; };
  EXPECT_EQ(error("3\n0 0 0\n9 0 0\n"), "a.xyz:3: error: expected 3 points, the number in the first row, found 2");
  EXPECT_EQ(error("0 0 0\n1 nan 0\n"), "a.xyz:2: error: expected three finite numbers, found \"nan\"");
  EXPECT_EQ(error("0 0 0\n1 0 0 0\n"), "a.xyz:2: error: expected a row of three numbers: x, y and z, found one of 4");
  EXPECT_EQ(error("0 0 0\n0 0 0\n"), "a.xyz:2: error: expected at least 2 points at different places, found 1");
  EXPECT_NE(error("0 0 0\n1e6 0 0\n").find("load it with the word origin"), std::string::npos);
}

TEST(points, axis_and_unit_are_proposed_and_z_up_is_a_rotation) {
  const auto plan = read_points("0 0 0\n400 0 5\n400 300 9\n0 300 5\n0 0 0", "plan");
  ASSERT_TRUE(plan);
  EXPECT_EQ(proposed(*plan, {}), (ImportOptions{.up = world::Axis::z, .scale = 1}));
  const auto small = read_points("0 0 0\n4 1 0\n8 0 0", "profile");
  ASSERT_TRUE(small);
  EXPECT_EQ(proposed(*small, {}), (ImportOptions{.up = world::Axis::y, .scale = 100}));
  EXPECT_EQ(with_y_up({1, 2, 3}, world::Axis::z), glm::dvec3(1, 3, -2));
}

TEST(points, the_origin_is_below_the_middle_of_a_far_list) {
  const auto far = parse("500000 300 4000000\n500100 340 4000000\n500200 300 4000050\n",
                         {.up = world::Axis::y, .scale = 1, .origin = true});
  ASSERT_TRUE(far) << far.status().message;
  const world::Document& d = far->document;
  EXPECT_EQ(world::knot(d, d.track.knots[0]).position, glm::vec3(-100, 2, -25));
  EXPECT_EQ(world::knot(d, d.track.knots[1]).position, glm::vec3(0, 42, -25));
}

TEST(points, smoothing_stays_within_its_distance_and_takes_fewer_knots) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += std::to_string(2 * i) + (i % 2 == 0 ? " 5.02 0\n" : " 4.98 0\n");
  const auto loaded = parse(text, {.up = world::Axis::y, .scale = 1, .smooth = 0.05});
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_LT(loaded->document.track.knots.size(), 50u);
  EXPECT_LE(loaded->import->max_error, 0.05);
  EXPECT_GT(loaded->import->max_error, 0.015) << "the noise is 0.02 m";
}

TEST(points, points_nearer_than_two_handles_are_left_out_and_counted) {
  std::string ring, line;
  for (int i = 0; i < 3000; ++i) {
    const double a = 2 * base::kPi * i / 3000;
    ring += fmt::format("{:.6f} 5 {:.6f}\n", 6.2 * std::cos(a), 6.2 * std::sin(a));  // 13 mm apart
  }
  const auto loaded = parse(ring);
  ASSERT_TRUE(loaded) << loaded.status().message;
  const world::Document& d = loaded->document;
  EXPECT_TRUE(d.track.closed);
  EXPECT_EQ(d.track.knots.size(), 1000u);
  EXPECT_NE(loaded->note.find("Left out 2000 points nearer than 0.029 m to the one before."), std::string::npos)
      << loaded->note;
  for (const world::Entity s : d.track.segments)
    EXPECT_TRUE(curve::tight_places(world::cubic_of(d, s), 3).empty()) << "handles overlap";
  for (int i = 0; i <= 100; ++i) line += fmt::format("{:.3f} 5 0\n", 0.013 * i);
  const auto open = parse(line);
  ASSERT_TRUE(open);
  EXPECT_EQ(world::knot(open->document, open->document.track.knots.back()).position, glm::vec3(1.3f, 5, 0));
  EXPECT_NE(parse("0 0 0\n0.02 0 0\n").status().message.find("all points are within 0.029 m"), std::string::npos);
}

// The rows of a straight, `turn` degrees of a vertical circle that shifts aside, and a straight on from there.
std::string looping(double turn) {
  constexpr double kRadius = 10;
  std::string text;
  for (int i = 0; i < 10; ++i) text += fmt::format("{} 5 0\n", 4 * i - 40);
  const int steps = static_cast<int>(turn / 10);
  double x = 0, y = 0, z = 0;
  for (int i = 0; i <= steps; ++i) {
    const double a = base::kPi * i / 18;
    x = kRadius * std::sin(a), y = 5 + kRadius * (1 - std::cos(a)), z = 0.1 * i;
    text += fmt::format("{:.6f} {:.6f} {:.6f}\n", x, y, z);
  }
  const double ahead = turn < 200 ? -4 : 4;
  for (int i = 1; i < 25; ++i) text += fmt::format("{:.6f} {:.6f} {:.6f}\n", x + ahead * i, y, z);
  return text;
}

TEST(points, level_rolls_are_upside_down_only_on_top_of_a_loop) {
  const auto up = [](const LoadedTrack& track, std::size_t i) {
    return world::knot(track.document, track.document.track.knots.at(i)).up.y;
  };
  const auto loop = parse(looping(360)), half = parse(looping(180));
  ASSERT_TRUE(loop && half);
  EXPECT_GT(up(*loop, 5), 0.99);
  EXPECT_LT(up(*loop, 10 + 18), -0.99) << "the top";
  EXPECT_GT(up(*loop, 10 + 36 + 5), 0.99);
  EXPECT_GT(up(*half, 10 + 18 + 5), 0.99) << "half a loop is not the top of one: the track levels out";
  const auto smooth = parse(looping(360), {.up = world::Axis::y, .scale = 1, .smooth = 0.05});
  ASSERT_TRUE(smooth);
  float least = 1;
  for (const world::Entity e : smooth->document.track.knots)
    least = std::min(least, world::knot(smooth->document, e).up.y);
  EXPECT_LT(least, -0.8);
  EXPECT_GT(up(*smooth, smooth->document.track.knots.size() - 1), 0.99);
}

}  // namespace points_test
}  // namespace coaster::exchange
