#include "sim/ground/brush.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace coaster::sim {
namespace brush_test {

constexpr double kStep = world::kHeightStep, kCell = world::kGroundCell;

class BrushTest : public testing::TestWithParam<world::Land> {
 protected:
  BrushTest() : park(world::usual_park(GetParam(), 11)) {}
  Land land() const { return Land(park); }
  // Calls visit(vertex, distance from `at`, height before, height after) around a brush, well beyond its rim.
  void compare(const world::GroundTiles& after, Brush brush, auto visit) const {
    world::Park changed = park;
    changed.tiles = after;
    const Land before = land(), now(changed);
    const int reach = static_cast<int>(brush.radius / kCell) + 40;
    const int column = static_cast<int>(brush.at.x / kCell), row = static_cast<int>(brush.at.y / kCell);
    for (int z = row - reach; z <= row + reach; ++z)
      for (int x = column - reach; x <= column + reach; ++x) {
        const double out = glm::length(kCell * glm::dvec2(x, z) - brush.at);
        visit(GroundVertex{x, z}, out, before.vertex({x, z}), now.vertex({x, z}));
      }
  }
  world::Park park;
};

TEST_P(BrushTest, a_stroke_touches_only_vertices_within_its_radius_and_rounds_heights) {
  const Brush brush{{-71.3, 44.9}, 23.7};
  for (const world::GroundTiles& tiles :
       {raised(land(), brush, 5), raised(land(), brush, -3.3), smoothed(land(), brush), flattened(land(), brush, 8)}) {
    int moved = 0;
    compare(tiles, brush, [&](GroundVertex, double out, double before, double after) {
      if (out >= brush.radius) EXPECT_EQ(after, before);
      if (after == before) return;
      ++moved;
      EXPECT_EQ(after / kStep, std::floor(after / kStep));
    });
    EXPECT_GT(moved, 5);
  }
}

TEST_P(BrushTest, raising_lifts_the_middle_by_all_and_falls_off_without_a_step) {
  const Brush brush{{60, 80}, 40};
  compare(raised(land(), brush, 6), brush, [&](GroundVertex, double out, double before, double after) {
    if (out < 0.3 * brush.radius) EXPECT_NEAR(after - before, 6, kStep);
    EXPECT_GE(after - before, -kStep / 2);
    EXPECT_LE(after - before, 6 + kStep);
    if (out > 0.95 * brush.radius) EXPECT_LT(after - before, 0.15);
  });
  compare(raised(land(), brush, -6), brush, [&](GroundVertex, double out, double before, double after) {
    if (out < 0.3 * brush.radius) EXPECT_NEAR(after - before, -6, kStep);
  });
}

TEST_P(BrushTest, heights_stay_within_the_limits) {
  park.tiles = raised(land(), {{0, 0}, 10}, 900);
  park.tiles = raised(land(), {{0, 0}, 10}, 900);
  EXPECT_EQ(land().vertex({0, 0}), world::kHighestGround);
  for (int i = 0; i < 3; ++i) park.tiles = raised(land(), {{0, 0}, 10}, -1e300);
  EXPECT_EQ(land().vertex({0, 0}), -world::kHighestGround);
}

TEST_P(BrushTest, flattening_makes_the_middle_level_and_doing_it_again_changes_nothing) {
  const Brush brush{{-90, -20}, 30};
  park.tiles = flattened(land(), brush, 7.25);
  for (int i = -4; i <= 4; ++i) EXPECT_EQ(land().vertex({-45 + i, -10}), 7.25);
  world::Park again = park;
  for (int i = 0; i < 500; ++i) again.tiles = flattened(Land(again), brush, 7.25);
  const world::GroundTiles settled = flattened(Land(again), brush, 7.25);
  EXPECT_TRUE(settled == again.tiles);
}

TEST_P(BrushTest, smoothing_takes_bumps_away_and_keeps_a_plane) {
  const auto roughness = [&] {
    double sum = 0;
    for (int z = -8; z <= 8; ++z)
      for (int x = -8; x <= 8; ++x) {
        const double middle = land().vertex({x, z});
        sum += std::fabs(land().vertex({x - 1, z}) + land().vertex({x + 1, z}) - 2 * middle);
      }
    return sum;
  };
  std::mt19937 bits(4);
  for (int i = 0; i < 40; ++i)
    park.tiles = raised(land(), {{bits() % 40 - 20.0, bits() % 40 - 20.0}, 4}, bits() % 2 == 0 ? 2 : -2);
  const double before = roughness();
  for (int i = 0; i < 4; ++i) park.tiles = smoothed(land(), {{0, 0}, 60});
  EXPECT_LT(roughness(), 0.4 * before);
  for (int i = 0; i < 4; ++i) park.tiles = flattened(land(), {{0, 0}, 120}, 4);
  const world::GroundTiles level = park.tiles;
  park.tiles = smoothed(land(), {{0, 0}, 30});
  EXPECT_TRUE(park.tiles == level);
}

TEST_P(BrushTest, a_slope_is_straight_between_the_heights_of_its_ends) {
  const glm::dvec2 from(-100, -40), to(60, 80);
  park.tiles = flattened(land(), {from, 20}, 2);
  park.tiles = flattened(land(), {to, 20}, 18);
  park.tiles = sloped(land(), from, to, 12);
  for (double way = 0; way <= 1; way += 0.1) {
    const glm::dvec2 at = from + way * (to - from);
    EXPECT_NEAR(land().height(at.x, at.y), 2 + 16 * way, 0.2) << way;
  }
  const world::GroundTiles point = sloped(land(), from, from, 12);
  park.tiles = point;
  EXPECT_NEAR(land().height(from.x, from.y), 2, 0.1) << "both ends in one place";
}

TEST_P(BrushTest, woods_are_painted_by_cells_and_can_be_given_back) {
  const Brush brush{{10, -30}, 25};
  park.tiles = wooded(land(), brush, 1.0);
  int dense = 0;
  for (const auto& [place, tile] : park.tiles.map())
    for (int z = 0; z < 16; ++z)
      for (int x = 0; x < 16; ++x) {
        const std::uint8_t woods = tile->woods[static_cast<std::size_t>(16 * z + x)];
        const glm::dvec2 middle = 64.0 * glm::dvec2(place.x, place.z) + glm::dvec2(4 * x + 2, 4 * z + 2);
        const double out = glm::length(middle - brush.at);
        EXPECT_TRUE(woods == 0 || woods == 255);
        if (out >= brush.radius) EXPECT_EQ(woods, 0);
        if (out < 0.7 * brush.radius) EXPECT_EQ(woods, 255);
        dense += woods == 255;
      }
  EXPECT_GT(dense, 90);
  EXPECT_EQ(land().vertex({5, -15}), Land(world::usual_park(GetParam(), 11)).vertex({5, -15}));
  park.tiles = wooded(land(), brush, 0.0);
  EXPECT_EQ(park.tiles.find({0, -1})->woods[static_cast<std::size_t>(8 * 16 + 2)], 1);
  park.tiles = wooded(land(), {brush.at, 40}, std::nullopt);
  EXPECT_TRUE(park.tiles.empty()) << "nothing is left of it";
}

TEST_P(BrushTest, tiles_that_a_stroke_does_not_touch_are_shared) {
  park.tiles = raised(land(), {{-200, -200}, 20}, 3);
  const world::GroundTiles after = raised(land(), {{200, 200}, 20}, 3);
  for (const auto& [place, tile] : park.tiles.map()) EXPECT_EQ(after.find(place), tile.get());
  EXPECT_GT(after.map().size(), park.tiles.map().size());
}

TEST_P(BrushTest, a_stroke_over_the_rim_of_the_square_ends_there) {
  constexpr double kRim = world::kGroundSquare / 2;
  for (const glm::dvec2 at : {glm::dvec2(kRim, kRim), glm::dvec2(-kRim, kRim), glm::dvec2(-kRim, -kRim)}) {
    const world::GroundTiles tiles = raised(land(), {at, 50}, 9);
    EXPECT_FALSE(tiles.empty());
    for (const auto& [place, tile] : tiles.map()) EXPECT_TRUE(world::in_square(place));
  }
  EXPECT_TRUE(raised(land(), {{5000, 0}, 50}, 9).empty());
}

INSTANTIATE_TEST_SUITE_P(some, BrushTest,
                         testing::Values(world::Land::meadow, world::Land::cliffs, world::Land::island),
                         [](const auto& info) { return std::string(base::name_of(info.param)); });

}  // namespace brush_test
}  // namespace coaster::sim
