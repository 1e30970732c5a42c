// Tests the values of keys that follow a way (sim/plan/force_keys_from_track.h).
#include "sim/plan/force_keys_from_track.h"

#include <gtest/gtest.h>

#include "sim/force_oracle.h"

namespace coaster::sim {
namespace force_solve_test {

// A smooth program over some 60 m, at random, whose keys have the slopes that solving gives them.
ForceTask planted() {
  test::RandomForces random(7);
  for (;;) {
    ForceTask task = random.next(60);
    if (task.program.over != world::ForceDomain::distance) continue;
    with_slopes(task);
    if (force_path(task).stopped.empty()) return task;
  }
}

struct Way {
  std::vector<double> at;
  std::vector<ElementPoint> points;
};
Way way_of(const ForceTask& task) {
  const ForcePath path = force_path(task);
  Way way{{}, path.curve.points};
  for (const ElementPoint& point : way.points) way.at.push_back(point.s);
  return way;
}
ForceGoal goal_of(const Way& way) {
  return {[&way](double s) {
            const auto found = std::lower_bound(way.at.begin(), way.at.end(), s - 1e-6);
            return way.points[static_cast<std::size_t>(found - way.at.begin())];
          },
          way.points.back()};
}

TEST(ForceSolve, traces_the_path_that_is_planned) {
  const ForceTask task = planted();
  const ForcePath path = force_path(task);
  const ForceTrace trace = trace_force(task);
  ASSERT_EQ(path.stopped, "");
  ASSERT_TRUE(trace.complete);
  ASSERT_EQ(trace.states.size(), path.points.size());
  for (std::size_t i = 0; i < trace.states.size(); ++i)
    EXPECT_EQ(trace.states[i].position, path.curve.points[i].position);
}

TEST(ForceSolve, finds_planted_values_again) {
  const ForceTask task = planted();
  const Way way = way_of(task);
  const ForceGoal goal = goal_of(way);
  ForceTask off = task;
  for (auto& keys : off.program.channels)
    for (std::size_t i = 1; i < keys.size(); ++i) keys[i].value += i % 2 == 0 ? 0.08 : -0.06;
  double error = 1;
  const auto solved = solve_forces(off, goal, error);
  ASSERT_TRUE(solved);
  EXPECT_LT(error, 5e-4);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < task.program.channels[c].size(); ++i)
      EXPECT_NEAR(solved->program.channels[c][i].value, task.program.channels[c][i].value, 0.01) << c << ' ' << i;
  const ForcePath path = force_path(*solved);
  const ElementPoint &last = path.curve.points.back(), &end = way.points.back();
  EXPECT_LT(glm::distance(last.position, end.position), 1e-5);
  EXPECT_LT(glm::distance(last.tangent, end.tangent), 1e-6);
  EXPECT_LT(glm::distance(last.up, end.up), 1e-6);
  EXPECT_LT(glm::distance(last.curvature, end.curvature), 1e-6);
  EXPECT_NEAR(last.spin, end.spin, 1e-6);
}

TEST(ForceSolve, leaves_values_that_lead_there_already) {
  const ForceTask task = planted();
  const Way way = way_of(task);
  double error = 1;
  const auto solved = solve_forces(task, goal_of(way), error);
  ASSERT_TRUE(solved);
  EXPECT_LT(error, 1e-9);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < task.program.channels[c].size(); ++i)
      EXPECT_NEAR(solved->program.channels[c][i].value, task.program.channels[c][i].value, 1e-9) << c << ' ' << i;
}

TEST(ForceSolve, gives_nothing_where_the_train_does_not_get) {
  ForceTask task = planted();
  const Way way = way_of(task);
  task.program.speed = 5;
  task.program.channels[0][1].value = 2;
  double error = 0;
  EXPECT_FALSE(solve_forces(task, goal_of(way), error));
}

}  // namespace force_solve_test
}  // namespace coaster::sim
