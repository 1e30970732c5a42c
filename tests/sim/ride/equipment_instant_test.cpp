// Equipment switches at the instant: speeds by the energy, whatever the ticks, and the simulated ride as the ride.
#include <gtest/gtest.h>

#include <cmath>

#include "exchange/formats.h"
#include "sim/ride/equipment.h"
#include "sim/ride/live_ride.h"
#include "sim/ride/simulated_ride.h"
#include "sim/tracks.h"
#include "world/equipment_rows.h"

namespace coaster::sim {
namespace equipment_instant_test {

using world::EquipmentKind;

using Ride = test::LiveRide;

// A straight that rises by `rise` m a metre along it: 10 m, `length` m with equipment, 200 m.
world::Document ramp(double rise, double length, const world::Equipment& e, double speed) {
  const double level = std::sqrt(1 - rise * rise);
  world::Document d;
  for (const double at : {0.0, 10.0, 10.0 + length, 210.0 + length})
    world::append_knot(
        d, test::skew_knot(glm::vec3(level * at, 60 + rise * at, 0), glm::vec3(level, rise, 0), 0.6f, 0.6f));
  d.entities.put(d.track.segments.at(1), e);
  world::add_cart(d, d.track.segments.front(), 0);
  d.start_speed = speed;
  return d;
}

// Returns the speed at `place` m from the speeds at two ticks beyond it, where only `pull` m/s^2 acts.
double speed_at(double place, double at, double speed, double pull) {
  return std::sqrt(speed * speed + 2 * pull * (place - at));
}

// Both rides' speeds at the end of the equipment, within 1 m of which nothing else acts.
void expect_exit(const world::Document& document, double expected, double pull, const std::string& what) {
  Ride ride(document);
  const double end = ride.derived.starts.at(2);
  while (ride.runs() && ride.train().track_distance <= end) ride.step(1);
  const world::TrainMotion& cart = ride.train();
  EXPECT_NEAR(speed_at(end, cart.track_distance, cart.speed, pull), expected, 1e-6) << what;
  const SimulatedRide& simulated = ride.simulated();
  const auto passed = passing(simulated, end);
  ASSERT_TRUE(passed) << what;
  EXPECT_NEAR(passed->speed, expected, 1.5e-6) << what << ", simulated";  // the knots are floats
}

TEST(equipment_instant, exits_have_the_speed_of_the_energy_with_slope_and_losses) {
  constexpr double kG = world::kGravity, kRolling = 0.025f;
  for (const double rise : {-0.1, 0.0, 0.15}) {
    for (const bool losses : {false, true}) {
      const double pull = -kG * (rise + (losses ? kRolling : 0.0));
      const auto ride = [&](EquipmentKind kind, float speed, float a, double length, double start, double exit) {
        world::Document d = ramp(rise, length, {kind, speed, a, 0.5f, 0}, start);
        if (losses) d.resistance.rolling = kRolling;
        expect_exit(d, exit, pull,
                    std::string(base::name_of(kind)) + " " + std::to_string(length) + " " + std::to_string(rise));
      };
      for (const double length : {2.0, 3.0}) {
        const double v2 = 25 * 25 + 20 * pull + 2 * (pull - 60) * length;
        ride(EquipmentKind::brake, 8, 60, length, 25, std::sqrt(v2));
        ride(EquipmentKind::block, 8, 60, length, 25, std::sqrt(v2));
      }
      ride(EquipmentKind::launch, 90, 20, 31, 25, std::sqrt(25 * 25 + 20 * pull + 2 * (pull + 20) * 31));
      if (pull > 0) continue;
      ride(EquipmentKind::launch, 27, 20, 40, 25, 27);
      if (pull < 0) ride(EquipmentKind::lift, 8, 3, 40, 8, 8);
      // Brakes until 7.5 m/s, then only gravity and losses act.
      const double braked = (25 * 25 + 20 * pull - 7.5 * 7.5) / (2 * (60 - pull));
      ride(EquipmentKind::brake, 8, 60, 7, 25, std::sqrt(7.5 * 7.5 + 2 * pull * (7 - braked)));
    }
  }
}

TEST(equipment_instant, a_brake_without_hysteresis_holds_its_speed_downhill) {
  for (const float hysteresis : {0.0f, 0.001f}) {
    const world::Document d = ramp(-0.2, 60, {EquipmentKind::brake, 5, 20, hysteresis, 0}, 9);
    Ride ride(d);
    while (ride.train().track_distance < 40) ride.step(1);
    EXPECT_NEAR(ride.train().speed, 5 - hysteresis, 1e-6);
    const double before = ride.train().track_distance;
    ride.step(120);
    EXPECT_NEAR(ride.train().track_distance - before, 5 - hysteresis, 1e-6);
  }
}

// The energy by a thousand Euler steps a tick, for the same brake, with its hysteresis.
TEST(equipment_instant, a_brake_that_comes_on_again_is_that_of_tiny_steps) {
  const world::Document d = ramp(-0.3, 60, {EquipmentKind::brake, 6, 12, 0.4f, 0}, 9);
  Ride ride(d);
  bool on = false;
  double x = 0, v = 9;
  int switches = 0;
  for (int tick = 0; tick < 600; ++tick) {
    constexpr double kStep = world::kTick / 1000;
    for (int i = 0; i < 1000; ++i) {
      const bool under = x >= 10 && x < 70, was = on;
      on = under && (v > 6.4 || (on && v >= 5.6));
      switches += on != was;
      const double a = 0.3 * world::kGravity - (on ? 12 : 0);
      x += v * kStep + 0.5 * a * kStep * kStep, v += a * kStep;
    }
    ride.step(1);
    ASSERT_NEAR(ride.train().track_distance, x, 2e-3) << tick;
    ASSERT_NEAR(ride.train().speed, v, 2e-2) << tick;
  }
  EXPECT_GT(switches, 10);
}

// Uphill it stops, and the slope, stronger than the brake, pulls it back.
TEST(equipment_instant, a_brake_that_is_too_weak_slows_a_train_that_rolls_back) {
  constexpr double kPull = 0.3 * world::kGravity, kBrake = 1, kStart = 8;
  world::Document d = ramp(0.3, 60, {EquipmentKind::brake, 0, kBrake, 0, 0}, kStart);
  d.rollback_fails = false;
  const double enters = kStart * kStart - 2 * kPull * 10, way = enters / (2 * (kPull + kBrake)),
               leaves = std::sqrt(2 * (kPull - kBrake) * way);
  Ride ride(d);
  double top = 0;
  while (ride.runs() && (top < 10 || ride.train().track_distance > 10)) {
    ride.step(1);
    top = std::max(top, ride.train().track_distance);
  }
  const world::TrainMotion& cart = ride.train();
  EXPECT_NEAR(top, 10 + way, 2e-4);
  EXPECT_LT(cart.speed, 0);
  EXPECT_NEAR(speed_at(10, cart.track_distance, cart.speed, -kPull), leaves, 1e-5);
}

// Compares tick by tick, where the first car has just passed an end of equipment.
void expect_as_simulated(world::Document document, int cars, double speed_within, double within,
                         const std::string& what) {
  document.entities.get<world::Train>(world::first_cart(document)).cars = cars;
  Ride ride(std::move(document));
  const auto spans = equipment_spans(ride.document, ride.derived);
  const SimulatedRide simulated = ride.simulated();
  double worst_speed = 0, worst = 0;
  for (std::size_t tick = 1; tick < simulated.samples.size() && ride.runs(); ++tick) {
    const double before = ride.train().track_distance;
    ride.step(1);
    const double after = ride.train().track_distance;
    for (const EquipmentSpan& span : spans) {
      if (!(before < span.to && after >= span.to)) continue;
      worst_speed = std::max(worst_speed, std::abs(ride.train().speed - simulated.samples[tick].speed));
      worst = std::max(worst, std::abs(ride.train().travelled - simulated.samples[tick].travelled));
    }
  }
  EXPECT_LT(worst_speed, speed_within) << what << ", " << cars << " cars";
  EXPECT_LT(worst, within) << what << ", " << cars << " cars";
}

TEST(equipment_instant, the_simulated_ride_passes_every_end_as_the_ride_does) {
  base::Files files;
  for (const char* const name : {"kingfisher", "old_timber"}) {
    auto track = exchange::load_track(files, std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
    ASSERT_TRUE(track.ok()) << name;
    for (const int cars : {1, 8}) expect_as_simulated(track->document, cars, 1e-6, 1e-6, name);
  }
  world::Document ring = test::ring_document(16, 40.3, 2);
  ring.entities.put(ring.track.segments[4], world::Equipment{EquipmentKind::brake, 8, 20, 0.5f, 0});
  ring.entities.put(ring.track.segments[7], world::Equipment{EquipmentKind::launch, 18, 15, 0, 0});
  ring.entities.put(ring.track.segments[12], world::Equipment{EquipmentKind::block, 9, 9, 0.2f, 0});
  world::add_cart(ring, ring.track.segments[2], 0.3);
  ring.start_speed = 16;
  for (const int cars : {1, 8}) expect_as_simulated(ring, cars, 3e-6, 1e-6, "ring");  // the tables
}

TEST(blocks_at_rest, a_train_on_a_free_block_is_driven_on) {
  for (const double fraction : {0.0, 0.2, 0.5, 0.9, 1.0})
    for (const int cars : {1, 4}) {
      world::Document d = ramp(0, 30, {EquipmentKind::block, 4, 3, 0.5f, 0}, 0);
      world::Train& cart = d.entities.get<world::Train>(world::first_cart(d));
      cart.segment = d.track.segments[1], cart.fraction = static_cast<float>(std::min(fraction, 0.999)),
      cart.cars = cars;
      Ride ride(d);
      ride.step(600);
      EXPECT_TRUE(ride.runs());
      EXPECT_GT(ride.train().travelled, fraction < 1 ? 5 : 1) << fraction << ", " << cars;
      EXPECT_EQ(ride.simulated().end, world::FailureKind::off_end);
    }
}

TEST(blocks_at_rest, as_many_trains_as_sections_end_the_ride_and_one_less_does_not) {
  for (const int trains : {2, 3}) {
    world::Document d = test::ring_document(16, 30.7, 0.0);
    for (std::size_t i = 0; i < 16; ++i)
      d.entities.put(d.track.segments[i], world::Equipment{EquipmentKind::lift, 3.7f, 3, 0, 0});
    d.entities.put(d.track.segments[0], world::Equipment{EquipmentKind::station, 4, 3, 0, 2});
    for (const std::size_t i : {5u, 10u})
      d.entities.put(d.track.segments[i], world::Equipment{EquipmentKind::block, 4, 3, 0.5f, 0});
    for (int i = 0; i < trains; ++i) world::add_cart(d, d.track.segments[i == 0 ? 0 : i == 1 ? 5 : 10], 0.9);
    Ride ride(d);
    ride.step(120 * 200);
    EXPECT_EQ(ride.runs(), trains == 2);
    EXPECT_EQ(ride.motion.failure.kind, trains == 2 ? world::FailureKind::none : world::FailureKind::deadlock);
    EXPECT_EQ(deadlock_text(d, ride.derived), trains == 2 ? "" : "3 trains need 4 block sections, the track has 3");
  }
}

}  // namespace equipment_instant_test
}  // namespace coaster::sim
