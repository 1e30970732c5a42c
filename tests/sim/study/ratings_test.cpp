#include "sim/study/ratings.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace ratings_test {

constexpr double kG = world::kGravity, kCutoff = 5.0;

struct Rated {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  world::Entity cart;
  Rated(world::Document d, double speed, double fraction = 0.2) : document(std::move(d)) {
    cart = world::add_cart(document, document.track.segments.at(0), fraction);
    document.start_speed = speed, document.heartline = 0;
    derive(document, {}, {}, derived);
  }
  const SimulatedRide& simulated() { return *cache.ride(document, derived, cart); }
  Ratings rate() {
    const SimulatedRide& g = simulated();
    return sim::rate(g, cache.tables(document, derived), kCutoff);
  }
};

TEST(ratings, a_flat_circle_at_constant_speed_has_constant_g) {
  const double radius = 20.3, speed = 12.7;
  const Ratings r = Rated(test::ring_document(48, radius, 0.0), speed).rate();
  EXPECT_TRUE(r.complete);
  EXPECT_NEAR(r.side_most.value, speed * speed / (radius * kG), 5e-3);
  EXPECT_NEAR(r.up_most.value, 1, 1e-3);
  EXPECT_NEAR(r.up_least.value, 1, 1e-3);
  EXPECT_NEAR(r.forward_most.value, 0, 1e-3);
  EXPECT_NEAR(r.top_speed.value, speed, 1e-4);
  EXPECT_NEAR(r.mean_speed, speed, 1e-3);
  EXPECT_NEAR(r.seconds, 2 * M_PI * radius / speed, 1e-3);
  EXPECT_NEAR(r.length, 2 * M_PI * radius, 1e-3);
  EXPECT_NEAR(r.road_most.value, 0.5 * kG, 0.01);  // the mass is at the rails: nothing tilts the car
  EXPECT_NEAR(r.side_load_most.value, 0.5 * speed * speed / radius, 0.03);
  EXPECT_NEAR(r.up_stop_most.value, 0, 1e-6);
  EXPECT_EQ(r.airtime, 0);
  EXPECT_EQ(r.drops, 0);
  EXPECT_EQ(r.inversions, 0);
  // The published terms, by hand: no negative g, no drop. What excites is the speed alone.
  const double l = speed * speed / (radius * kG);
  EXPECT_NEAR(r.excitement, 1.2 * speed / (speed + 25), 0.01);
  EXPECT_NEAR(r.intensity, 0.8 + l, 0.01);
  EXPECT_NEAR(r.nausea, 0.26 + 0.33 * l, 0.01);
}

// A ballistic parabola is one cubic. At its own speed riders float at 0 g everywhere; with a part q more of kinetic
// energy at the start they are lifted by q v0^2 k(s) / g, k being the curvature, which is g / (v0 cos)^2 at the top.
world::Document parabola(double speed, double angle) {
  const double vx = speed * std::cos(angle), vy = speed * std::sin(angle), time = 2 * vy / kG;
  world::Document d;
  const glm::dvec3 from(3.3, 5.7, -2.9), along = glm::normalize(glm::dvec3(0.8, 0, 0.6));
  const double third = time / 3 * speed;
  const glm::dvec3 rise(0, vy, 0), to = from + time * vx * along;
  const auto handle = static_cast<float>(third);
  world::append_knot(d, test::skew_knot(glm::vec3(from), glm::vec3(vx * along + rise), handle, handle));
  world::append_knot(d, test::skew_knot(glm::vec3(to), glm::vec3(vx * along - rise), handle, handle));
  return d;
}

TEST(ratings, airtime_is_the_time_on_a_parabola_that_is_taken_too_fast) {
  const double speed = 15.0, angle = M_PI / 4, more = 0.21;
  Rated fast(parabola(speed, angle), speed * std::sqrt(1 + more), 0.0);
  const Ratings r = fast.rate();
  EXPECT_TRUE(r.complete);  // to the end of an open track
  EXPECT_NEAR(r.airtime, fast.simulated().seconds(), 0.05);
  EXPECT_NEAR(r.up_least.value, -more * speed * speed / (speed * speed * std::pow(std::cos(angle), 2)), 0.02);
  EXPECT_NEAR(r.up_stop_most.value, -r.up_least.value * 0.5 * kG, 1e-6);
  const Ratings slow = Rated(parabola(speed, angle), speed * 0.98, 0.0).rate();
  EXPECT_EQ(slow.airtime, 0);
  EXPECT_GT(slow.up_least.value, 0);
  EXPECT_NEAR(slow.highest.value - 5.7, speed * speed * 0.5 / (2 * kG), 1e-2);
}

// Every exciting member raises the excitement by decreasing amounts, and jolts and overloads lower it.
TEST(ratings, excitement_rises_with_what_excites_and_falls_with_what_hurts) {
  Ratings base;
  base.highest_drop = 12, base.airtime = 1, base.drops = 2, base.near_misses = 1, base.inversions = 1;
  base.up_most.value = 3, base.top_speed.value = 18;
  using Step = void (*)(Ratings&);
  for (const Step step : {Step([](Ratings& r) { r.highest_drop += 5; }), Step([](Ratings& r) { r.airtime += 1; }),
                          Step([](Ratings& r) { r.drops += 1; }), Step([](Ratings& r) { r.near_misses += 1; }),
                          Step([](Ratings& r) { r.inversions += 1; }), Step([](Ratings& r) { r.up_most.value += 0.9; }),
                          Step([](Ratings& r) { r.top_speed.value += 4; })}) {
    Ratings once = base, twice = base;
    step(once), step(twice), step(twice);
    const double first = excitement_of(once) - excitement_of(base), second = excitement_of(twice) - excitement_of(once);
    EXPECT_GT(second, 0.02);
    EXPECT_GT(first, second);
  }
  for (const Step step :
       {Step([](Ratings& r) { r.jolt_most.value += 1.4; }), Step([](Ratings& r) { r.overload += 0.2; })}) {
    Ratings once = base, twice = base;
    step(once), step(twice), step(twice);
    EXPECT_LT(excitement_of(once), excitement_of(base) - 0.05);
    EXPECT_LT(excitement_of(twice), excitement_of(once) - 0.05);
  }
}

// Tracks that differ in one thing each.
TEST(ratings, a_higher_drop_more_airtime_and_no_jolt_excite_more) {
  double last = 0;
  for (const float height : {8.0f, 15.0f, 25.0f, 40.0f}) {
    world::Document d;
    const float level = std::max(30.0f, 2.5f * height);  // more than both handles, so that no span doubles back
    for (const auto& [x, y] : {std::pair{0.0f, height + 2},
                               {level, height + 2},
                               {level + 2.5f * height, 2.0f},
                               {2 * level + 2.5f * height, 2.0f}})
      world::append_knot(d, test::skew_knot({x, y, 2.7f}, {1, 0, 0}, std::max(9.0f, height), std::max(9.0f, height)));
    const double now = Rated(d, 6.3, 0.0).rate().excitement;
    EXPECT_GT(now, last + 0.1) << height;
    last = now;
  }
  last = 0;
  for (const double more : {-0.02, 0.02}) {  // lifted nowhere, then everywhere on the same parabola
    const double now = Rated(parabola(15, M_PI / 4), 15 * std::sqrt(1 + more), 0.0).rate().excitement;
    EXPECT_GT(now, last) << more;
    last = now;
  }
  // The same bend, entered by a ramp of curvature or at once.
  const auto bend = [](bool at_once) {
    world::Document d;
    world::append_knot(d, test::skew_knot({0, 5, 0}, {1, 0, 0}, 10, 10));
    world::append_knot(d, test::skew_knot({40, 5, 0}, {1, 0, 0}, 13, at_once ? 8.0f : 25.0f));
    world::append_knot(d, test::skew_knot({58, 5, 18}, {0, 0, 1}, at_once ? 8.0f : 8.0f, 8));
    return Rated(d, 17.3, 0.0).rate();
  };
  const Ratings sharp = bend(true), soft = bend(false);
  EXPECT_GT(sharp.jolt_most.value, soft.jolt_most.value + 0.5);
  EXPECT_LT(sharp.excitement, soft.excitement);
}

TEST(ratings, inversions_are_counted_for_a_loop_and_a_corkscrew_and_not_for_a_bank) {
  EXPECT_EQ(Rated(test::circle_document(7.5, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}), 20.3).rate().inversions, 1);
  world::Document twisted = test::straight_document({1.1f, 9.3f, 2.7f}, {91.1f, 9.3f, 12.7f}, 3);
  EXPECT_EQ(Rated(twisted, 15).rate().inversions, 0);
  twisted.entities.get<world::Segment>(twisted.track.segments[1]).turns = 1;
  EXPECT_EQ(Rated(twisted, 15).rate().inversions, 1);
  twisted.entities.get<world::Segment>(twisted.track.segments[2]).turns = -2;
  EXPECT_EQ(Rated(twisted, 15).rate().inversions, 3);
  world::Document banked = test::straight_document({1.1f, 9.3f, 2.7f}, {91.1f, 9.3f, 12.7f}, 3);
  world::set_roll(banked.entities.get<world::Knot>(banked.track.knots[1]), 85);
  EXPECT_EQ(Rated(banked, 15).rate().inversions, 0);
}

TEST(ratings, drops_are_the_descents_of_the_hills) {
  const double hill = 4.3;
  const Ratings r = Rated(test::ring_document(24, 40.7, hill), 16.3).rate();
  EXPECT_TRUE(r.complete);
  EXPECT_GE(r.drops, 3);  // three hills; a lap that begins on a slope counts both parts of it
  EXPECT_LE(r.drops, 4);
  EXPECT_NEAR(r.highest_drop, 2 * hill, 0.05);
  EXPECT_NEAR(r.highest.value - r.lowest.value, 2 * hill, 0.05);
  // Energy: the top speed is at the lowest place.
  EXPECT_NEAR(r.top_speed.distance, r.lowest.distance, 1.0);
  EXPECT_EQ(Rated(test::ring_document(24, 40.7, 1.2), 16.3).rate().drops, 0);  // 2.4 m are none
}

// Level knots whose spans rise or fall evenly from one to the next: tops and bottoms are the knots' own heights.
world::Document staircase(const std::vector<float>& heights) {
  world::Document d;
  for (std::size_t i = 0; i < heights.size(); ++i)
    world::append_knot(d, test::skew_knot({18.0f * static_cast<float>(i), heights[i], 2.7f}, {1, 0, 0}, 6, 6));
  return d;
}

TEST(ratings, a_rise_of_a_few_centimetres_does_not_end_a_drop_and_a_larger_one_does) {
  for (const auto& [rise, drops, highest] : {std::tuple(0.03f, 1, 12.0), {0.1f, 2, 7.1}, {0.3f, 2, 7.3}}) {
    const Ratings r = Rated(staircase({20, 15, 15 + rise, 8}), 6.3, 0.0).rate();
    EXPECT_TRUE(r.complete);
    EXPECT_EQ(r.drops, drops) << rise;
    EXPECT_NEAR(r.highest_drop, highest, 0.01) << rise;
  }
}

TEST(ratings, a_ride_that_does_not_come_round_is_not_complete) {
  const Ratings r = Rated(test::ring_document(24, 40.7, 9.3), 1.3).rate();
  EXPECT_FALSE(r.complete);
  EXPECT_TRUE(std::isfinite(r.excitement));
}

}  // namespace ratings_test
}  // namespace coaster::sim
