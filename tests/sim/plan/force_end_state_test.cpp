// Part: src/sim/plan/force_elements.
#include "sim/plan/force_elements.h"

#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "sim/force_oracle.h"
#include "sim/plan/force_path.h"

namespace coaster::sim {
namespace force_end_state_test {

TEST(force_walk, ends_where_the_path_does) {
  test::RandomForces random(5);
  for (int i = 0; i < 6; ++i) {
    const ForceTask task = random.next(90);
    const ForcePath path = force_path(task);
    const auto walk = walk_force(task);
    ASSERT_TRUE(walk && path.stopped.empty()) << i;
    EXPECT_LT(glm::distance(walk->end.position, path.curve.points.back().position), 0.01) << i;
    EXPECT_LT(glm::distance(walk->end.tangent, path.curve.points.back().tangent), 1e-3) << i;
    EXPECT_EQ(walk->rise(), walk->end.tangent.y);
  }
}

// On a circle of constant curvature, without weight: a fast train, so that gravity hardly matters.
TEST(force_walk, counts_turns_beyond_half_a_circle) {
  ForceTask task;
  task.end.position = {0, 1000, 0};
  task.program.speed = 100, task.program.length = 900;
  task.program.keys(world::ForceChannel::vertical) = {{0, 10}};
  const auto loop = walk_force(task);
  ASSERT_TRUE(loop);
  EXPECT_GT(loop->pitch, 1.5 * base::kPi);
  task.end.up = {0, 0, 1};  // lying on its side: the same circle to the right
  task.end.up = glm::normalize(task.end.up);
  const auto turn = walk_force(task);
  ASSERT_TRUE(turn);
  EXPECT_LT(turn->heading, -1.5 * base::kPi);
}

TEST(force_walk, stops_where_the_train_does) {
  ForceTask task;
  task.program.speed = 8, task.program.length = 60;
  task.program.keys(world::ForceChannel::vertical) = {{0, 0.6}};  // straight up the slope
  task.end.position = {0, 100, 0};
  task.end.forward = {0.6, 0.8, 0}, task.end.up = {-0.8, 0.6, 0};
  EXPECT_FALSE(walk_force(task));
}

TEST(force_walk, no_program_is_followed_beyond_the_limit_of_its_length) {
  ForceTask task;
  task.program.over = world::ForceDomain::time;
  task.program.speed = 20, task.program.length = world::kLongestForce_s;
  EXPECT_TRUE(walk_force(task));
  task.program.length = 1e12;  // as a search may ask for
  EXPECT_FALSE(walk_force(task));
}

TEST(newton, finds_roots_of_a_system_and_gives_up_without_one) {
  using glm::dvec2;
  const auto circle_and_line = [](dvec2 x) -> std::optional<dvec2> {
    return dvec2(x.x * x.x + x.y * x.y - 25, x.x - x.y - 1);
  };
  const auto root = newton<2>({1, 6}, 1e-6, 1e-10, circle_and_line);
  ASSERT_TRUE(root);
  EXPECT_NEAR(root->x, 4, 1e-9);
  EXPECT_NEAR(root->y, 3, 1e-9);
  const auto none = [](dvec2 x) -> std::optional<dvec2> { return dvec2(x.x * x.x + 1, x.y); };
  EXPECT_FALSE(newton<2>({1, 1}, 1e-6, 1e-10, none));
  EXPECT_FALSE(newton<2>({1, 1}, 1e-6, 1e-10, [](dvec2) { return std::optional<dvec2>(); }));
}

}  // namespace force_end_state_test
}  // namespace coaster::sim
