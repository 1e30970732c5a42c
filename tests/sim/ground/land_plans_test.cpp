// Plans on a land: what is refused or warned of on the plane and not there, and rays to the land.
#include <random>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/ground/land.h"
#include "sim/lands.h"
#include "sim/plan/closing_candidates.h"
#include "sim/plan/element_plan.h"
#include "sim/plan/force_plan.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace land_plans_test {

using glm::dvec3;

TEST(LandPlans, the_depth_of_a_place_is_that_below_the_plane_or_under_water) {
  const Land plane;
  for (const double y : {-3.1, 0.0, 7.0}) EXPECT_EQ(plane.depth({5, y, 9}), -y);
  world::Document document;
  test::shape_land(document, [](double x, double) { return x < 0 ? -8.0 : x < 40 ? 1.0 : 20.0; });
  const Land dry(document.park);
  for (const double x : {-20.0, 20.0, 60.0}) EXPECT_LT(dry.depth({x, -5, 0}), -1e9) << "no water";
  document.park.water = -2;
  const Land wet(document.park);
  EXPECT_NEAR(wet.depth({-20, -5, 0}), 3, 1e-12) << "in the lake";
  EXPECT_LT(wet.depth({-20, -1, 0}), 0) << "over it";
  EXPECT_NEAR(wet.depth({20, -3, 0}), 1, 1e-12) << "in an open cut, which is flooded";
  EXPECT_LT(wet.depth({60, -5, 0}), -1e9) << "in a tunnel";
}

// The march against the nearest crossing of a fine walk along the ray.
TEST(LandPlans, rays_meet_the_land_where_a_fine_walk_does) {
  std::mt19937 bits(3);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  world::Document document;
  test::shape_land(document, [](double x, double z) { return 11 * std::sin(x / 23) * std::sin(z / 31); });
  document.park.water = -4;
  const Land land(document.park);
  int met = 0;
  for (int i = 0; i < test::tries(60); ++i) {
    const dvec3 from(uniform(-90, 90), uniform(13, 60), uniform(-90, 90)),
        way = glm::normalize(dvec3(uniform(-1, 1), uniform(-1, -0.1), uniform(-1, 1)));
    double walked = -1;
    for (double t = 0; t < 400 && walked < 0; t += 0.01) {
      const dvec3 p = from + t * way;
      if (p.y < std::max(land.height(p.x, p.z), -4.0)) walked = t;
    }
    const auto found = land.meet(from, way);
    ASSERT_EQ(found.has_value(), walked >= 0);
    if (!found) continue;
    ++met;
    const dvec3 p = from + *found * way;
    EXPECT_NEAR(p.y, land.surface(p.x, p.z), 1e-3);
    // A step of a metre may pass over the tip of a hill.
    EXPECT_NEAR(*found, walked, *found > walked + 0.02 ? 40 : 0.02);
  }
  EXPECT_GT(met, test::tries(40));
}

TEST(LandPlans, the_first_element_stands_on_the_land_and_planning_twice_gives_the_same_bits) {
  world::Document document;
  EXPECT_EQ(open_end(document)->position, dvec3(0, 2, 0));
  test::shape_land(document, [](double x, double z) { return 7.3 + 0.11 * x - 0.07 * z; });
  const TrackEnd end = *open_end(document);
  EXPECT_NEAR(end.position.y, 9.3, 1.0 / 64 + 1.0 / 32);
  EXPECT_EQ(end.position, dvec3(glm::vec3(end.position))) << "a knot keeps it exactly";
  const world::Element loop = world::usual_element(world::ElementKind::loop);
  const ElementPlan first = plan_element(loop, document), again = plan_element(loop, document);
  EXPECT_EQ(first.fit.knots, again.fit.knots);
  // Placed, and planned again from where its first knot is.
  world::Document placed = document;
  for (const world::Knot& knot : first.fit.knots) world::append_knot(placed, knot);
  EXPECT_EQ(plan_element(loop, end_at(placed, 0)).fit.knots, first.fit.knots);
  document.park.water = 30;
  EXPECT_EQ(open_end(document)->position.y, 32) << "over water";
}

TEST(LandPlans, force_sections_dive_below_the_plane_on_a_land_alone) {
  world::Document document = test::straight_document({0, 6, 0}, {40, 6, 0});
  world::ForceProgram program;
  program.speed = 20, program.length = 120;
  program.keys(world::ForceChannel::vertical) = {{.at = 0, .value = 0.2}};  // falls
  const TrackEnd end = *open_end(document);
  const ForcePath plane = force_path(force_task(document, end, program));
  EXPECT_NE(plane.stopped.find("ground"), std::string::npos) << plane.stopped;
  test::shape_land(document, [](double, double) { return 3.0; });
  const ForcePath land = force_path(force_task(document, end, program));
  EXPECT_EQ(land.stopped.find("ground"), std::string::npos) << land.stopped;
  EXPECT_LT(land.curve.points.back().position.y, -5);
  ASSERT_GT(land.curve.points.size(), plane.curve.points.size());
  for (std::size_t i = 0; i < plane.curve.points.size(); ++i)
    ASSERT_EQ(land.curve.points[i].position, plane.curve.points[i].position) << "the same as far as both go";
}

// Closing sections keep 1 m over the water, or go as low as they like without any.
TEST(LandPlans, closing_sections_stay_above_the_bottom_of_their_land) {
  CircuitTask task;
  task.from = {{0, 1.5, 0}, {1, 0, 0}, {0, 1, 0}}, task.home = {{-60, 1.5, 30}, {1, 0, 0}, {0, 1, 0}};
  task.speed = 14, task.coasts = false;
  const auto lowest = [&] {
    const CircuitCandidates found = circuit_candidates(task);
    double low = 1e9;
    for (const double level : found.levels) low = std::min(low, level);
    return low;
  };
  EXPECT_GE(lowest(), 0.9);
  EXPECT_EQ(std::string(bottom_name(task)), "ground");
  task.water = world::kNoWater;
  EXPECT_NEAR(lowest(), 1.5 - 4, 1e-9) << "under other track";
  task.water = -1.2;
  EXPECT_GE(lowest(), -0.3);
  EXPECT_EQ(std::string(bottom_name(task)), "water");
}

}  // namespace land_plans_test
}  // namespace coaster::sim
