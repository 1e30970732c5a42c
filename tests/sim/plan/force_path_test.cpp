// Sections of curvature; those of forces are in force_path_test.cpp.
#include "sim/plan/force_path.h"

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/force_oracle.h"

namespace coaster::sim {
namespace force_path_test {

using glm::dvec3;
using world::ForceChannel;
using world::ForceDomain;

// Level, straight and of curvature.
ForceTask bent(double length) {
  ForceTask task;
  task.end.position = {0, 100, 0};
  task.program.of = world::ForceQuantity::curvature, task.program.speed = 20, task.program.length = length;
  task.riders = 1.1, task.losses = {0.02f, 2e-5f};
  return task;
}

dvec3 of(const test::Vector& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

// The turns of a frame by curvature k(s) upwards alone stay in one plane: with the angle integral of k, the position is
// the integral of its cosine and sine, here by Simpson's rule in long double.
TEST(force_law, constant_curvature_is_a_circle_and_a_linear_one_a_clothoid) {
  ForceTask task = bent(60);
  auto& up = task.program.keys(ForceChannel::vertical);
  for (const double slope : {0.0, 0.0008}) {
    const double first = 0.015;
    up = {{0, first, slope}, {60, first + 60 * slope, slope}};
    task.end.curvature = {0, first, 0};
    const ForcePath path = force_path(task);
    ASSERT_EQ(path.stopped, "");
    ASSERT_EQ(path.ramp, 0);
    long double x = 0, y = 0;
    const auto angle = [&](long double s) { return first * s + slope * s * s / 2; };
    constexpr int kParts = 2000;
    for (int i = 0; i < kParts; ++i) {
      const long double h = 60.0L / kParts, s = h * i;
      x += h / 6 * (std::cos(angle(s)) + 4 * std::cos(angle(s + h / 2)) + std::cos(angle(s + h)));
      y += h / 6 * (std::sin(angle(s)) + 4 * std::sin(angle(s + h / 2)) + std::sin(angle(s + h)));
    }
    EXPECT_LT(glm::distance(path.curve.points.back().position, dvec3(double(x), 100 + double(y), 0)), 1e-6) << slope;
    if (slope > 0) continue;
    const dvec3 centre(0, 100 + 1 / first, 0);
    for (const ElementPoint& p : path.curve.points) EXPECT_NEAR(glm::distance(p.position, centre), 1 / first, 1e-6);
  }
}

TEST(force_law, roll_of_curvature_is_the_angle_that_the_frame_turns_by) {
  for (const ForceDomain over : {ForceDomain::distance, ForceDomain::time}) {
    ForceTask task = bent(over == ForceDomain::time ? 3 : 60);
    task.program.over = over;
    const double half = task.program.length / 2;
    task.program.keys(ForceChannel::roll) = {{0, 0}, {half, 70}, {2 * half, -400}};
    const ForcePath path = force_path(task);
    ASSERT_EQ(path.stopped, "");
    for (std::size_t k = 0; k < path.points.size(); ++k) {
      const ElementPoint& p = path.curve.points[k];
      EXPECT_NEAR(p.position.y, 100, 1e-12) << "straight";
      const double u = path.points[k].at / half, v = u < 1 ? u : u - 1, rise = v * v * (3 - 2 * v),
                   angle = M_PI / 180 * (u < 1 ? 70 * rise : 70 - 470 * rise);
      EXPECT_NEAR(p.up.y, std::cos(angle), 1e-5) << p.s;
      EXPECT_NEAR(p.up.z, std::sin(angle), 1e-5) << p.s << ": to the right";
    }
  }
}

TEST(force_law, curvature_is_the_same_at_any_speed_and_at_none) {
  test::RandomCurvature random(3);
  ForceTask task = random.next(80);
  const ForcePath path = force_path(task);
  for (const double speed : {0.0, 4.0, 33.0}) {
    task.program.speed = speed;
    const ForcePath again = force_path(task);
    ASSERT_EQ(again.points.size(), path.points.size()) << speed << again.stopped;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
      EXPECT_EQ(again.curve.points[k].position, path.curve.points[k].position) << speed;
      EXPECT_EQ(again.curve.points[k].up, path.curve.points[k].up) << speed;
      EXPECT_TRUE(std::isfinite(again.points[k].up) && std::isfinite(again.points[k].time)) << speed;
    }
  }
}

TEST(force_law, curvature_ends_where_the_oracle_does) {
  for (const unsigned seed : {1u, 2u}) {
    if (test::kSanitized && seed > 1) continue;
    test::RandomCurvature random(seed);
    for (int i = 0; i < test::tries(5); ++i) {
      const ForceTask task = random.next(i == 0 ? 300 : 60);
      const ForcePath path = force_path(task);
      test::ForceOracle oracle(task);
      oracle.go_to(path.points.back().at);
      EXPECT_LT(glm::distance(of(oracle.position), path.curve.points.back().position), 0.005) << seed << ' ' << i;
      EXPECT_LT(glm::distance(of(oracle.up), path.curve.points.back().up), 1e-4) << seed << ' ' << i;
    }
  }
}

// Keys that begin with another curvature, angle and rate of roll than the track's end are reached after a ramp.
TEST(force_law, curvature_continues_that_of_the_track_and_its_spin) {
  for (const ForceDomain over : {ForceDomain::distance, ForceDomain::time}) {
    ForceTask task = bent(over == ForceDomain::time ? 4 : 80);
    task.program.over = over;
    task.end.curvature = {0, 0.02, -0.015}, task.end.spin = 0.04;
    task.program.keys(ForceChannel::vertical) = {{0, 0.004}};
    task.program.keys(ForceChannel::roll) = {{0, 30, 0.5}, {task.program.length, 60}};
    const ForcePath path = force_path(task);
    const ElementPoint& first = path.curve.points.front();
    EXPECT_LT(glm::distance(first.curvature, task.end.curvature), 1e-12);
    EXPECT_NEAR(first.spin, task.end.spin, 1e-12);
    EXPECT_GT(path.ramp, 0);
    EXPECT_LT(path.ramp, task.program.length / 2);
    const ForceCurve roll(task.program, ForceChannel::roll);
    double angle = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
      const ElementPoint &a = path.curve.points[k - 1], &b = path.curve.points[k];
      EXPECT_LT(glm::distance(a.curvature, b.curvature), 0.003) << b.s;
      EXPECT_LT(std::abs(a.spin - b.spin), 0.02) << b.s;
      angle += 180 / M_PI * (a.spin + b.spin) / 2 * (b.s - a.s);
      EXPECT_NEAR(path.points[k].asked(ForceChannel::roll), angle, 0.05) << b.s;
      if (path.points[k].at < path.ramp) continue;
      EXPECT_NEAR(path.points[k].asked(ForceChannel::vertical), 0.004, 1e-12) << b.s;
      EXPECT_NEAR(path.points[k].asked(ForceChannel::roll), roll.at(path.points[k].at).value, 1e-9) << b.s;
    }
  }
}

// Launches and brakes act on the cars that are on the section: the first from the start, one more each `spacing`
// metres. A lift pulls the whole train.
TEST(force_law, equipment_drives_the_part_of_the_train_that_has_entered) {
  using world::EquipmentKind;
  ForceTask task = bent(200);
  task.cars = 5, task.spacing = 3;
  const double g = world::kGravity, sine = 0.2, square = 100, losses = 0.02 * g + 2e-5 * square, push = 7.5;
  ForceState train;
  train.tangent = {std::sqrt(1 - sine * sine), sine, 0}, train.square = square;
  EXPECT_NEAR(ForceLaw(task).along(train), -g * sine - losses, 1e-6);
  world::Equipment equipment;
  equipment.acceleration = static_cast<float>(push);
  for (int on = 1; on <= 5; ++on)
    for (const double length : {3.0 * (on - 1) + 0.1, on < 5 ? 3.0 * on - 0.1 : 190.0}) {
      SCOPED_TRACE(length);
      train.length = length;
      const auto driven = [&](EquipmentKind kind, double speed, bool braking) {
        equipment.kind = kind, equipment.speed = static_cast<float>(speed);
        task.equipment = equipment, train.braking = braking;
        return ForceLaw(task).along(train) + g * sine + losses;
      };
      const double share = push * on / 5;
      for (const EquipmentKind kind : {EquipmentKind::brake, EquipmentKind::block}) {
        EXPECT_NEAR(driven(kind, 5, true), -share, 1e-6);
        EXPECT_NEAR(driven(kind, 5, false), -share, 1e-6) << "too fast";
        EXPECT_NEAR(driven(kind, 10, false), 0, 1e-6);
      }
      EXPECT_NEAR(driven(EquipmentKind::launch, 30, false), share, 1e-6);
      EXPECT_NEAR(driven(EquipmentKind::launch, 8, false), 0, 1e-6) << "faster already";
      // At its speed a launch makes up for the slope and the losses, as far as it can.
      EXPECT_NEAR(driven(EquipmentKind::launch, 10, false), std::min(share, g * sine + losses), 1e-6);
      EXPECT_NEAR(driven(EquipmentKind::lift, 30, false), push + g * sine + losses, 1e-6);
      EXPECT_NEAR(driven(EquipmentKind::lift, 10, false), g * sine + losses, 1e-6) << "it holds the speed";
      EXPECT_NEAR(driven(EquipmentKind::lift, 8, false), 0, 1e-6);
      EXPECT_NEAR(driven(EquipmentKind::station, 30, true), 0, 1e-6);
    }
  // Below the slowest speed no slope stops the train, and no brakes do.
  train.square = 0.5 * world::kSlowestForce * world::kSlowestForce, train.braking = true;
  equipment.kind = EquipmentKind::brake, task.equipment = equipment;
  EXPECT_NEAR(ForceLaw(task).along(train), 0, 1e-12);
  train.tangent.y = -sine;
  EXPECT_GT(ForceLaw(task).along(train), 1);
}

TEST(force_law, equipment_that_brings_a_train_to_its_speed_keeps_it_there_and_brakes_change_over) {
  using world::EquipmentKind;
  ForceTask task = bent(200);
  world::Equipment equipment;
  equipment.speed = 10, equipment.hysteresis = 1;
  const auto settled = [&](EquipmentKind kind, double before, double after, bool braking = false) {
    equipment.kind = kind, task.equipment = equipment;
    ForceState from, next;
    from.square = before * before, next.square = after * after, next.braking = braking;
    ForceLaw(task).settle(from, next);
    return std::pair(std::sqrt(next.square), next.braking);
  };
  for (const EquipmentKind kind : {EquipmentKind::lift, EquipmentKind::launch}) {
    EXPECT_EQ(settled(kind, 9.9, 10.2).first, 10);
    EXPECT_EQ(settled(kind, 10.2, 9.9).first, 10);
    EXPECT_NEAR(settled(kind, 9.7, 9.9).first, 9.9, 1e-12);
    EXPECT_NEAR(settled(kind, 10.3, 10.1).first, 10.1, 1e-12);
    EXPECT_NEAR(settled(kind, 10, 9.8).first, 9.8, 1e-12);
  }
  for (const EquipmentKind kind : {EquipmentKind::brake, EquipmentKind::block}) {
    EXPECT_TRUE(settled(kind, 12, 11.1).second);
    EXPECT_FALSE(settled(kind, 12, 10.9).second);
    EXPECT_TRUE(settled(kind, 12, 10.9, true).second);
    EXPECT_EQ(settled(kind, 9.2, 8.8, true), std::pair(9.0, false)) << "down to its speed less the hysteresis";
  }
  equipment.speed = 0;
  EXPECT_EQ(settled(EquipmentKind::brake, 2, 0.1, true), std::pair(double{world::kSlowestForce}, true));
}

}  // namespace force_path_test
}  // namespace coaster::sim
