#include "sim/ride/ride.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace ride_test {

constexpr double kG = 9.81;

struct Ride {
  world::Document document;
  DerivedTrack derived;
  world::Motion motion;
  RideCache cache;

  explicit Ride(world::Document d, double speed) : document(std::move(d)) {
    document.start_speed = speed;
    document.rollback_fails = false;
    derive(document, {}, {}, derived);
    reset(document, derived, motion);
  }
  void start() { motion.state = world::RideState::running; }
  void step(int ticks, const char* row = "rk4") {
    sim::step(document, derived, base::value_named<world::IntegratorId>(row).value(), ticks, cache, motion);
  }
  world::TrainMotion& cart(std::size_t i = 0) { return motion.carts.items().at(i); }
  // v^2/2 + g y of a cart, from the segment's control points by de Casteljau at the parameter that bisection finds for
  // s.
  double energy_by_hand(const world::TrainMotion& at) const {
    const curve::Cubic c = world::cubic_of(document, at.segment);
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (curve::arc_length(c, 0, middle) < at.s ? low : high) = middle;
    }
    return 0.5 * at.speed * at.speed + kG * curve::point_long_double(c, low).y;
  }
};

world::Document with_cart(world::Document d, std::size_t segment, double fraction) {
  world::add_cart(d, d.track.segments.at(segment), fraction);
  return d;
}

TEST(ride, its_reference_is_the_energy_and_the_kinetic_energy_of_the_start) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  EXPECT_NEAR(ride.cart().peak_kinetic, 0.5 * 14.3 * 14.3, 1e-5);
  EXPECT_NEAR(ride.cart().reference_energy, ride.energy_by_hand(ride.cart()), 1e-4);
  EXPECT_EQ(ride.cart().work, 0);
}

TEST(ride, ten_laps_of_a_closed_track_keep_the_energy) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  const double before = ride.energy_by_hand(ride.cart());
  ride.start();
  double peak = 0, worst = 0, least = 1e9;
  for (int tick = 0; tick < 120 * 300 && ride.cart().laps < 10; ++tick) {
    ride.step(1);
    const double kinetic = 0.5 * ride.cart().speed * ride.cart().speed;
    peak = std::max(peak, kinetic), least = std::min(least, kinetic);
    if (tick % 13 == 0) worst = std::max(worst, std::abs(ride.energy_by_hand(ride.cart()) - before));
  }
  EXPECT_EQ(ride.cart().laps, 10);
  EXPECT_GT(peak, 1.5 * least);  // there are hills
  EXPECT_LT(worst / peak, 1e-6);
  EXPECT_LT(energy_drift(ride.document, ride.derived, ride.motion.carts.entities()[0], ride.cart()), 1e-6);
  EXPECT_NEAR(ride.cart().travelled, 10 * ride.derived.length, ride.derived.length);
  EXPECT_NEAR(energy(ride.document, ride.derived, ride.motion.carts.entities()[0], ride.cart()), before, 1e-6 * peak);
}

TEST(ride, the_drift_is_the_energy_that_is_missing_by_the_largest_of_motion) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  ride.start();
  double peak = 0;
  for (int tick = 0; tick < 600; ++tick) {
    peak = std::max(peak, 0.5 * ride.cart().speed * ride.cart().speed);
    ride.step(1);
  }
  world::TrainMotion faster = ride.cart();
  peak = std::max(peak, 0.5 * faster.speed * faster.speed);
  const double added = 0.105 * faster.speed * faster.speed;  // (1.1^2 - 1) / 2
  faster.speed *= 1.1;
  EXPECT_NEAR(energy_drift(ride.document, ride.derived, ride.motion.carts.entities()[0], faster), added / peak, 1e-5);
}

// Handles that differ on the two sides of a joint: the tangent is common, the curvature jumps by up to a factor of
// three.
TEST(ride, ten_laps_of_a_kinked_vertical_loop_keep_the_energy) {
  for (const int count : {4, 7, 12}) {
    world::Document d = test::circle_document(7.0, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}, count);
    for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
      world::Knot& knot = d.entities.get<world::Knot>(d.track.knots[i]);
      knot.joint = world::JointKind::aligned;
      knot.in_length *= i % 2 ? 1.3f : 0.7f;
      knot.out_length *= i % 3 ? 0.6f : 1.2f;
    }
    Ride ride(with_cart(d, 0, 0.1), 20);
    const double before = ride.energy_by_hand(ride.cart());
    ride.start();
    double worst = 0;
    for (int tick = 0; tick < 120 * 120 && ride.cart().laps < 10; ++tick) {
      ride.step(1);
      if (tick % 17 == 0) worst = std::max(worst, std::abs(ride.energy_by_hand(ride.cart()) - before));
    }
    EXPECT_EQ(ride.cart().laps, 10);
    EXPECT_LT(worst / ride.cart().peak_kinetic, 1e-6) << count;
  }
}

TEST(ride, every_integrator_but_the_papers_keeps_energy_in_both_directions) {
  for (const char* row : {"rk4", "verlet"})
    for (const double speed : {13.1, -13.1}) {
      Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), speed);
      ride.start();
      ride.step(120 * 60, row);
      EXPECT_EQ(ride.cart().laps > 0, speed > 0);
      EXPECT_EQ(ride.cart().laps < 0, speed < 0);
      EXPECT_LT(energy_drift(ride.document, ride.derived, ride.motion.carts.entities()[0], ride.cart()), 1e-3) << row;
    }
}

TEST(ride, a_valley_has_the_pendulums_period) {
  // A cart in a circular valley is a pendulum: T = 2 pi sqrt(R/g) / AGM(1, cos(amplitude/2)).
  const double radius = 7.5, amplitude = 2 * M_PI * 10.3 / 64;
  double a = 1, b = std::cos(amplitude / 2);
  for (int i = 0; i < 8; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b), a = mean;
  }
  const double period = 2 * M_PI * std::sqrt(radius / kG) / a;
  for (const char* row : {"rk4", "verlet"}) {
    Ride ride(with_cart(test::circle_document(radius, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}), 10, 0.3), 0);
    ride.start();
    std::vector<double> turning;  // times, s, when the speed changes its sign
    for (int tick = 0; turning.size() < 9 && tick < 120 * 60; ++tick) {
      const double before = ride.cart().speed;
      ride.step(1, row);
      const double after = ride.cart().speed;
      if (before != 0 && before * after <= 0) turning.push_back((tick + before / (before - after)) / 120.0);
    }
    ASSERT_EQ(turning.size(), 9u);
    const double measured = (turning.back() - turning.front()) / 4;
    // Verlet's phase error is (w dt)^2/24 with w = 1.1 /s: 4e-6.
    EXPECT_NEAR(measured / period, 1.0, 2e-5) << row;
  }
}

TEST(ride, a_cart_at_rest_on_a_slope_starts_except_by_the_papers_method) {
  const double slope = 3.0 / std::hypot(30.0, 3.0);
  for (const char* row : {"rk4", "verlet", "energy"}) {
    Ride ride(with_cart(test::straight_document({1.1f, 9.3f, 2.7f}, {31.1f, 6.3f, 2.7f}, 3), 0, 0.25), 0);
    ride.start();
    const double from = ride.cart().track_distance;
    ride.step(180, row);
    const double expected = std::string_view(row) == "energy" ? 0.0 : 0.5 * kG * slope * 1.5 * 1.5;
    EXPECT_NEAR(ride.cart().track_distance - from, expected, 1e-5) << row;
  }
}

TEST(ride, joints_are_crossed_backwards) {
  // Up a slope, to a stop, and back over two joints: s = s0 + v t - a t^2/2.
  Ride ride(with_cart(test::straight_document({1.1f, 2.3f, 2.7f}, {31.1f, 14.3f, 7.7f}, 6), 3, 0.4), 5.3);
  const double slope = 12.0 / std::sqrt(30.0 * 30 + 12.0 * 12 + 5.0 * 5), a = kG * slope;
  const double from = ride.cart().track_distance;
  ride.start();
  for (int tick = 1; tick <= 500; ++tick) {
    ride.step(1);
    const double t = tick / 120.0, expected = from + 5.3 * t - 0.5 * a * t * t;
    if (expected < 0.5) break;
    ASSERT_NEAR(ride.cart().track_distance, expected, 1e-4) << tick;
    ASSERT_NEAR(ride.cart().speed, 5.3 - a * t, 1e-4) << tick;
    ASSERT_NEAR(ride.cart().travelled, expected - from, 1e-4);
  }
  EXPECT_LT(ride.cart().track_distance, ride.derived.starts[2]);
  EXPECT_LT(ride.cart().speed, 0);
}

TEST(ride, carts_stop_at_open_ends_and_the_ride_is_ended) {
  for (const double speed : {7.3, -7.3}) {
    Ride ride(with_cart(test::straight_document({1.1f, 2.3f, 2.7f}, {31.1f, 2.3f, 7.7f}, 3), 1, 0.4), speed);
    ride.step(10);
    EXPECT_EQ(ride.cart().track_distance, ride.derived.starts[1] + ride.cart().s);  // stopped: nothing moves
    EXPECT_EQ(ride.cart().travelled, 0);
    ride.start();
    ride.step(120 * 10);
    EXPECT_EQ(ride.motion.state, world::RideState::ended);
    EXPECT_EQ(ride.cart().speed, 0);
    EXPECT_NEAR(ride.cart().track_distance, speed > 0 ? ride.derived.length : 0.0, 1e-9);
    EXPECT_EQ(ride.cart().laps, 0);
    const world::Motion ended = ride.motion;
    ride.step(100);
    EXPECT_EQ(ride.motion, ended);
  }
}

TEST(ride, the_ride_goes_on_until_the_last_cart_stands_at_an_end) {
  world::Document d = with_cart(test::straight_document({1.1f, 2.3f, 2.7f}, {31.1f, 2.3f, 7.7f}, 3), 0, 0.1);
  world::add_cart(d, d.track.segments[2], 0.8);
  Ride ride(d, 7.3);
  ride.start();
  ride.step(120);
  EXPECT_EQ(ride.motion.state, world::RideState::running);
  EXPECT_EQ(ride.cart(1).speed, 0);
  EXPECT_GT(ride.cart(0).speed, 0);
  ride.step(120 * 10);
  EXPECT_EQ(ride.motion.state, world::RideState::ended);
}

TEST(ride, a_tick_may_cross_many_joints) {
  Ride ride(with_cart(test::straight_document({1.1f, 2.3f, 2.7f}, {11.1f, 2.3f, 2.7f}, 200), 3, 0.5), 100);
  const double from = ride.cart().track_distance;
  ride.start();
  ride.step(1);  // 0.83 m over segments of 0.05 m
  EXPECT_NEAR(ride.cart().track_distance, from + 100 / 120.0, 1e-5);
}

TEST(ride, one_step_of_many_ticks_is_many_steps_of_one) {
  Ride a(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3), b = a;
  a.start(), b.start();
  a.step(1000);
  for (int i = 0; i < 1000; ++i) b.step(1);
  EXPECT_EQ(a.motion, b.motion);
}

TEST(ride, seeking_keeps_the_energy) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), -14.3);
  const double before = ride.energy_by_hand(ride.cart());
  seek(ride.document, ride.derived, ride.motion.carts.entities()[0], 11.7, ride.motion);
  EXPECT_NEAR(ride.cart().track_distance, 11.7, 1e-9);
  EXPECT_NEAR(ride.energy_by_hand(ride.cart()), before, 1e-6);
  EXPECT_LT(ride.cart().speed, 0);
}

TEST(ride, seeking_beyond_reach_stands_still) {
  Ride ride(with_cart(test::straight_document({1.1f, 2.3f, 2.7f}, {1.2f, 32.3f, 2.7f}), 0, 0.1), 3);
  seek(ride.document, ride.derived, ride.motion.carts.entities()[0], 25, ride.motion);
  EXPECT_EQ(ride.cart().speed, 0);
}

TEST(ride_reconcile, carts_come_and_go_with_the_document) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  ride.start();
  ride.step(77);
  const world::TrainMotion kept = ride.cart();
  const world::Entity first = ride.motion.carts.entities()[0];
  const world::Entity second = world::add_cart(ride.document, ride.document.track.segments[7], 0.6);
  reconcile(ride.document, ride.derived, ride.motion);
  ASSERT_EQ(ride.motion.carts.size(), 2u);
  EXPECT_EQ(ride.motion.carts.get(first), kept);
  EXPECT_EQ(ride.motion.carts.get(second).speed, 14.3);
  EXPECT_EQ(ride.motion.carts.get(second).segment, ride.document.track.segments[7]);
  ride.document.entities.destroy(first);
  reconcile(ride.document, ride.derived, ride.motion);
  EXPECT_EQ(ride.motion.carts.size(), 1u);
  EXPECT_FALSE(ride.motion.carts.contains(first));
}

TEST(ride_reconcile, a_moving_cart_keeps_segment_fraction_and_speed_under_an_edit) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  ride.start();
  ride.step(3);
  const world::TrainMotion before = ride.cart();
  const double fraction = before.s / before.segment_length;
  const std::size_t at = *world::index_of(ride.document.track.segments, before.segment);
  ride.document.entities.get<world::Knot>(ride.document.track.knots[at]).position += glm::vec3(0.3f, 4.1f, -0.7f);
  derive(ride.document, {}, {}, ride.derived);
  reconcile(ride.document, ride.derived, ride.motion);
  const world::TrainMotion& after = ride.cart();
  EXPECT_EQ(after.segment, before.segment);
  EXPECT_EQ(after.speed, before.speed);
  EXPECT_EQ(after.travelled, before.travelled);
  EXPECT_NE(after.segment_length, before.segment_length);
  EXPECT_NEAR(after.s / after.segment_length, fraction, 1e-12);
  EXPECT_NEAR(after.reference_energy, ride.energy_by_hand(after), 1e-6);
  EXPECT_LT(energy_drift(ride.document, ride.derived, ride.motion.carts.entities()[0], after), 1e-9);
}

TEST(ride_reconcile, an_edit_elsewhere_changes_nothing_but_the_distance) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  ride.start();
  ride.step(3);
  world::TrainMotion before = ride.cart();
  ride.document.entities.get<world::Knot>(ride.document.track.knots[9]).position.y += 3.1f;
  derive(ride.document, {}, {}, ride.derived);
  reconcile(ride.document, ride.derived, ride.motion);
  EXPECT_EQ(ride.cart(), before);
  ride.document.entities.get<world::Knot>(ride.document.track.knots[1]).position.y += 3.1f;
  derive(ride.document, {}, {}, ride.derived);
  reconcile(ride.document, ride.derived, ride.motion);
  EXPECT_NE(ride.cart().track_distance, before.track_distance);
  before.track_distance = ride.cart().track_distance;
  EXPECT_EQ(ride.cart(), before);
}

TEST(ride_reconcile, a_cart_whose_segment_vanished_goes_to_the_same_distance) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 5, 0.37), 14.3);
  ride.start();
  ride.step(3);
  const double distance = ride.cart().track_distance, speed = ride.cart().speed;
  const world::Entity segment = ride.cart().segment;
  world::remove_knot(ride.document, ride.document.track.knots[5]);
  derive(ride.document, {}, {}, ride.derived);
  reconcile(ride.document, ride.derived, ride.motion);
  EXPECT_NE(ride.cart().segment, segment);
  EXPECT_NEAR(ride.cart().track_distance, distance, 1e-9);
  EXPECT_EQ(ride.cart().speed, speed);
}

TEST(ride_reconcile, a_ride_that_has_not_begun_follows_the_design) {
  Ride ride(with_cart(test::ring_document(12, 20.3), 4, 0.37), 14.3);
  ride.document.start_speed = 3.1;
  reconcile(ride.document, ride.derived, ride.motion);
  EXPECT_EQ(ride.cart().speed, 3.1);
}

}  // namespace ride_test
}  // namespace coaster::sim
