// The parts of a way home against other means: turns integrated by small steps, heights by differences, ends by the
// track's own curvature.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "sim/plan/circuit_search.h"
#include "sim/random_elements.h"

namespace coaster::sim {
namespace circuit_test {

using glm::dvec2;
using glm::dvec3;

// Follows the heading with straight steps of 3 cm, by its value in their middle.
dvec2 followed(const Turns& turns, dvec2 from) {
  const int steps = static_cast<int>(turns.length() / 0.01) + 1;
  const double step = turns.length() / steps;
  for (int i = 0; i < steps; ++i) {
    const double heading = turns.at((i + 0.5) * step).angle;
    from += step * dvec2(std::cos(heading), std::sin(heading));
  }
  return from;
}

TEST(circuit_turns, every_choice_arrives_at_the_place_and_heading_of_the_end) {
  std::mt19937 bits(7);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  const double radii[] = {11.3, 24.7}, straights[] = {0, 13};
  std::size_t exact = 0;
  for (int round = 0; round < 12; ++round) {
    const PlanPose from{{uniform(-60, 60), uniform(-60, 60)}, uniform(-4, 4)},
        to{{uniform(-60, 60), uniform(-60, 60)}, uniform(-4, 4)};
    const double shortest = round % 2 == 0 ? Bend::kShortest : 21.4;
    const std::vector<TurnChoice> choices = turn_choices(from, to, radii, straights, shortest);
    EXPECT_GE(choices.size(), 8u) << "both circles to the same side always have a common tangent";
    for (std::size_t i = 0; i < choices.size(); i += 5) {
      const TurnChoice& choice = choices[i];
      EXPECT_LT(glm::distance(followed(choice.rough, from.place), to.place), 0.3);
      const std::optional<Turns> turns = exact_turns(from, to, choice);
      if (!turns) continue;
      ++exact;
      EXPECT_LT(glm::distance(followed(*turns, from.place), to.place), 2e-4);
      EXPECT_NEAR(std::remainder(turns->second.to - to.heading, 2 * M_PI), 0, 1e-9);
      EXPECT_EQ(turns->first.from, from.heading);
      for (const Bend* bend : {&turns->first, &turns->second})
        EXPECT_TRUE(bend->length() == 0 || bend->length() > shortest - 1e-9) << bend->length();
      for (double u = 0; u < turns->length(); u += 0.7) {
        EXPECT_LE(std::abs(turns->at(u).bend), 1 / choice.radius + 1e-9);
        EXPECT_NEAR((turns->at(u + 1e-5).angle - turns->at(std::max(0.0, u - 1e-5)).angle) / (u > 0 ? 2e-5 : 1e-5),
                    turns->at(u).bend, 2e-4);
      }
    }
  }
  EXPECT_GT(exact, 100u);
}

TEST(circuit_heights, reach_the_end_at_its_slope_within_the_radii) {
  std::mt19937 bits(9);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  int found = 0;
  for (int round = 0; round < 400; ++round) {
    const HeightEnds ends{uniform(60, 300), uniform(2, 40), uniform(2, 40), uniform(-0.6, 0.6), uniform(-0.6, 0.6)};
    const HeightLimits limits{uniform(15, 40), uniform(12, 30), 0.7};
    const double level = uniform(2, 40);
    for (const bool steady : {true, false}) {
      const auto heights = steady ? steady_heights(ends, limits) : heights_by_way_of(level, ends, limits);
      if (!heights) continue;
      ++found;
      EXPECT_NEAR(heights->length(), ends.length, 1e-6);
      const auto first = heights->at(0), last = heights->at(ends.length);
      EXPECT_NEAR(first.height, ends.from, 1e-9);
      EXPECT_NEAR(first.slope, ends.slope_from, 1e-9);
      EXPECT_NEAR(last.height, ends.to, 1e-6);
      EXPECT_NEAR(last.slope, ends.slope_to, 1e-9);
      bool reached = steady;
      for (double u = 0.1; u < ends.length - 0.1; u += 0.37) {
        const auto here = heights->at(u), next = heights->at(u + 1e-4), before = heights->at(u - 1e-4);
        EXPECT_NEAR((next.height - before.height) / 2e-4, here.slope, 1e-6);
        EXPECT_NEAR((next.slope - before.slope) / 2e-4, here.change, 1e-4);
        EXPECT_LE(here.change, 1 / limits.valley + 1e-9);
        EXPECT_GE(here.change, -1 / limits.crest - 1e-9);
        reached = reached || std::abs(here.height - level) < 0.35;
      }
      EXPECT_TRUE(reached);
    }
  }
  EXPECT_GT(found, 200);
}

// The curve has the ends' curvature, roll and spin to the bit, and is continuous in between.
TEST(circuit_way, its_curve_meets_both_ends_and_keeps_tangent_curvature_and_roll_continuous) {
  test::RandomElements random(5);
  int curves = 0;
  for (int round = 0; round < 60 && curves < 12; ++round) {
    CircuitTask task;
    task.from = random.end(), task.home = random.end();
    task.from.spin = random.uniform(-0.02, 0.02), task.home.spin = random.uniform(-0.02, 0.02);
    task.from.position.y += 20;
    for (TrackEnd* const end : {&task.from, &task.home}) end->curvature *= 0.3;  // riders are not thrown out there
    task.speed = 14, task.riders = 1.1;
    const CircuitCandidates candidates = circuit_candidates(task);
    if (!candidates.refusal.empty() || candidates.list.empty()) continue;
    const std::optional<CircuitWay> way = candidates.exact(candidates.list.front());
    ASSERT_TRUE(way);
    ++curves;
    const ElementCurve curve = way_curve(task, *way);
    const ElementPoint &first = curve.points.front(), &last = curve.points.back();
    EXPECT_EQ(first.position, task.from.position);
    EXPECT_LT(glm::length(first.curvature - task.from.curvature), 1e-9);
    EXPECT_LT(glm::length(first.up - task.from.up), 1e-9);
    EXPECT_EQ(first.spin, task.from.spin);
    EXPECT_EQ(last.position, task.home.position);
    EXPECT_LT(glm::length(last.up - task.home.up), 1e-9);
    EXPECT_EQ(last.spin, task.home.spin);
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const ElementPoint &a = curve.points[i - 1], &b = curve.points[i];
      const double step = b.s - a.s;
      ASSERT_GT(step, 0);
      EXPECT_LT(glm::length(b.position - a.position - 0.5 * step * (a.tangent + b.tangent)), 1e-4) << b.s;
      EXPECT_LT(glm::length(b.tangent - a.tangent - 0.5 * step * (a.curvature + b.curvature)), 2e-3) << b.s;
      EXPECT_LT(glm::length(b.curvature - a.curvature), 0.03) << b.s;
      EXPECT_LT(glm::length(b.up - a.up), 0.35) << b.s;
    }
  }
  EXPECT_EQ(curves, 12);
}

TEST(circuit_search, says_what_makes_a_way_home_impossible) {
  CircuitTask task;
  task.from.position = {0, 3, 0}, task.home.position = {40, 30, 10};
  task.speed = 9;
  EXPECT_EQ(circuit_candidates(task).refusal,
            "the train is too slow: it would reach the first knot, 27 m higher, at less than 2 m/s");
  task.coasts = false;
  EXPECT_EQ(circuit_candidates(task).refusal, "");
  task.home.curvature = {0, 0, 1};
  EXPECT_EQ(circuit_candidates(task).refusal, "the first knot is too sharp: its radius is 1 m");
  task.home.curvature = {0, 0, 0}, task.home.position.x = 4000;
  EXPECT_NE(circuit_candidates(task).refusal.find("too far away: 4000"), std::string::npos);
}

}  // namespace circuit_test
}  // namespace coaster::sim
