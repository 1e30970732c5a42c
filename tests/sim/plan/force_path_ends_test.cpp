// Tests the path of a force section (sim/plan/force_path.h), which integrates its law.
#include <gtest/gtest.h>

#include "base/tries.h"
#include "curve/frames.h"
#include "sim/force_oracle.h"
#include "sim/plan/force_path.h"

namespace coaster::sim {
namespace force_path_ends_test {

using glm::dvec3;
using world::ForceChannel;
using world::ForceDomain;

ForceTask level(double speed, double length, ForceDomain over = ForceDomain::distance) {
  ForceTask task;
  task.end.position = {0, 100, 0};
  task.program.speed = speed, task.program.length = length, task.program.over = over;
  return task;
}

dvec3 of(const test::Vector& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

// A program that starts with the values felt there needs no ramp, so the oracle needs none.
class ForceOracle : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(seed, ForceOracle, testing::Values(7, 8, 9, 10));

TEST_P(ForceOracle, five_of_twenty_programs_end_where_the_oracle_does) {
  test::RandomForces random(GetParam());
  for (int i = 0; i < test::tries(5); ++i) {
    const ForceTask task = random.next(i == 0 && GetParam() < 10 ? 300 : 60);
    const ForcePath path = force_path(task);
    ASSERT_EQ(path.stopped, "") << i;
    ASSERT_LT(path.ramp, 1e-9) << i;
    test::ForceOracle oracle(task);
    double farthest = 0;
    for (std::size_t k = 0; k < path.points.size(); k += 1 + path.points.size() / 4) {
      oracle.go_to(path.points[k].at);
      farthest = std::max(farthest, glm::distance(of(oracle.position), path.curve.points[k].position));
    }
    oracle.go_to(path.points.back().at);
    farthest = std::max(farthest, glm::distance(of(oracle.position), path.curve.points.back().position));
    EXPECT_LT(farthest, 0.005) << i << ": 5 cm are asked for";
    EXPECT_LT(glm::distance(of(oracle.up), path.curve.points.back().up), 1e-4) << i;
    EXPECT_NEAR(double(oracle.square), path.points.back().square, 0.01) << i;
    EXPECT_NEAR(double(oracle.time), path.points.back().time, 1e-4) << i;
  }
}

TEST(force_path, nothing_felt_is_the_path_of_a_thrown_body) {
  ForceTask task = level(20, 1.5, ForceDomain::time);
  task.end.forward = glm::normalize(dvec3(1, 0.6, 0)), task.end.up = glm::normalize(dvec3(-0.6, 1, 0));
  // The track's end bends as the body's path, so that there is no ramp.
  const double bend = 9.81 * task.end.up.y / (20 * 20);
  task.end.curvature = -bend * task.end.up;
  task.program.keys(ForceChannel::vertical) = {{0, 0}};
  const ForcePath path = force_path(task);
  ASSERT_EQ(path.stopped, "");
  for (std::size_t k = 0; k < path.points.size(); ++k) {
    const double t = path.points[k].time;
    const dvec3 thrown = task.end.position + 20 * t * task.end.forward - dvec3(0, 9.81 / 2 * t * t, 0);
    EXPECT_LT(glm::distance(path.curve.points[k].position, thrown), 1e-6) << t;
  }
}

// Level and rolled by 90 degrees, gravity pulls across the seat: with as much lateral g as holds against it, and
// vertical g alone bending the track, it is a circle at constant speed.
TEST(force_path, constant_g_across_gravity_is_a_circle) {
  ForceTask task = level(20, 150);
  const double g = 2.5, radius = 20.0 * 20 / (g * 9.81);
  task.end.up = {0, 0, 1};  // towards its left is down: lateral g to the left is -1 against gravity
  task.end.curvature = dvec3(0, 0, 1 / radius);
  task.program.keys(ForceChannel::vertical) = {{0, g}};
  task.program.keys(ForceChannel::lateral) = {{0, glm::cross(task.end.up, task.end.forward).y}};
  const ForcePath path = force_path(task);
  const dvec3 centre = task.end.position + radius * task.end.up;
  ASSERT_NE(path.stopped, "") << "after a turn it meets itself";
  EXPECT_NEAR(path.curve.length(), 2 * M_PI * radius, 2) << "up to its own rails";
  for (const ElementPoint& p : path.curve.points) {
    EXPECT_NEAR(glm::distance(p.position, centre), radius, 1e-5) << p.s;
    EXPECT_NEAR(p.position.y, 100, 1e-7) << p.s;
  }
}

// Riders in the curve itself roll about their hearts: the curve stays straight, whatever the roll is, when they are
// asked to feel gravity alone.
TEST(force_path, a_heartline_roll_stays_straight) {
  ForceTask task = level(15, 60);
  task.riders = 0, task.rails = -1.1;
  const ForcePath straight = force_path(task);
  ASSERT_EQ(straight.stopped, "");
  EXPECT_LT(glm::distance(straight.curve.points.back().position, dvec3(60, 100, 0)), 1e-9);
  // Rolled by 6 degrees a metre, gravity turns against the seat: cosine up, sine to the side.
  task.program.length = 30;
  task.program.keys(ForceChannel::roll) = {{0, 6}};
  task.end.spin = 6 * M_PI / 180;
  auto &up = task.program.keys(ForceChannel::vertical), &side = task.program.keys(ForceChannel::lateral);
  for (int i = 0; i <= 30; ++i) {
    const double angle = 6 * M_PI / 180 * i, rate = 6 * M_PI / 180;
    up.push_back({double(i), std::cos(angle), -rate * std::sin(angle)});
    side.push_back({double(i), std::sin(angle), rate * std::cos(angle)});
  }
  const ForcePath rolled = force_path(task);
  ASSERT_EQ(rolled.stopped, "");
  const ElementPoint& end = rolled.curve.points.back();
  EXPECT_LT(glm::distance(end.position, dvec3(30, 100, 0)), 0.01);
  EXPECT_NEAR(end.up.y, std::cos(M_PI), 1e-6) << "half a turn";
}

TEST(force_path, the_start_continues_the_curvature_and_the_spin_of_the_track) {
  for (const ForceDomain over : {ForceDomain::distance, ForceDomain::time}) {
    ForceTask task = level(18, over == ForceDomain::time ? 3 : 50, over);
    task.riders = 1.1;
    task.end.curvature = {0, 0.02, -0.015}, task.end.spin = 0.04;
    task.program.keys(ForceChannel::vertical) = {{0, 1.5}};
    const ForcePath path = force_path(task);
    const ElementPoint& first = path.curve.points.front();
    EXPECT_LT(glm::distance(first.curvature, task.end.curvature), 1e-12);
    EXPECT_NEAR(first.spin, task.end.spin, 1e-12);
    EXPECT_GT(path.ramp, 0);
    // The required value is reached after the ramp, and without a jump before.
    for (std::size_t k = 1; k < path.points.size(); ++k) {
      EXPECT_LT(std::abs(path.points[k].up - path.points[k - 1].up), 0.2) << k;
      if (path.points[k].at >= path.ramp) {
        EXPECT_NEAR(path.points[k].up, 1.5, 1e-9) << k;
      }
    }
  }
}

// On a level straight without losses equipment adds its acceleration: v^2 = v0^2 + 2 a s.
TEST(force_path, equipment_of_the_section_counts_in_its_speed) {
  const auto with = [](world::EquipmentKind kind, float speed, float acceleration, double from, int cars = 1) {
    ForceTask task = level(from, 100);
    world::Equipment& e = task.equipment.emplace(world::Equipment{kind});
    e.speed = speed, e.acceleration = acceleration, e.hysteresis = 0.5f;
    task.cars = cars, task.spacing = 3;
    return task;
  };
  const auto square_at = [](const ForceTask& task, double s) {
    const ForcePath path = force_path(task);
    EXPECT_EQ(path.stopped, "");
    const auto at = std::ranges::upper_bound(path.points, s - 1e-9, {}, &ForcePoint::at);
    EXPECT_NEAR(at->at, s, 1e-6);
    return at->square;
  };
  using world::EquipmentKind;
  const ForceTask launch = with(EquipmentKind::launch, 28, 5, 10);
  EXPECT_NEAR(square_at(launch, 60), 100 + 2 * 5 * 60, 1e-6);
  EXPECT_NEAR(square_at(launch, 69), 28 * 28, 1e-6);
  EXPECT_NEAR(force_path(launch).points.back().time, 18 / 5.0 + (100 - (784 - 100) / 10.0) / 28, 2e-3);
  // Of five cars, three metres apart, one more is pushed each three metres.
  EXPECT_NEAR(square_at(with(EquipmentKind::launch, 28, 5, 10, 5), 60), 100 + 10 * (3 * (0.2 + 0.4 + 0.6 + 0.8) + 48),
              1.0);
  EXPECT_NEAR(square_at(with(EquipmentKind::brake, 8, 6, 20), 20), 400 - 12 * 20, 1e-6);
  EXPECT_NEAR(square_at(with(EquipmentKind::brake, 8, 6, 20), 50), 7.5 * 7.5, 1e-6);
  ForceTask slow = with(EquipmentKind::brake, 2.8f, 6, 20);
  slow.losses.rolling = 0.02f;
  EXPECT_NEAR(square_at(slow, 60), 3 * 3, 1e-6) << "not below 3 m/s";
  EXPECT_NEAR(square_at(with(EquipmentKind::station, 4, 3, 20), 50), 400, 1e-6);
  // A lift on a slope keeps its speed, and lets faster trains climb freely down to it.
  ForceTask lift = with(EquipmentKind::lift, 5, 3, 5);
  lift.end.forward = {0.8, 0.6, 0}, lift.end.up = {-0.6, 0.8, 0};
  lift.program.keys(ForceChannel::vertical) = {{0, 0.8}};
  EXPECT_NEAR(square_at(lift, 100), 25, 1e-9);
  lift.program.speed = 12;
  EXPECT_NEAR(square_at(lift, 5), 144 - 2 * 9.81 * 0.6 * 5, 1e-6);
  EXPECT_NEAR(square_at(lift, 100), 25, 1e-9);
}

TEST(force_path, stops_with_the_reason) {
  ForceTask task = level(8, 200);
  task.end.forward = glm::normalize(dvec3(1, 1, 0)), task.end.up = glm::normalize(dvec3(-1, 1, 0));
  task.program.keys(ForceChannel::vertical) = {{0, std::sqrt(0.5)}};
  EXPECT_EQ(force_path(task).stopped, "the train falls below 3 m/s");
  task = level(20, 400);
  task.program.keys(ForceChannel::vertical) = {{0, 0}};
  EXPECT_EQ(force_path(task).stopped, "the track would run into the ground");
  task = level(20, 400);
  task.end.position = {world::kMaxCoordinate - 50.0, 50, 0};
  EXPECT_EQ(force_path(task).stopped.substr(0, 32), "the track would leave the world,");
  task = level(24, 400);
  task.program.keys(ForceChannel::vertical) = {{0, 1}, {20, 4.5}};
  EXPECT_EQ(force_path(task).stopped, "the track would run through itself") << "a loop in one plane";
  task = level(5, 100);
  task.program.keys(ForceChannel::vertical) = {{0, 1}, {10, 9}};
  EXPECT_EQ(force_path(task).stopped, "the turn would be tighter than a radius of 2 m");
  for (const ElementPoint& p : force_path(task).curve.points) EXPECT_LE(glm::length(p.curvature), 0.5);
}

}  // namespace force_path_ends_test
}  // namespace coaster::sim
