// Tests keys of forces that become keys of curvature, and back (sim/plan/force_plan.h).
#include "sim/plan/force_plan.h"

#include <gtest/gtest.h>

#include "sim/force_oracle.h"
#include "world/topology.h"

namespace coaster::sim {
namespace force_quantity_test {

using world::ForceChannel;
using world::ForceDomain;
using world::ForceQuantity;

ForcePlan planned(ForceTask task, const world::ForceProgram& program) {
  task.program = program;
  return plan_force(task);
}

// Returns the largest distance of points of one path from the same lengths of the other.
double apart(const ForcePlan& a, const ForcePlan& b) {
  double most = std::abs(a.length - b.length);
  for (std::size_t i = 0; i < a.path.points.size(); ++i) {
    const ElementPoint& p = a.path.curve.points[i];
    const auto next = std::ranges::upper_bound(b.path.curve.points, p.s, {}, &ElementPoint::s);
    if (next == b.path.curve.points.begin() || next == b.path.curve.points.end()) continue;
    const ElementPoint& before = *(next - 1);
    const double share = (p.s - before.s) / (next->s - before.s);
    most = std::max(most, glm::distance(p.position, glm::mix(before.position, next->position, share)));
  }
  return most;
}

TEST(force_quantity, curvature_of_forces_leads_along_the_same_path_and_back) {
  test::RandomForces random(12);
  for (int i = 0; i < 6; ++i) {
    const ForcePlan plan = plan_force(random.next(60));
    ASSERT_EQ(plan.refusal, "") << i;
    const world::ForceProgram bends = of_other_quantity(plan);
    EXPECT_EQ(bends.of, ForceQuantity::curvature);
    EXPECT_EQ(bends.over, plan.task.program.over);
    EXPECT_FALSE(world::broken(bends)) << *world::broken(bends);
    const ForcePlan bent = planned(plan.task, bends);
    EXPECT_EQ(bent.path.stopped, "") << i;
    EXPECT_LT(apart(bent, plan), 0.2) << i;
    const ForcePlan back = planned(bent.task, of_other_quantity(bent));
    EXPECT_EQ(back.task.program.of, ForceQuantity::forces);
    EXPECT_LT(apart(back, bent), 0.2) << i;
    // The keys that were there stay, and have what the path has there.
    for (std::size_t c = 0; c < 3; ++c)
      for (const world::ForceKey& key : plan.task.program.channels[c]) {
        const auto same = std::ranges::find(bends.channels[c], key.at, &world::ForceKey::at);
        ASSERT_NE(same, bends.channels[c].end()) << i << ' ' << key.at;
        const ElementPoint& on = plan.path.curve.points[plan.point_at(key.at)];
        const glm::dvec3 left = glm::cross(on.up, on.tangent);
        const double square = plan.path.points[plan.point_at(key.at)].square,
                     metres = plan.task.program.over == ForceDomain::time ? std::sqrt(square) : 1;
        const double has = c == 2 ? same->slope / metres : same->value, on_path = c == 2 ? on.spin * 180 / M_PI
                                                                                  : c == 1
                                                                                      ? glm::dot(on.curvature, left)
                                                                                      : glm::dot(on.curvature, on.up);
        EXPECT_NEAR(has, on_path, c == 2 ? 0.05 : 1e-9) << i << ' ' << c;
      }
  }
}

TEST(force_quantity, keys_of_either_quantity_stay_in_place_on_the_other_axis) {
  test::RandomForces forces(13);
  test::RandomCurvature bends(13);
  for (const ForceTask& task : {forces.next(60), bends.next(60)}) {
    const ForcePlan plan = plan_force(task);
    const ForcePlan other = planned(task, over_other_axis(plan));
    EXPECT_NE(other.task.program.over, task.program.over);
    EXPECT_EQ(other.path.stopped, "");
    EXPECT_LT(apart(other, plan), 0.5) << "between keys the curve is one of time";
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(other.task.program.channels[c].size(), task.program.channels[c].size());
    EXPECT_EQ(other.task.program.channels[0].back().value, task.program.channels[0].back().value);
    const world::ForceKey &roll = task.program.channels[2][1], &moved = other.task.program.channels[2][1];
    EXPECT_EQ(moved.value == roll.value, task.program.of == ForceQuantity::curvature)
        << "an angle stays, a rate does not";
  }
}

// On a level straight the train keeps its speed, so that places are times of the speed, also those of keys beyond the
// end of the path.
TEST(force_quantity, keys_beyond_the_end_move_at_the_last_speed) {
  for (const ForceDomain over : {ForceDomain::distance, ForceDomain::time}) {
    ForceTask task;
    task.end.position = {3, 40, -7}, task.end.forward = {0.6, 0, 0.8};
    world::ForceProgram program;
    program.over = over, program.speed = 8, program.length = over == ForceDomain::time ? 3 : 24;
    const double unit = over == ForceDomain::time ? 8 : 1.0 / 8;
    for (const double share : {0.0, 0.5, 1.0, 1.5})
      program.keys(ForceChannel::vertical).push_back({share * program.length, 1});
    const ForcePlan plan = planned(task, program);
    ASSERT_EQ(plan.refusal, "");
    const world::ForceProgram other = over_other_axis(plan);
    EXPECT_NEAR(other.length, program.length * unit, 1e-6);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(other.channels[0].at(k).at, program.channels[0][k].at * unit, 1e-6) << k;
  }
}

TEST(force_quantity, the_track_has_the_curvature_and_the_angle_of_the_keys) {
  test::RandomCurvature random(14);
  const ForcePlan plan = plan_force(random.next(90));
  world::Document document;
  document.heartline = plan.task.riders;
  for (const world::Knot& knot : plan.fit.spans.knots) world::append_knot(document, knot);
  const DerivedTrack derived = shapes_of(document);
  for (std::size_t i = 0; i < plan.path.points.size(); i += 7) {
    const std::array<double, 3> has = curvature_at(derived, 0, plan.path.curve.points[i].s);
    EXPECT_NEAR(has[0], plan.path.points[i].asked(ForceChannel::vertical), 0.0014) << i;
    EXPECT_NEAR(has[1], plan.path.points[i].asked(ForceChannel::lateral), 0.0014) << i;
    EXPECT_NEAR(has[2], plan.path.points[i].asked(ForceChannel::roll), 1.2) << i;
  }
  const std::size_t half = derived.order.size() / 2;
  const double s = derived.starts[half] + 1;
  double turned = 0;
  for (std::size_t i = 0; i < half; ++i) turned += derived.shape_at(i).roll.twist * 180 / M_PI;
  EXPECT_NEAR(curvature_at(derived, half, s)[2], curvature_at(derived, 0, s)[2] - turned, 1e-9);
}

}  // namespace force_quantity_test
}  // namespace coaster::sim
