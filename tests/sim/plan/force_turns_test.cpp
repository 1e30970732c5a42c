// Tests turns and rolls of forces (sim/plan/force_elements.h).
#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "sim/force_oracle.h"
#include "sim/plan/force_elements.h"
#include "sim/plan/force_path.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace force_turns_test {

using glm::dvec3;
using world::ElementKind;
using world::ForceChannel;

ForceTask level(double speed, double riders) {
  ForceTask task;
  task.end.position = {0, 200, 0};
  task.program.speed = speed, task.riders = riders, task.losses = {0.01f, 0.0002f};
  return task;
}

ForceTask made(ElementKind kind, bool right, double speed, double riders, std::string_view name = {},
               double value = 0) {
  world::Element element = world::usual_element(kind);
  element.right = right;
  if (!name.empty()) world::set_value(element, name, value);
  ForceTask task = level(speed, riders);
  const ForceElement found = force_element(element, task, 0);
  EXPECT_EQ(found.refusal, "");
  task.program = found.program;
  return task;
}

// By another integration.
struct End {
  dvec3 position, forward, up;
};
End end_of(const ForceTask& task) {
  test::ForceOracle o(task);
  o.go_to(task.program.length, 0.02L);
  const auto of = [](const test::Vector& v) { return dvec3(double(v[0]), double(v[1]), double(v[2])); };
  return {of(o.position), of(o.forward), of(o.up)};
}

TEST(force_turns, a_turn_has_its_angle_ends_level_and_upright_and_holds_its_g) {
  for (const double riders : {0.0, 1.1})
    for (const double angle : {90.0, 180.0, 250.0}) {
      const bool right = angle == 90;
      const ForceTask task = made(ElementKind::force_turn, right, 27, riders, "angle", angle);
      const End end = end_of(task);
      const auto [sin, cos] = base::sin_cos(base::radians(angle));
      EXPECT_LT(glm::distance(end.forward, dvec3(cos, 0, right ? sin : -sin)), 5e-4) << angle;
      EXPECT_NEAR(end.up.y, 1, 1e-6) << angle;
      EXPECT_NEAR(end.position.y, 200, 0.02) << angle;
      const ForcePath path = force_path(task);
      double most = 0, deepest = 0;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        most = std::max(most, path.points[i].up);
        deepest = std::max(deepest, std::abs(path.curve.points[i].position.y - 200));
        EXPECT_EQ(path.points[i].side, 0);
      }
      EXPECT_NEAR(most, 2.5, 1e-6);
      EXPECT_LT(deepest, 1.5) << "the turn stays about level";
    }
}

// The vertical keys are 1 + s (1 / cos b - 1) of the bank b, with s so that it is the turn's g at the full bank. Their
// slopes are its derivative, where the bank turns as the roll channel says.
TEST(force_turns, the_keys_of_a_roll_out_follow_the_bank_and_so_do_their_slopes) {
  for (const bool right : {false, true}) {
    const ForceTask task = made(ElementKind::force_turn, right, 27, 0, "angle", 90);
    const auto &vertical = task.program.keys(ForceChannel::vertical), &roll = task.program.keys(ForceChannel::roll);
    const double g = vertical[vertical.size() / 2].value, bank = std::acos(1 / g);
    ASSERT_NEAR(g, 2.5, 1e-6);
    // The angle that is left to the end, by the trapezoidal rule.
    const auto left_at = [&](double from) {
      constexpr int kSteps = 2000;
      double sum = 0;
      for (int i = 0; i < kSteps; ++i)
        sum += static_cast<double>(
            test::ForceOracle::of_keys(roll, 0, from + (i + 0.5L) * (task.program.length - from) / kSteps));
      return std::abs(sum) * (task.program.length - from) / kSteps;
    };
    const double full = left_at(roll[3].at);
    for (std::size_t i = vertical.size() - 5; i < vertical.size(); ++i) {
      const double at = vertical[i].at, share = left_at(at) / full, angle = share * bank,
                   rate = std::abs(static_cast<double>(test::ForceOracle::of_keys(roll, 0, at))) / full * bank;
      EXPECT_NEAR(vertical[i].value, 1 + (g - 1) / (1 / std::cos(bank) - 1) * (1 / std::cos(angle) - 1), 0.01) << i;
      EXPECT_NEAR(vertical[i].slope, -std::sin(angle) / (std::cos(angle) * std::cos(angle)) * rate, 0.02) << i;
    }
  }
}

TEST(force_turns, a_heartline_roll_keeps_the_riders_on_a_straight_line) {
  for (const double riders : {0.0, 1.1})
    for (const bool right : {false, true}) {
      const ForceTask task = made(ElementKind::force_heartline, right, 18, riders);
      const ForcePath path = force_path(task);
      ASSERT_EQ(path.stopped, "");
      double farthest = 0, lowest = 1;
      for (const ElementPoint& p : path.curve.points) {
        const dvec3 off = p.position + riders * p.up - dvec3(0, 200 + riders, 0);
        farthest = std::max(farthest, std::sqrt(off.y * off.y + off.z * off.z));
        lowest = std::min(lowest, p.up.y);
      }
      EXPECT_LT(farthest, riders > 0 ? 0.12 : 0.01);
      EXPECT_LT(lowest, -0.99);
      const End end = end_of(task);
      EXPECT_LT(glm::distance(end.forward, dvec3(1, 0, 0)), 5e-4);
      EXPECT_GT(end.up.y, 1 - 1e-5);
      // To the rider's right: the head is over the right side after a quarter.
      const ElementPoint& quarter = path.curve.points[path.curve.points.size() / 4];
      EXPECT_EQ(quarter.up.z > 0, right);
    }
}

TEST(force_turns, a_loop_goes_over_the_top_at_its_g_and_ends_beside_its_start) {
  for (const double riders : {0.0, 1.1})
    for (const bool right : {false, true}) {
      const ForceTask task = made(ElementKind::force_loop, right, 24, riders, "shift", 4);
      const End end = end_of(task);
      EXPECT_LT(glm::distance(end.forward, dvec3(1, 0, 0)), 1e-3);
      EXPECT_GT(end.up.y, 1 - 1e-5);
      EXPECT_NEAR(end.position.z, right ? 4 : -4, 0.02);
      const ForcePath path = force_path(task);
      ASSERT_EQ(path.stopped, "");
      double lowest = 1, side = 0, top = 0;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        lowest = std::min(lowest, path.curve.points[i].up.y);
        top = std::max(top, path.curve.points[i].position.y - 200);
        side = std::max(side, std::abs(path.points[i].side));
      }
      EXPECT_LT(lowest, -0.99);
      EXPECT_LT(side, 0.3) << "g, to shift it";
      // Between the ramps v (n - cos of the pitch) is constant, so that the top is at most as high as without ramps.
      const double n = 4, v = 24, slow = v * (n - 1) / (n + 1), ideal = (v * v - slow * slow) / (2 * 9.81);
      EXPECT_NEAR(top, ideal, 0.2 * ideal);
    }
}

}  // namespace force_turns_test
}  // namespace coaster::sim
