// Which patches of the land are drawn, and how finely.
#include "gfx/land_cache.h"

#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace coaster::gfx {
namespace visible_patches_test {

constexpr int kSide = sim::LandPatch::kSide, kCells = kSide - 1;

// The vertices along one side of a patch that its triangles use: 0 to 3 for -x, +x, -z, +z.
std::set<int> along(const std::vector<std::uint16_t>& indices, int side) {
  std::set<int> used;
  for (const std::uint16_t index : indices) {
    const int x = index % kSide, z = index / kSide;
    if (side < 2 ? x == (side == 0 ? 0 : kCells) : z == (side == 2 ? 0 : kCells)) used.insert(side < 2 ? z : x);
  }
  return used;
}

TEST(PatchIndices, cover_the_patch_once_and_meet_at_snapped_borders) {
  std::set<int> all, fourth;
  for (int i = 0; i <= kCells; ++i) {
    all.insert(i);
    if (i % 4 == 0) fourth.insert(i);
  }
  for (const int step : {1, 2, 4}) {
    for (int snapped = step == 1 ? 0 : kAllSides; snapped <= kAllSides; ++snapped) {
      const std::vector<std::uint16_t> indices = patch_indices(step, static_cast<std::uint8_t>(snapped));
      double area = 0;
      std::map<std::pair<int, int>, int> edges;
      for (std::size_t i = 0; i < indices.size(); i += 3) {
        const auto at = [&](std::size_t k) {
          return glm::dvec2(indices[i + k] % kSide, static_cast<int>(indices[i + k]) / kSide);
        };
        const glm::dvec2 u = at(1) - at(0), v = at(2) - at(0);
        const double twice = u.y * v.x - u.x * v.y;
        ASSERT_GT(twice, 0) << "from above";
        area += 0.5 * twice;
        for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax<int>(indices[i + k], indices[i + (k + 1) % 3])];
      }
      EXPECT_DOUBLE_EQ(area, kCells * kCells) << step << " " << snapped;
      for (int side = 0; side < 4; ++side)
        EXPECT_EQ(along(indices, side), step == 4 || (snapped >> side & 1) ? fourth : all) << step << " " << snapped;
      for (const auto& [edge, count] : edges) ASSERT_LE(count, 2);
    }
  }
}

TEST(Boxes, may_show_if_any_of_their_points_is_in_the_picture) {
  std::mt19937 bits(5);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(bits() / 4294967296.0);
  };
  int shown = 0, hidden = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 eye(uniform(-50, 50), uniform(1, 30), uniform(-50, 50));
    const glm::mat4 view =
        glm::lookAtRH(eye, eye + glm::vec3(uniform(-1, 1), uniform(-0.5f, 0.5f), uniform(-1, 1)), glm::vec3(0, 1, 0));
    const glm::mat4 clip = glm::perspectiveRH_NO(0.8f, 1.7f, 0.2f, 500.0f) * view;
    Box box;
    box.low = {uniform(-100, 100), uniform(-10, 10), uniform(-100, 100)};
    box.high = box.low + glm::vec3(uniform(1, 30), uniform(1, 10), uniform(1, 30));
    bool seen = false;
    for (int k = 0; k < 60 && !seen; ++k) {
      const glm::vec3 at(uniform(box.low.x, box.high.x), uniform(box.low.y, box.high.y),
                         uniform(box.low.z, box.high.z));
      const glm::vec4 there = clip * glm::vec4(at, 1);
      seen = there.w > 0 && std::abs(there.x) < there.w && std::abs(there.y) < there.w && std::abs(there.z) < there.w;
      EXPECT_GE(glm::distance(at, eye) + 1e-3f, distance_to(box, eye));
    }
    const bool may = may_show(clip, box);
    EXPECT_TRUE(may || !seen);
    shown += seen, hidden += !may;
  }
  EXPECT_GT(shown, 300);
  EXPECT_GT(hidden, 1000);
}

// Two patches share a border: both draw all of its vertices, or both draw every fourth.
TEST(VisiblePatches, meet_their_neighbours_and_come_from_near_to_far) {
  constexpr int kAcross = 8;
  std::vector<sim::LandPatch> patches(kAcross * kAcross);
  for (int i = 0; i < kAcross * kAcross; ++i) {
    patches[static_cast<std::size_t>(i)].corner = {64 * (i % kAcross - 4), 64 * (i / kAcross - 4)};
  }
  patches[3 * kAcross + 6].open = {40};
  const glm::vec3 eye(-150, 5, -100);
  const glm::mat4 clip = glm::orthoRH_NO(-600.0f, 600.0f, -600.0f, 600.0f, -900.0f, 900.0f);
  const std::vector<VisiblePatch> visible = visible_patches(patches, clip, eye, 1);
  ASSERT_EQ(visible.size(), patches.size());
  std::map<std::size_t, VisiblePatch> by_place;
  std::set<int> steps;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    EXPECT_GE(visible[i].metres, visible[i > 0 ? i - 1 : 0].metres);
    by_place[visible[i].index] = visible[i];
    steps.insert(visible[i].step);
  }
  EXPECT_EQ(steps, (std::set<int>{1, 2, 4}));
  EXPECT_EQ(by_place[3 * kAcross + 6].snapped, 0) << "open cells have triangles of their own";
  for (const auto& [index, patch] : by_place) {
    const auto i = static_cast<int>(index);
    if (i % kAcross + 1 < kAcross) {
      EXPECT_EQ(patch.snapped >> 1 & 1, by_place[index + 1].snapped & 1) << index;
    }
    if (i / kAcross + 1 < kAcross) {
      EXPECT_EQ(patch.snapped >> 3 & 1, by_place[index + kAcross].snapped >> 2 & 1) << index;
    }
  }
}

}  // namespace visible_patches_test
}  // namespace coaster::gfx
