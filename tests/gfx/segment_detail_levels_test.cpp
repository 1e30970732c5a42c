// The segments of a very long track that are held in full, and the deviation of the others.
#include "gfx/segment_detail_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace coaster::gfx {
namespace segment_detail_levels_test {

constexpr float kOff = 1e-3f, kReach = 150;

std::vector<curve::Cubic> random_cubics(std::size_t count, float spread) {
  std::mt19937 bits(5);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(bits() / 4294967296.0);
  };
  std::vector<curve::Cubic> all;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 at(uniform(-spread, spread), uniform(0, 40), uniform(-spread, spread));
    const auto near = [&] { return at + glm::vec3(uniform(-8, 8), uniform(-8, 8), uniform(-8, 8)); };
    all.push_back({at, near(), near(), near()});
  }
  return all;
}

std::vector<SegmentSize> sizes_of(const std::vector<curve::Cubic>& cubics) {
  std::vector<SegmentSize> sizes;
  for (const curve::Cubic& cubic : cubics) sizes.push_back(size_of(cubic));
  return sizes;
}

SegmentLevels choose_levels(const std::vector<SegmentSize>& sizes, int steps, const LevelView& sight) {
  LevelChoice choice;
  choice.begin(sizes, steps, sight);
  return choice.levels();
}

std::int64_t vertices(const SegmentLevels& levels, const std::vector<SegmentSize>& sizes) {
  std::int64_t sum = 0;
  for (const SegmentSize& size : sizes) sum += levels.lines_of(size) + 2;
  return sum;
}

// How far `lines` equal chords are from a curve, and the curve from an eye: by many points, without any bound.
struct Off {
  double metres = 0, distance = std::numeric_limits<double>::max();
};
Off off_by(const curve::Cubic& cubic, int lines, glm::vec3 eye) {
  Off off;
  for (int k = 0; k < lines; ++k) {
    const glm::dvec3 from = curve::point(cubic, double(k) / lines), to = curve::point(cubic, (k + 1.0) / lines);
    for (const double u : {0.25, 0.5, 0.75}) {
      const glm::dvec3 at = curve::point(cubic, (k + u) / lines);
      off.metres = std::max(off.metres, glm::distance(at, from + u * (to - from)));
      off.distance = std::min(off.distance, glm::distance(at, glm::dvec3(eye)));
    }
  }
  return off;
}

TEST(segment_levels, a_track_of_usual_size_has_all_steps_wherever_the_eye_is) {
  const auto sizes = sizes_of(random_cubics(5000, 4000));
  for (const glm::vec3 eye : {glm::vec3(0), glm::vec3(1e5f, 9, 0)})
    for (const int steps : {1, 64, 256}) {
      const SegmentLevels levels = choose_levels(sizes, steps, {eye, kOff, 50});
      EXPECT_TRUE(levels.all());
      EXPECT_EQ(vertices(levels, sizes), std::int64_t(5000) * (steps + 2));
    }
}

TEST(segment_levels, the_vertices_of_any_track_stay_within_the_budget) {
  for (const std::size_t count : {std::size_t{30'000}, std::size_t{100'000}})
    for (const float spread : {50.0f, 3000.0f}) {
      const auto sizes = sizes_of(random_cubics(count, spread));
      for (const int steps : {64, 1000})
        for (const float off : {kOff, 1e-9f}) {
          const SegmentLevels levels = choose_levels(sizes, steps, {{10, 5, 0}, off, 50});
          EXPECT_FALSE(levels.all());
          EXPECT_LE(vertices(levels, sizes), kPolylineBudget);
          EXPECT_GE(levels.line_off, off);
        }
    }
}

TEST(segment_levels, far_segments_are_off_by_no_more_than_asked_and_near_ones_have_all_steps) {
  const auto cubics = random_cubics(60'000, 9000);
  const auto sizes = sizes_of(cubics);
  const glm::vec3 eye(900, 30, -400);
  const SegmentLevels levels = choose_levels(sizes, 64, {eye, kOff, kReach});
  ASSERT_EQ(levels.line_off, kOff) << "there is room";
  std::size_t near = 0, far = 0, solid = 0;
  for (std::size_t i = 0; i < cubics.size(); ++i) {
    const int lines = levels.lines_of(sizes[i]);
    const Off polyline = off_by(cubics[i], lines, eye), straight = off_by(cubics[i], 1, eye);
    ++(lines == 64 ? near : far);
    EXPECT_TRUE(lines == 64 || polyline.metres <= double{kOff} * polyline.distance * 1.001) << i;
    if (levels.solid(sizes[i])) {
      ++solid;
    } else {
      EXPECT_LE(straight.metres, double{kOff} * straight.distance * 1.001) << i;
      EXPECT_GT(straight.distance, double{kReach}) << i;
    }
  }
  EXPECT_GT(near, 10u);
  EXPECT_GT(far, 10'000u);
  EXPECT_GT(solid, 10u);
  EXPECT_LT(solid, cubics.size() - 1000);
}

TEST(segment_levels, small_moves_of_the_eye_change_nothing) {
  const auto sizes = sizes_of(random_cubics(40'000, 9000));
  EXPECT_EQ(choose_levels(sizes, 64, {{1, 2, 3}, kOff, 50}), choose_levels(sizes, 64, {{-4, 7, 0}, kOff, 50}));
  EXPECT_NE(choose_levels(sizes, 64, {{1, 2, 3}, kOff, 50}), choose_levels(sizes, 64, {{40, 2, 3}, kOff, 50}));
}

TEST(segment_levels, segments_that_change_are_counted_as_if_all_were) {
  auto sizes = sizes_of(random_cubics(30'000, 300));
  const auto others = sizes_of(random_cubics(30'000, 50));
  const LevelView sight{{10, 5, 0}, 1e-9f, 50};
  LevelChoice choice;
  choice.begin(sizes, 64, sight);
  const SegmentLevels first = choice.levels();
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const SegmentSize before = std::exchange(sizes[i], others[(7 * i) % others.size()]);
    choice.replace(before, sizes[i]);
    if (i % 6000 == 0) {
      EXPECT_EQ(choice.levels(), choose_levels(sizes, 64, sight)) << i;
    }
  }
  EXPECT_EQ(choice.levels(), choose_levels(sizes, 64, sight));
  EXPECT_NE(choice.levels(), first);
}

}  // namespace segment_detail_levels_test
}  // namespace coaster::gfx
