#include "sim/ride/lap_table.h"

#include <gtest/gtest.h>

#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace lap_table_test {

struct Lap {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  world::Entity cart;
  TrainStart start;

  explicit Lap(int cars = 1, double speed = 17.3) : document(test::ring_document(12, 40.3, 7.7)) {
    cart = world::add_cart(document, document.track.segments[4], 0.37);
    document.entities.get<world::Train>(cart).cars = cars;
    document.start_speed = speed;
    derive(document, {}, {}, derived);
    start = start_of(document, derived, document.entities.get<world::Train>(cart));
  }
  const LapTable& table() { return cache.lap(document, derived, start); }
};

TEST(lap_table, is_the_simulated_ride_at_whole_ticks) {
  Lap lap;
  const LapTable table = lap.table();
  ASSERT_TRUE(table.valid());
  const SimulatedRide& simulated = lap.cache.from(lap.document, lap.derived, lap.start);
  LapTrain cart = lap_cart(table, 0);
  for (std::size_t tick = 0; static_cast<double>(tick) < table.period(); ++tick) {
    ASSERT_EQ(cart.along, simulated.samples[tick].travelled) << tick;
    ASSERT_EQ(cart.speed, simulated.samples[tick].speed) << tick;
    advance(table, cart);
  }
  EXPECT_EQ(cart.laps, 1);
  EXPECT_NEAR(table.period() * world::kTick, simulated.lap_time, 1e-5);
}

TEST(lap_table, moves_many_carts_with_the_bits_of_one) {
  Lap lap;
  const LapTable table = lap.table();
  std::vector<LapTrain> alone;
  LapTrains together;
  for (int i = 0; i < 331; ++i) {  // no multiple of any width; some just before the end of the lap
    const double phase = i % 10 == 0 ? table.period() - 1e-9 * (i + 1) : std::fmod(i * 7.31, table.period());
    alone.push_back(lap_cart(table, phase));
    together.add(alone.back());
  }
  for (int tick = 0; tick < 3000; ++tick) {
    for (LapTrain& cart : alone) advance(table, cart);
    advance(table, together);
  }
  for (std::size_t i = 0; i < alone.size(); ++i) {
    ASSERT_EQ(together.at(i), alone[i]) << i;
    EXPECT_GE(alone[i].laps, 1);
    EXPECT_TRUE(alone[i].phase >= 0 && alone[i].phase < table.period());
  }
}

TEST(lap_table, finds_the_time_of_a_place) {
  Lap lap;
  const LapTable table = lap.table();
  for (const double part : {0.0, 0.123, 0.5, 0.987})
    EXPECT_NEAR(lap_cart(table, table.phase_at(part * table.length())).along, part * table.length(), 1e-9);
  EXPECT_NEAR(table.phase_at(table.length()), table.period(), 1e-9);
}

TEST(lap_table, is_there_for_laps_that_repeat_alone) {
  Lap slow(1, 1.0), losing, equipped;
  EXPECT_FALSE(slow.table().valid());  // does not come over the hill
  losing.document.resistance = {0.001f, 0};
  EXPECT_TRUE(losing.cache.from(losing.document, losing.derived, losing.start).lap);
  EXPECT_FALSE(losing.table().valid());
  equipped.document.entities.put(equipped.document.track.segments[0], world::Equipment{});
  EXPECT_FALSE(equipped.table().valid());
}

// The row of the ride that runs on it.
struct Rides {
  Lap lap;
  world::Motion motion;
  explicit Rides(int cars) : lap(cars) {
    reset(lap.document, lap.derived, motion);
    motion.state = world::RideState::running;
  }
  void step(int ticks, const char* row) {
    sim::step(lap.document, lap.derived, base::value_named<world::IntegratorId>(row).value(), ticks, lap.cache, motion);
  }
  const world::TrainMotion& cart() const { return motion.carts.items()[0]; }
  // The first time at which it has gone round `laps` times, s, by the ticks around it and the speed.
  double time_of_laps(int laps, const char* row) {
    const double way = laps * lap.derived.length;
    for (int tick = 1; tick < 120 * 600; ++tick) {
      step(1, row);
      if (cart().travelled >= way) return tick * world::kTick - (cart().travelled - way) / cart().speed;
    }
    return 0;
  }
};

TEST(precomputed, takes_as_long_for_a_lap_as_runge_kutta) {
  for (const int cars : {1, 5}) {
    Rides exact(cars), table(cars);
    const double expected = exact.time_of_laps(5, "rk4");
    ASSERT_GT(expected, 10);
    EXPECT_NEAR(table.time_of_laps(5, "precomputed") / expected, 1.0, 1e-5) << cars;
  }
}

TEST(precomputed, stays_within_a_centimetre_of_runge_kutta_for_a_minute) {
  Rides exact(1), table(1);
  double worst = 0;
  for (int tick = 0; tick < 60 * world::kTicksPerSecond; ++tick) {
    exact.step(1, "rk4"), table.step(1, "precomputed");
    worst = std::max(worst, std::abs(exact.cart().travelled - table.cart().travelled));
  }
  EXPECT_GT(table.cart().laps, 2);
  EXPECT_EQ(table.cart().laps, exact.cart().laps);
  EXPECT_LT(worst, 0.010);
}

TEST(precomputed, one_step_of_many_ticks_is_many_steps_of_one_and_simulates_once) {
  Rides one(2), many(2);
  one.step(5000, "precomputed");
  for (int i = 0; i < 5000; ++i) many.step(1, "precomputed");
  EXPECT_GT(one.cart().laps, 2);
  EXPECT_EQ(one.motion, many.motion);
  EXPECT_EQ(one.lap.cache.simulations(), 1u);
  EXPECT_EQ(many.lap.cache.simulations(), 1u);
}

TEST(precomputed, hands_over_to_another_integrator_where_it_is) {
  Rides ride(1);
  ride.step(3333, "precomputed");
  const double before = ride.cart().travelled, speed = ride.cart().speed;
  ride.step(1, "vertices");
  EXPECT_LT(std::abs(ride.cart().travelled - before), 2.0);  // a tick's way and a vertex
  ride.step(1, "rk4");
  EXPECT_FALSE(ride.cart().timetable.valid);
  EXPECT_NEAR(ride.cart().speed, speed, 0.5);
}

// 100 trains along a circuit, all running.
struct Crowd {
  world::Document document = test::ring_document(12, 400.3, 7.7);
  DerivedTrack derived;
  RideCache cache;
  world::Motion motion;

  Crowd() {
    document.start_speed = 30;
    for (int i = 0; i < 100; ++i) world::add_cart(document, document.track.segments[4], 0.37);
    derive(document, {}, {}, derived);
    reset(document, derived, motion);
    for (std::size_t i = 0; i < motion.carts.size(); ++i)
      seek(document, derived, motion.carts.entities()[i], 24.3 * static_cast<double>(i), motion);
    motion.state = world::RideState::running;
  }
  void run(std::string_view integrator, int ticks) {
    step(document, derived, base::value_named<world::IntegratorId>(integrator).value(), ticks, cache, motion);
  }
};

TEST(lap_table, is_shared_by_a_hundred_trains_of_one_energy) {
  Crowd crowd, truth;
  for (int i = 0; i < 60; ++i) crowd.run("precomputed", 20);
  truth.run("rk4", 1200);
  EXPECT_EQ(crowd.cache.simulations(), 1u);
  for (std::size_t i = 0; i < 100; ++i) {
    const world::TrainMotion &is = crowd.motion.carts.items()[i], &should = truth.motion.carts.items()[i];
    ASSERT_NEAR(is.travelled, should.travelled, 1e-3) << i;
    ASSERT_NEAR(is.speed, should.speed, 1e-4) << i;
    ASSERT_EQ(is.laps, should.laps) << i;
  }
}

// Trains are moved in blocks, each for all ticks of a step.
TEST(lap_table, trains_of_a_crowd_have_the_bits_of_one_alone) {
  Crowd crowd;
  crowd.run("precomputed", 1);
  const std::vector<world::TrainMotion> before = crowd.motion.carts.items();
  crowd.run("precomputed", 777);
  for (const std::size_t i : {0u, 1u, 63u, 64u, 99u}) {
    world::Motion alone;
    alone.carts.put(crowd.motion.carts.entities()[i], before[i]);
    alone.state = world::RideState::running;
    for (int k = 0; k < 111; ++k)
      step(crowd.document, crowd.derived, base::value_named<world::IntegratorId>("precomputed").value(), 7, crowd.cache,
           alone);
    EXPECT_EQ(alone.carts.items()[0], crowd.motion.carts.items()[i]) << i;
  }
}

TEST(lap_table, of_more_than_64_energies_is_not_kept_and_trains_move_by_runge_kutta) {
  Crowd crowd, truth;
  for (Crowd* each : {&crowd, &truth})
    for (std::size_t i = 0; i < 100; ++i) each->motion.carts.items()[i].speed += 0.01 * static_cast<double>(i);
  crowd.run("precomputed", 100);
  truth.run("rk4", 100);
  EXPECT_EQ(crowd.cache.simulations(), 0u);
  EXPECT_EQ(crowd.motion, truth.motion);
  EXPECT_EQ(truth.motion.state, world::RideState::running);
}

}  // namespace lap_table_test
}  // namespace coaster::sim
