#include "sim/plan/force_elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/portable_math.h"
#include "base/tries.h"
#include "sim/force_oracle.h"
#include "sim/plan/element_plan.h"
#include "sim/plan/force_plan.h"
#include "world/element_rows.h"

namespace coaster::sim {
namespace force_elements_test {

using base::radians;
using glm::dvec3;
using world::ElementKind;
using world::ForceChannel;

// The end of a track that rises by an angle, in the air, and a train there.
ForceTask at(double speed, double degrees = 0, double riders = 0) {
  ForceTask task;
  const auto [sin, cos] = base::sin_cos(radians(degrees));
  task.end.position = {0, 200, 0}, task.end.forward = {cos, sin, 0}, task.end.up = {-sin, cos, 0};
  task.program.speed = speed, task.riders = riders;
  task.losses = {0.01f, 0.0002f};
  return task;
}
world::Element of(ElementKind kind, std::initializer_list<std::pair<std::string_view, double>> values = {}) {
  world::Element element = world::usual_element(kind);
  for (const auto& [name, value] : values) world::set_value(element, name, value);
  return element;
}

// Where another integration of the keys leads, after some of the program.
test::ForceOracle led(const ForceTask& task, double share = 1) {
  test::ForceOracle oracle(task);
  oracle.go_to(share * task.program.length, 0.02L);
  return oracle;
}
ForceTask with(ForceTask task, const ForceElement& element) {
  EXPECT_EQ(element.refusal, "");
  task.program = element.program;
  return task;
}
double angle_of(const test::ForceOracle& o) { return base::degrees(std::asin(double(o.forward[1]))); }

// Returns the seconds for which a program requires a value.
double seconds_at(const world::ForceProgram& program, double g) {
  double seconds = 0;
  const auto& keys = program.keys(ForceChannel::vertical);
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (std::abs(keys[i].value - g) < 1e-9 && std::abs(keys[i - 1].value - g) < 1e-9)
      seconds += keys[i].at - keys[i - 1].at;
  return seconds;
}

TEST(force_elements, a_hill_floats_as_long_as_asked_is_level_in_the_middle_of_that_and_at_its_end) {
  for (const double speed : {21.0, 35.0})
    for (const double g : {0.0, -0.6}) {
      const ForceTask task =
          with(at(speed, 3), force_element(of(ElementKind::force_hill, {{"g", g}}), at(speed, 3), 0));
      EXPECT_NEAR(seconds_at(task.program, g), 1.5, 1e-9) << speed;
      const auto& keys = task.program.keys(ForceChannel::vertical);
      test::ForceOracle oracle(task);
      oracle.go_to((keys[3].at + keys[4].at) / 2, 0.02L);
      EXPECT_NEAR(angle_of(oracle), 0, 0.01) << speed;
      EXPECT_NEAR(angle_of(led(task)), 0, 0.01) << speed;
    }
}

// Where the track rises already, less of the pull makes the middle level: how much less is told, if it is.
TEST(force_elements, a_hill_tells_of_a_weaker_pull_and_of_no_other) {
  int told = 0, silent = 0;
  for (const double rise : {-6.0, 0.0, 8.0, 14.0, 20.0, 26.0}) {
    const ForceElement found = force_element(of(ElementKind::force_hill), at(30, rise), 0);
    if (!found.refusal.empty()) continue;
    const auto& keys = found.program.keys(ForceChannel::vertical);
    ASSERT_GT(keys.size(), 4u);
    const double first = keys[1].value;  // after the ramp from 1 g
    const double pull = world::value_of(of(ElementKind::force_hill), "pull");
    if (first > 0.98 * pull && first < 0.999 * pull) continue;  // told or not
    ASSERT_EQ(found.lines.empty(), first >= 0.98 * pull) << rise << ": " << first;
    if (found.lines.empty()) {
      ++silent;
      continue;
    }
    ++told;
    char words[80];
    std::snprintf(words, sizeof words, "Reduced pull from %.1f g to %.1f g at the start", pull, first);
    EXPECT_EQ(found.lines[0].find(words), 0u) << found.lines[0];
  }
  EXPECT_GT(told, 1);
  EXPECT_GT(silent, 0);
}

TEST(force_elements, from_a_level_start_a_hill_returns_to_its_height) {
  const ForceTask task = with(at(25), force_element(of(ElementKind::force_hill, {{"seconds", 3}}), at(25), 0));
  EXPECT_NEAR(seconds_at(task.program, 0), 3, 1e-9);
  EXPECT_NEAR(double(led(task).position[1]), 200, 0.005);
  EXPECT_GT(double(led(task, 0.5).position[1]), 210);
  EXPECT_NEAR(angle_of(led(task)), 0, 0.01);
}

TEST(force_elements, a_falling_hill_ends_straight) {
  const ForceTask task =
      with(at(25), force_element(of(ElementKind::force_hill, {{"seconds", 2}, {"ends", 1}}), at(25), 0));
  const ForcePath path = force_path(task);
  EXPECT_LT(angle_of(led(task)), -20);
  EXPECT_LT(glm::length(path.curve.points.back().curvature), 1e-5);
}

TEST(force_elements, a_zero_g_roll_ends_level_and_upright_with_riders_above_the_rails) {
  for (const double riders : {0.0, 1.1}) {
    const ForceTask task = with(at(26, 0, riders), force_element(of(ElementKind::force_roll), at(26, 0, riders), 0));
    EXPECT_NEAR(seconds_at(task.program, 0), 2, 1e-9);
    EXPECT_LE(task.program.tolerance, 0.1) << "g: what riders may feel of a float";
    const test::ForceOracle end = led(task);
    EXPECT_NEAR(angle_of(end), 0, 0.05) << riders;
    EXPECT_NEAR(double(end.up[2]), 0, 1e-3) << riders;
    const auto& keys = task.program.keys(ForceChannel::roll);
    test::ForceOracle middle(task);
    middle.go_to((keys[1].at + keys[2].at) / 2, 0.02L);
    EXPECT_LT(double(middle.up[1]), -0.99) << riders;  // the riders' heads are down
  }
}

TEST(force_elements, a_valley_ends_at_its_slope_with_at_most_its_g) {
  struct Case {
    double from, to, g;
  };
  for (const Case c : {Case{-40, 0, 3.5}, {-5, 0, 3.5}, {0, 45, 4}, {20, -30, 0.2}, {0, -75, -1}}) {
    const ForceTask start = at(24, c.from);
    const ForceTask task =
        with(start, force_element(of(ElementKind::force_valley, {{"g", c.g}, {"slope", c.to}}), start, 0));
    EXPECT_NEAR(angle_of(led(task)), c.to, 0.01) << c.from;
    for (const world::ForceKey& key : task.program.keys(ForceChannel::vertical))
      EXPECT_TRUE(c.g > 1 ? key.value <= c.g + 1e-9 : key.value >= c.g - 1e-9) << c.from;
  }
}

TEST(force_elements, brakes_are_straight_and_as_long_as_the_train_needs) {
  const ForceTask start = at(20, -10);
  const ForceElement element = force_element(of(ElementKind::force_brakes), start, 15);
  const ForceTask task = with(start, element);
  EXPECT_NEAR(angle_of(led(task)), -10, 1e-6);
  EXPECT_NEAR(task.program.length, (400 - 16) / 12.0 + 15 + 2, 1);
  ASSERT_TRUE(element.equipment);
  EXPECT_EQ(element.equipment->kind, world::EquipmentKind::brake);
}

void refused(const world::Element& element, const ForceTask& start, std::string_view why) {
  const std::string refusal = force_element(element, start, 0).refusal;
  EXPECT_NE(refusal.find(why), std::string::npos) << refusal;
}
TEST(force_elements, what_cannot_be_is_refused_with_the_reason) {
  refused(of(ElementKind::force_hill), at(2), "2.0 m/s there, and forces need 3 m/s: add a launch");
  refused(of(ElementKind::force_hill, {{"seconds", 8}}), at(12), "too slow to float for 8 s");
  refused(of(ElementKind::force_hill, {{"seconds", 0.3}}), at(30, 60), "rises too steeply to float for only 0.3 s");
  refused(of(ElementKind::force_valley), at(20), "slope of 0.0 degrees already");
  refused(of(ElementKind::force_valley, {{"slope", -20}}), at(20), "bends the track up, away from a slope of -20");
  refused(of(ElementKind::force_turn), at(20, -20), "slope of -20 degrees there");
  refused(of(ElementKind::force_turn, {{"angle", 20}, {"g", 3}}), at(15), "roll-out alone turn");
  refused(of(ElementKind::force_loop), at(3.5), "too slow for a loop");
  refused(of(ElementKind::force_brakes), at(3.5), "slower than 4 m/s already");
  refused(of(ElementKind::force_hill), at(20, 88), "steeper than 80 degrees");
  ForceTask banked = at(20);
  banked.end.up = {0, 0.6, 0.8};
  refused(of(ElementKind::force_turn), banked, "banked");
}

// For any values, the result is a program within all limits, or a reason.
TEST(force_elements, values_at_their_limits_and_beyond_give_sound_programs_or_refusals) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  world::Document document;
  int k = 0;
  for (std::size_t i = 0; i < world::force_elements().size(); ++i) {
    const auto kind = static_cast<ElementKind>(world::elements().size() + i);
    for (std::size_t p = 0; p < world::force_elements()[i].parameters.size(); ++p)
      for (const double value : {-1e300, 1e300, nan, 0.0})
        for (const double speed : {4.0, 18.0, 60.0}) {
          if (!test::tried(k++)) continue;
          world::Element element = world::usual_element(kind);
          element.values[p] = value;
          const ElementPlan plan = plan_element(element, document, speed);
          ASSERT_EQ(plan.forces && !world::broken(*plan.forces) && !plan.fit.knots.empty(), plan.refusal.empty())
              << world::force_elements()[i].name << " " << plan.refusal;
        }
  }
}

}  // namespace force_elements_test
}  // namespace coaster::sim
