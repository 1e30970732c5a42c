// Tests the bridge to a held end (sim/plan/force_end_constraint.h).
#include "sim/plan/force_end_constraint.h"

#include <gtest/gtest.h>

#include "sim/plan/force_path.h"

namespace coaster::sim {
namespace force_bridge_test {

using glm::dvec3;

// The keys of the task with what a bridge needs more, at many places, lead along the bridge to its end.
TEST(force_bridge, its_forces_lead_to_the_end) {
  for (const double riders : {0.0, 1.1}) {
    ForceTask task;
    task.end.position = {3, 40, -2}, task.riders = riders, task.losses = {0.02f, 2e-5f};
    task.program.speed = 22;
    task.program.keys(world::ForceChannel::vertical) = {{0, 1}, {20, 2}};
    TrackEnd& to = task.held.emplace();
    to.position = {52, 46, 9}, to.forward = glm::normalize(dvec3(1, 0.1, 0.5));
    to.up = glm::normalize(dvec3(-0.1, 1, 0.3)), to.up -= glm::dot(to.up, to.forward) * to.forward;
    to.up = glm::normalize(to.up);
    to.curvature = 0.01 * to.up, to.spin = 0.02;
    constexpr std::size_t kParts = 400;
    const auto bridge = force_bridge(task, kParts);
    ASSERT_TRUE(bridge);
    ForceTask led = task;
    world::ForceProgram& added = led.added.emplace();
    added.length = bridge->length;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i <= kParts; ++i)
        added.channels[c].push_back({bridge->length * static_cast<double>(i) / kParts, bridge->more[i][c]});
    const ForcePath path = force_path(led);
    ASSERT_EQ(path.stopped, "");
    const ElementPoint& last = path.curve.points.back();
    EXPECT_LT(glm::distance(last.position, to.position), 0.5);
    EXPECT_LT(glm::distance(last.tangent, to.forward), 0.02);
    EXPECT_LT(glm::distance(last.up, to.up), 0.02);
    EXPECT_LT(glm::distance(last.curvature, to.curvature), 0.002);
    EXPECT_NEAR(last.spin, to.spin, 0.002);
  }
}

TEST(force_bridge, gives_nothing_for_ends_in_one_place_or_opposite_or_too_high) {
  ForceTask task;
  task.end.position = {0, 40, 0}, task.program.speed = 22;
  task.held = task.end;
  EXPECT_FALSE(force_bridge(task, 8));
  task.held->position.x += 30;
  EXPECT_TRUE(force_bridge(task, 8));
  task.held->forward = -task.end.forward;
  EXPECT_FALSE(force_bridge(task, 8));
  task.held = task.end, task.held->position += dvec3(30, 60, 0);
  EXPECT_FALSE(force_bridge(task, 8));
}

}  // namespace force_bridge_test
}  // namespace coaster::sim
