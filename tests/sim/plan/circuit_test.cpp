// The parts of a closing section, checked by other methods: turns integrated by small steps, heights by differences,
// ends by the track's own curvature.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "sim/plan/closing_candidates.h"
#include "sim/random_elements.h"

namespace coaster::sim {
namespace circuit_test {

using glm::dvec2;
using glm::dvec3;

// Follows the heading with straight steps of 3 cm, by its value in their middle.
dvec2 followed(const TurnsInPlan& turns, dvec2 from) {
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
      const std::optional<TurnsInPlan> turns = exact_turns(from, to, choice);
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
TEST(closing_curve, its_curve_meets_both_ends_and_keeps_tangent_curvature_and_roll_continuous) {
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
    const std::optional<ClosingCurve> closing = candidates.exact(candidates.list.front());
    ASSERT_TRUE(closing);
    ++curves;
    const ElementCurve curve = ideal_closing(task, *closing);
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

// The curve between the leads by its definition: place by integration, derivatives by differences.
struct Middle {
  const ClosingCurve& closing;
  std::vector<dvec3> places;
  double step;
  explicit Middle(const ClosingCurve& of, int count) : closing(of), step(of.turns.length() / count) {
    dvec2 at = closing.in.pose.place;
    constexpr int kFine = 8;
    for (int i = 0; i <= count; ++i) {
      places.push_back({at.x, closing.heights.at(i * step).height, at.y});
      for (int k = 0; k < kFine; ++k) {
        const double heading = closing.turns.at(i * step + (k + 0.5) * step / kFine).angle;
        at += step / kFine * dvec2(std::cos(heading), std::sin(heading));
      }
    }
  }
};

// Felt is what carries the rider: gravity's opposite and the acceleration across the track, by three places of it.
TEST(closing_curve, what_is_estimated_is_felt_and_the_rough_line_is_the_rails) {
  int ways = 0, lifted = 0, pressed = 0;
  for (const bool coasts : {true, false})
    for (const double rise : {-9.0, 4.0, 11.0})
      for (const double aside : {0.0, 47.0}) {
        CircuitTask task;
        task.from.position = {60, 20, 0}, task.home.position = {0, 20 + rise, aside};
        task.speed = 21, task.coasts = coasts, task.rails = 0.7;
        const CircuitCandidates candidates = circuit_candidates(task);
        for (std::size_t i = 0; i < candidates.list.size(); i += 1 + candidates.list.size() / 3) {
          const ClosingCurve closing = candidates.rough(candidates.list[i]);
          constexpr int kSteps = 2'000;
          const std::optional<FeltRange> felt = estimate(task, closing, kSteps);
          if (!felt) continue;
          ++ways;
          const Middle middle(closing, kSteps);
          double most = 1, least = 1;
          const auto square = [&](dvec3 place) {
            return 441 - (coasts ? 2 * 9.81 * (place.y - task.from.position.y) : 0);
          };
          for (std::size_t k = 1; k < kSteps; ++k) {
            const dvec3 in = middle.places[k] - middle.places[k - 1], out = middle.places[k + 1] - middle.places[k];
            const dvec3 tangent = glm::normalize(in + out),
                        bend = 2.0 * (glm::normalize(out) - glm::normalize(in)) / (glm::length(in) + glm::length(out));
            const dvec3 force = square(middle.places[k]) / 9.81 * bend + dvec3(0, 1, 0);
            const dvec3 above = glm::normalize(dvec3(0, 1, 0) - tangent.y * tangent);
            most = std::max(most, glm::length(force - glm::dot(force, tangent) * tangent));
            least = std::min(least, glm::dot(force, above));
          }
          EXPECT_NEAR(felt->most, most, 0.03);
          EXPECT_NEAR(felt->least, least, 0.03);
          lifted += least<0.8, pressed += most> 1.5;
          const double each = 2.3;
          const std::vector<ClosingPlace> line = rough_line(task, closing, each);
          const Middle at(closing, static_cast<int>(line.size()) - 1);
          EXPECT_TRUE(line.size() == 301 ? at.step > each : at.step <= each && at.step > 0.8 * each) << at.step;
          EXPECT_EQ(line.front().s, closing.in.length);
          for (std::size_t k = 0; k < line.size(); ++k) {
            EXPECT_LT(glm::distance(line[k].rails - 0.7 * line[k].up, at.places[k]), 0.05);
            EXPECT_NEAR(glm::length(line[k].up), 1, 1e-9);
            if (k > 0) {
              EXPECT_NEAR(line[k].s - line[k - 1].s, glm::distance(at.places[k], at.places[k - 1]), 0.1);
            }
          }
        }
      }
  EXPECT_GT(ways, 15);
  EXPECT_GT(lifted, 5);
  EXPECT_GT(pressed, 5);
}

// By the riders' own places over time instead of by the length of track.
TEST(closing_curve, riders_feel_their_acceleration_by_time) {
  int ways = 0;
  for (const bool coasts : {true, false})
    for (const double rise : {-8.0, 6.0}) {
      CircuitTask task;
      task.from.position = {60, 20, 0}, task.home.position = {0, 20 + rise, 31};
      task.speed = 19, task.coasts = coasts, task.riders = 1.1;
      const CircuitCandidates candidates = circuit_candidates(task);
      for (std::size_t i = 0; i < candidates.list.size(); i += 1 + candidates.list.size() / 3) {
        const std::optional<ClosingCurve> closing = candidates.exact(candidates.list[i]);
        if (!closing) continue;
        ++ways;
        const ElementCurve curve = ideal_closing(task, *closing);
        const FeltRange felt = felt_on(task, curve);
        const auto speed = [&](std::size_t k) {
          const double down = task.from.position.y - curve.points[k].position.y;
          return std::sqrt(361 + (coasts ? 2 * 9.81 * down : 0));
        };
        const auto riders = [&](std::size_t k) { return curve.points[k].position + 1.1 * curve.points[k].up; };
        FeltRange expected;
        for (std::size_t k = 1; k + 1 < curve.points.size(); ++k) {
          const auto& p = curve.points;
          const double before = (p[k].s - p[k - 1].s) / (0.5 * (speed(k - 1) + speed(k))),
                       after = (p[k + 1].s - p[k].s) / (0.5 * (speed(k) + speed(k + 1)));
          const dvec3 change = (riders(k + 1) - riders(k)) / after - (riders(k) - riders(k - 1)) / before;
          const dvec3 force = 2.0 * change / ((before + after) * 9.81) + dvec3(0, 1, 0);
          const double up = glm::dot(force, p[k].up);
          expected.most = std::max(expected.most, up), expected.least = std::min(expected.least, up);
          expected.side = std::max(expected.side, std::abs(glm::dot(force, glm::cross(p[k].up, p[k].tangent))));
        }
        EXPECT_NEAR(felt.most, expected.most, 0.005);
        EXPECT_NEAR(felt.least, expected.least, 0.005);
        EXPECT_NEAR(felt.side, expected.side, 0.005);
      }
    }
  EXPECT_GT(ways, 5);
}

// The rate at which `up` turns about the tangent between two points, by the least rotation from one to the other.
double roll_rate(const ElementPoint& a, const ElementPoint& b) {
  const dvec3 carried = curve::least_rotation(a.tangent, b.tangent, a.up, a.up);
  return curve::signed_angle(carried, b.up, b.tangent) / (b.s - a.s);
}

// A kept speed, and level ends without curvature: 60 m apart, for closing sections in half circles.
CircuitTask level_task() {
  CircuitTask task;
  task.from.position = {60, 20, 0}, task.home.position = {0, 20, 0};
  task.speed = 20, task.coasts = false, task.riders = 1.1;
  return task;
}

TEST(closing_curve, spins_at_every_point_as_its_frame_turns) {
  for (const double spin : {-0.04, 0.0, 0.04}) {
    CircuitTask task = level_task();
    task.from.spin = spin, task.home.spin = 0.5 * spin;
    const CircuitCandidates candidates = circuit_candidates(task);
    ASSERT_FALSE(candidates.list.empty());
    const ElementCurve curve = ideal_closing(task, candidates.exact(candidates.list.front()).value());
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const ElementPoint &a = curve.points[i - 1], &b = curve.points[i];
      ASSERT_NEAR(roll_rate(a, b), 0.5 * (a.spin + b.spin), 1e-3) << "at " << b.s << " m with spin " << spin;
    }
  }
}

// The same way from an upright end shows what fades. A cubic of the time T that turns by r has a rate of 1.5 r / T in
// its middle and a change of 6 r / T^2 at its ends: one of them is the limit, where the fade is not the shortest.
TEST(closing_curve, fades_the_roll_of_the_open_end_as_quickly_as_riders_bear) {
  const CircuitTask upright = level_task();
  const CircuitCandidates candidates = circuit_candidates(upright);
  ASSERT_FALSE(candidates.list.empty());
  const ClosingCurve closing = candidates.exact(candidates.list.front()).value();
  const ElementCurve plain = ideal_closing(upright, closing);
  for (const double roll : {0.3, -0.6, 1.3}) {
    CircuitTask task = upright;
    task.from.up = curve::rotate(task.from.up, task.from.forward, roll);
    const ElementCurve rolled = ideal_closing(task, closing);
    ASSERT_EQ(rolled.points.size(), plain.points.size());
    const auto left = [&](std::size_t i) {
      return curve::signed_angle(plain.points[i].up, rolled.points[i].up, plain.points[i].tangent);
    };
    double rate = 0, change = 0, before = 0;
    for (std::size_t i = 1; i < plain.points.size(); ++i) {
      const double seconds = (plain.points[i].s - plain.points[i - 1].s) / task.speed,
                   now = (left(i) - left(i - 1)) / seconds;
      rate = std::max(rate, std::abs(now));
      if (i > 1) change = std::max(change, std::abs(now - before) / seconds);
      before = now;
    }
    EXPECT_LT(rate, 1.03) << roll;
    EXPECT_LT(change, 3.15) << roll;
    EXPECT_TRUE(rate > 0.95 || change > 2.8) << roll << ": " << rate << " rad/s, " << change << " rad/s^2";
  }
}

// Brute force: the rails of every candidate each 10 cm. A level of 4 m below the ends is tried: with 5 cm more than the
// limit it is used, with 5 cm less it is not.
TEST(circuit_search, keeps_rails_a_metre_above_the_ground_where_the_ends_are) {
  int i = 0;
  for (const double rails : {-1.1, 0.0, 1.1})
    for (const double ends : {0.6, 4.95, 5.05}) {
      if (!test::tried(i++)) continue;
      CircuitTask task = level_task();
      task.speed = 14, task.rails = rails;
      for (TrackEnd* const end : {&task.from, &task.home}) end->position.y = ends - rails;
      const CircuitCandidates candidates = circuit_candidates(task);
      double lowest = 1e9;
      for (const CircuitCandidate& candidate : candidates.list) {
        const HeightProfile heights = candidates.rough(candidate).heights;
        for (double u = 0; u < heights.length(); u += 0.1) lowest = std::min(lowest, heights.at(u).height + rails);
      }
      EXPECT_NEAR(lowest, ends == 4.95 ? 4.95 : ends == 5.05 ? 1.05 : 0.6, 0.02) << rails << ", " << ends;
    }
}

// On an unchanged track that is the way itself, of all the ways with other radii, straights, levels and bends. Where
// the first knot moves by 2 m its turns keep their radius: any other is 1.6 m wider or more.
TEST(circuit_search, the_way_most_like_a_former_one_comes_first) {
  int ways = 0, moves = 0;
  for (const double aside : {0.0, 30.0, 55.0}) {
    CircuitTask task = level_task();
    task.home.position += dvec3(0, -3, aside);
    if (aside > 30) task.home.forward = {-1, 0, 0};
    const CircuitCandidates candidates = circuit_candidates(task);
    for (std::size_t i = 0; i < candidates.list.size(); i += 1 + candidates.list.size() / 12) {
      const CircuitCandidate& candidate = candidates.list[i];
      const std::optional<ClosingCurve> closing = candidates.exact(candidate);
      if (!closing) continue;
      const world::ClosingPlan former = candidates.described(candidate, *closing);
      const CircuitCandidates again = candidates_like(former, task);
      ASSERT_FALSE(again.list.empty());
      const std::optional<ClosingCurve> first = again.exact(again.list.front());
      ASSERT_TRUE(first);
      const world::ClosingPlan found = again.described(again.list.front(), *first);
      EXPECT_EQ(found.radius, former.radius);
      EXPECT_EQ(found.before, former.before);
      EXPECT_EQ(found.after, former.after);
      EXPECT_NEAR(found.first, former.first, 1e-3);
      EXPECT_NEAR(found.second, former.second, 1e-3);
      EXPECT_EQ(found.level, former.level);
      EXPECT_EQ(found.tight, former.tight);
      ++ways;
      for (const dvec3 move : {dvec3(2, 0, 0), dvec3(-2, 0, 0), dvec3(0, 0, 2), dvec3(0, 0, -2)}) {
        CircuitTask moved = task;
        moved.home.position += move;
        const CircuitCandidates like = candidates_like(former, moved);
        if (like.list.empty()) continue;
        EXPECT_EQ(like.turns[like.list.front().turns].radius, former.radius) << i;
        ++moves;
      }
    }
  }
  EXPECT_GT(ways, 20);
  EXPECT_GT(moves, 80);
}

TEST(circuit_search, says_what_makes_a_closing_section_impossible) {
  CircuitTask task;
  task.from.position = {0, 3, 0}, task.home.position = {40, 30, 10};
  task.speed = 9;
  EXPECT_EQ(circuit_candidates(task).refusal,
            "the train would reach the first knot, 27 m higher, at less than 2 m/s: climb by a lift, or add a launch");
  task.coasts = false;
  EXPECT_EQ(circuit_candidates(task).refusal, "");
  task.home.curvature = {0, 0, 1};
  EXPECT_EQ(circuit_candidates(task).refusal, "the first knot is too sharp: its radius is 1 m");
  task.home.curvature = {0, 0, 0}, task.home.position.x = 4000;
  EXPECT_NE(circuit_candidates(task).refusal.find("too far away: 4000"), std::string::npos);
}

}  // namespace circuit_test
}  // namespace coaster::sim
