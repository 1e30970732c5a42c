#include "sim/ride/equipment.h"

#include <random>

#include <gtest/gtest.h>

#include "sim/ride/live_ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace equipment_test {

constexpr double kG = world::kGravity;

using Ride = test::LiveRide;

// 12 level segments of 10 m in a row, or up a slope of `rise` m in all.
world::Document runway(double rise, std::vector<std::pair<std::size_t, world::Equipment>> equipment, int cars = 1,
                       double fraction = 0.5) {
  world::Document d =
      test::straight_document({1.3f, 2.1f, -7.7f}, {121.3f, 2.1f + static_cast<float>(rise), -7.7f}, 12);
  for (const auto& [index, e] : equipment) d.entities.put(d.track.segments.at(index), e);
  const world::Entity cart = world::add_cart(d, d.track.segments.at(1), fraction);
  d.entities.get<world::Train>(cart).cars = cars;
  return d;
}

TEST(equipment, a_launch_gives_v2_equal_2as_and_stops_pushing_at_its_speed) {
  world::Document d = runway(0, {{1, {world::EquipmentKind::launch, 9.0f, 6.0f, 0, 0}},
                                 {2, {world::EquipmentKind::launch, 9.0f, 6.0f, 0, 0}}});
  d.start_speed = 0;
  Ride ride(d);
  ride.step(60);  // v = a t until the end of 15 m or 9 m/s
  EXPECT_NEAR(ride.train().speed, 3.0, 1e-6);
  ride.step(120);
  EXPECT_NEAR(ride.train().speed, 9.0, 1e-6);
  EXPECT_NEAR(ride.train().work, 0.5 * 81, 1e-6);
  EXPECT_LT(ride.drift(), 1e-9);
}

TEST(equipment, a_lift_pulls_a_train_up_at_its_speed_and_does_its_work) {
  world::Document d = runway(60, {});
  for (const world::Entity e : d.track.segments)
    d.entities.put(e, world::Equipment{world::EquipmentKind::lift, 3.0f, 2.0f, 0, 0});
  d.entities.get<world::Train>(d.entities.pool<world::Train>().entities()[0]).cars = 4;
  d.start_speed = 0;
  Ride ride(d);
  ride.step(240);
  EXPECT_NEAR(ride.train().speed, 3.0, 1e-3);
  const double before = ride.train().track_distance;
  ride.step(120);
  EXPECT_NEAR(ride.train().track_distance - before, 3.0, 1e-2);
  EXPECT_EQ(ride.motion.state, world::RideState::running);
  EXPECT_LT(ride.drift(), 1e-6);
}

TEST(equipment, a_lift_lets_nothing_roll_back) {
  world::Document d = runway(60, {});
  for (const world::Entity e : d.track.segments)
    d.entities.put(e, world::Equipment{world::EquipmentKind::lift, 0.0f, 1.0f, 0, 0});
  d.start_speed = 1.5;  // comes to a stop on the chain, which stands still
  Ride ride(d);
  ride.step(200);
  EXPECT_NEAR(ride.train().speed, 0, 1e-2);
  EXPECT_GT(ride.train().travelled, 0.1);
}

TEST(equipment, a_brake_works_from_above_to_below_its_hysteresis) {
  world::Document d = runway(0, {});
  for (const world::Entity e : d.track.segments)
    d.entities.put(e, world::Equipment{world::EquipmentKind::brake, 5.0f, 4.0f, 0.5f, 0});
  d.start_speed = 8;
  Ride ride(d);
  ride.step(60);
  EXPECT_NEAR(ride.train().speed, 6.0, 1e-6);
  ride.step(120);
  EXPECT_NEAR(ride.train().speed, 4.5, 0.05);
  EXPECT_FALSE(ride.train().braking);
  world::Document slow = d;
  slow.start_speed = 5.4;  // within the hysteresis: the brake never comes on
  Ride free(slow);
  free.step(120);
  EXPECT_EQ(free.train().speed, 5.4);
}

TEST(equipment, a_station_stops_at_its_end_waits_and_sends_off) {
  world::Document d = runway(0, {{3, {world::EquipmentKind::station, 2.0f, 2.0f, 0, 1.5f}}}, 2);
  d.start_speed = 6;
  Ride ride(d);
  int stood = 0;
  double place = 0;
  for (int tick = 0; tick < 2400 && ride.motion.state == world::RideState::running && ride.train().track_distance < 60;
       ++tick) {
    ride.step(1);
    if (ride.train().speed != 0) continue;
    ++stood;
    place = ride.train().track_distance;
  }
  EXPECT_NEAR(place, ride.derived.starts[4], 0.05);
  EXPECT_NEAR(stood / 120.0, 1.5, 0.1);
  EXPECT_NEAR(ride.train().speed, 2.0, 0.05);
}

// v^2 = 2 a d: 4 m/s take 8 / 3 m at 3 m/s^2, which the cars behind the first one have, or the first one is given.
TEST(equipment, a_short_train_stops_early_enough_to_leave_at_its_speed) {
  const auto stop_and_speed = [](float speed, int cars) {
    world::Document d = runway(0, {{3, {world::EquipmentKind::station, speed, 3.0f, 0, 0.5f}}}, cars);
    d.start_speed = 4;
    Ride ride(d);
    double place = 0;
    while (ride.train().track_distance - (cars - 1) * 3.0 < ride.derived.starts[4] + 0.5) {
      ride.step(1);
      if (ride.train().speed == 0) place = ride.derived.starts[4] - ride.train().track_distance;
    }
    return std::pair(place, ride.train().speed);
  };
  const auto expect = [&](float speed, int cars, double place, double leaves) {
    const auto [stopped, left] = stop_and_speed(speed, cars);
    EXPECT_NEAR(stopped, place, 0.03) << speed << " m/s, " << cars;
    EXPECT_NEAR(left, leaves, 0.05) << speed << " m/s, " << cars;
  };
  expect(4, 1, 8.0 / 3, 4);
  expect(4, 2, 0, 4);
  expect(6, 2, 3, 6);
  expect(9, 1, 5, std::sqrt(2 * 3 * 5.0));  // never in the first half
}

// Constant deceleration: v^2 = 2 a d at d metres before the stopping place. A tick's way behind at most, since the
// speed at its end answers the place at its start.
TEST(equipment, a_station_brakes_a_train_by_its_own_acceleration) {
  const double a = 2.0;
  world::Document d = runway(0, {{3, {world::EquipmentKind::station, 6.0f, static_cast<float>(a), 0, 1.5f}}}, 4);
  d.start_speed = 6;
  Ride ride(d);
  int seen = 0;
  double last = 6;
  while (ride.train().speed > 0.5) {
    ride.step(1);
    const double left = ride.derived.starts[4] - ride.train().track_distance, v = ride.train().speed;
    if (left < 8.5 && left > 0.5) {
      ++seen;
      EXPECT_NEAR(v * v, 2 * a * left, 2 * a * (v * world::kTick + 0.011)) << left;
      EXPECT_NEAR((last - v) / world::kTick, a, 0.1) << left;
    }
    last = v;
  }
  EXPECT_GT(seen, 200);
}

TEST(equipment, losses_act_against_the_motion_in_both_directions) {
  for (const double start : {7.3, -7.3}) {
    world::Document d = runway(0, {}, 3);
    d.resistance = {0.025f, 2e-3f};
    d.start_speed = start;
    d.entities.get<world::Train>(d.entities.pool<world::Train>().entities()[0]).segment = d.track.segments[6];
    Ride ride(d);
    ride.step(120);
    // v' = -(a + c v^2): v = sqrt(a/c) tan(atan(v0 sqrt(c/a)) - sqrt(a c) t).
    const double a = 0.025f * kG, c = 2e-3f,
                 expected = std::sqrt(a / c) * std::tan(std::atan(7.3 * std::sqrt(c / a)) - std::sqrt(a * c));
    EXPECT_NEAR(std::abs(ride.train().speed), expected, 1e-7);
    EXPECT_EQ(ride.train().speed > 0, start > 0);
    EXPECT_LT(ride.train().work, 0);
    EXPECT_LT(ride.drift(), 1e-9);
  }
}

TEST(equipment, friction_brings_to_rest_and_holds_on_a_gentle_slope_alone) {
  world::Document gentle = runway(1.2, {}), steep = runway(6, {});
  for (world::Document* d : {&gentle, &steep})
    d->resistance = {0.02f, 0}, d->start_speed = 1, d->rollback_fails = false;
  Ride held(gentle), slides(steep);
  held.step(800), slides.step(480);
  EXPECT_EQ(held.train().speed, 0);
  EXPECT_EQ(held.motion.failure.kind, world::FailureKind::stall);
  EXPECT_LT(slides.train().speed, -0.5);
}

TEST(equipment, blocks_keep_trains_apart) {
  world::Document d = test::ring_document(16, 30.7, 0.0);
  for (const std::size_t i : {0u, 4u, 8u, 12u})
    d.entities.put(d.track.segments[i], world::Equipment{world::EquipmentKind::block, 4.0f, 4.0f, 0.5f, 0});
  d.entities.put(d.track.segments[0], world::Equipment{world::EquipmentKind::station, 4.0f, 3.0f, 0, 2});
  d.start_speed = 3;
  for (const std::size_t i : {1u, 6u, 10u})
    d.entities.get<world::Train>(world::add_cart(d, d.track.segments[i], 0.5)).cars = 3;
  for (const std::size_t i : {2u, 3u, 5u, 6u, 7u, 9u, 10u, 11u, 13u, 14u, 15u})
    d.entities.put(d.track.segments[i], world::Equipment{world::EquipmentKind::lift, 3.0f, 3.0f, 0, 0});
  Ride ride(d);
  const TrackExtent rails{ride.derived.length, true};
  std::int64_t laps = 0;
  for (int tick = 0; tick < 120 * 600 && laps < 2; tick += 10) {
    ride.step(10);
    ASSERT_EQ(ride.motion.state, world::RideState::running)
        << tick << " failure " << static_cast<int>(ride.motion.failure.kind);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 3; ++j)
        ASSERT_FALSE(collide(rails, {ride.train(i).track_distance, 3, 3}, {ride.train(j).track_distance, 3, 3}))
            << tick;
    laps = std::min({ride.train(0).laps, ride.train(1).laps, ride.train(2).laps});
  }
  EXPECT_EQ(laps, 2);
}

// From its only station round to itself a circuit is one section: free for a train alone.
TEST(equipment, the_section_of_a_single_station_is_the_whole_circuit) {
  const world::Equipment station{world::EquipmentKind::station, 5, 2, 0, 1};
  const EquipmentSpan span{.from = 20, .to = 40, .equipment = station};
  const TrainPlace here{40, 1, 4, 3};
  for (const double place : {1.0, 19.0, 41.0, 150.0, 199.0}) {
    const TrainPlace other{place, 1, 4, 3};
    EXPECT_FALSE(section_free({&span, 1}, {200, true}, here, {&other, 1})) << place;
    EXPECT_EQ(section_free({&span, 1}, {200, false}, here, {&other, 1}), place < 40) << "open, " << place;
  }
  EXPECT_TRUE(section_free({&span, 1}, {200, true}, here, {}));
}

TEST(equipment, trains_that_meet_end_the_ride) {
  world::Document d = runway(0, {}, 2);
  world::add_cart(d, d.track.segments[8], 0.5);
  d.start_speed = 5;
  Ride ride(d);
  ride.train(1).speed = -5;
  ride.step(2000);
  EXPECT_EQ(ride.motion.state, world::RideState::failed);
  EXPECT_EQ(ride.motion.failure.kind, world::FailureKind::collision);
  EXPECT_LT(std::abs(ride.train(0).track_distance - ride.train(1).track_distance), 4);
}

TEST(equipment, a_train_that_rolls_back_ends_the_ride_unless_it_may) {
  world::Document d = runway(30, {});
  d.start_speed = 9;
  Ride ride(d);
  ride.step(1200);
  EXPECT_EQ(ride.motion.state, world::RideState::failed);
  EXPECT_EQ(ride.motion.failure.kind, world::FailureKind::rollback);
  EXPECT_LT(ride.train().speed, 0);
  d.rollback_fails = false;
  Ride rolls(d);
  rolls.step(1200);
  EXPECT_EQ(rolls.motion.state, world::RideState::ended);  // off the lower end
  EXPECT_EQ(rolls.motion.failure.kind, world::FailureKind::off_end);
}

TEST(train_mass, drag_slows_a_heavy_train_less_by_the_closed_form) {
  // v' = -k v^2 with k = drag 500 / mass: v = v0 / (1 + k v0 t).
  for (const float mass : {250.0f, 500.0f, 2000.0f}) {
    world::Document d = runway(0, {});
    d.resistance.drag = 0.01f;
    d.start_speed = 20;
    d.entities.get<world::Train>(world::first_cart(d)).mass = mass;
    Ride ride(d);
    ride.step(240);
    const double k = 0.01 * 500.0 / static_cast<double>(mass);
    EXPECT_NEAR(ride.train().speed, 20 / (1 + k * 20 * 2), 1e-6) << mass;
    EXPECT_LT(ride.drift(), 1e-9);
    const SimulatedRide& simulated = *ride.cache.ride(ride.document, ride.derived, world::first_cart(ride.document));
    EXPECT_NEAR(simulated.samples.at(240).speed, ride.train().speed, 1e-6) << mass;
  }
}

TEST(train_mass, without_losses_mass_changes_nothing) {
  world::Document light = runway(12, {}), heavy = light;
  for (world::Document* const d : {&light, &heavy}) d->start_speed = 20;
  heavy.entities.get<world::Train>(world::first_cart(heavy)).mass = 5000;
  Ride a(light), b(heavy);
  a.step(300), b.step(300);
  EXPECT_EQ(a.train().track_distance, b.train().track_distance);
  EXPECT_EQ(a.train().speed, b.train().speed);
}

TEST(train_length, trains_collide_where_the_bodies_of_their_cars_touch) {
  const TrackExtent rails{200, true};
  const TrainPlace longer{100, 2, 5, 4.4}, shorter{100 + 3.6, 1, 3, 2.6};  // bodies end at 102.2 and begin at 102.3
  EXPECT_FALSE(collide(rails, longer, shorter));
  EXPECT_TRUE(collide(rails, longer, {100 + 3.4, 1, 3, 2.6}));
  EXPECT_TRUE(collide(rails, {1, 1, 3, 2.2}, {199, 1, 3, 2.2}));  // over the closing joint
  EXPECT_FALSE(collide({200, false}, {1, 1, 3, 2.2}, {199, 1, 3, 2.2}));
  world::Train crowded;
  crowded.spacing = 1.5f;
  EXPECT_EQ(crowded.body(), 1.5f);
}

// Compares with all pairs, on open and closed rails, with trains across the start, beyond the ends, and longer than the
// lap.
TEST(train_length, the_first_collision_is_that_of_all_pairs) {
  std::mt19937 random(29);
  const auto any = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  int hit = 0;
  for (int round = 0; round < 4000; ++round) {
    const TrackExtent rails{any(20, 400), round % 2 == 0};
    std::vector<TrainPlace> trains;
    std::vector<char> left_out;
    const int count = 1 + round % 9;
    for (int i = 0; i < count; ++i) {
      trains.push_back({any(0, rails.length), 1 + static_cast<int>(any(0, 5)), any(1, 12), any(0.5, 4)});
      left_out.push_back(any(0, 1) < 0.2 ? 1 : 0);
    }
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < trains.size() && !first; ++i)
      for (std::size_t j = i + 1; j < trains.size(); ++j)
        if (!left_out[i] && !left_out[j] && collide(rails, trains[i], trains[j])) first = i;
    ASSERT_EQ(first_collision(rails, trains, left_out), first) << round;
    hit += first ? 1 : 0;
  }
  EXPECT_GT(hit, 1000);
  EXPECT_LT(hit, 3500);
}

}  // namespace equipment_test
}  // namespace coaster::sim
