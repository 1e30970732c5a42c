#include "sim/study/riders.h"

#include <gtest/gtest.h>

#include "sim/study/force_limits.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace riders_test {

constexpr double kG = world::kGravity, kCutoff = 5, kEntry = kForceEvery * world::kTick;

struct RiddenTrain {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  world::Entity cart;
  Riders riders;
  RiddenTrain(world::Document d, double speed, int cars = 1) : document(std::move(d)) {
    cart = world::add_cart(document, document.track.segments.at(0), 0.2);
    document.entities.get<world::Train>(cart).cars = cars;
    document.start_speed = speed;
    derive(document, {}, {}, derived);
    update({0, cars - 1});
  }
  void update(CarRange cars, double cutoff = kCutoff) {
    const SimulatedRide& simulated = *cache.ride(document, derived, cart);
    riders.update(simulated, cache.tables(document, derived), derived, cutoff, cars);
  }
};

// Knots `turn` radians of roll apart, rolling evenly.
world::Document rolling(glm::vec3 from, glm::vec3 to, int segments, double turn) {
  world::Document d = test::straight_document(from, to, segments);
  const glm::dvec3 along = glm::normalize(glm::dvec3(to - from));
  const glm::dvec3 up = curve::perpendicular(along, {0, 1, 0});
  for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
    world::Knot& knot = d.entities.get<world::Knot>(d.track.knots[i]);
    knot.up = glm::vec3(curve::rotate(up, along, turn * static_cast<double>(i)));
    world::orthonormalise(knot);
    knot.spin = static_cast<float>(turn * segments / glm::distance(from, to));
  }
  return d;
}

TEST(riders, an_even_roll_on_a_level_straight_has_its_rate_and_no_acceleration) {
  const double k = 2 * M_PI / 40, v = 15;
  for (const double sign : {1.0, -1.0}) {
    RiddenTrain ride(rolling({3.3, 12, 9.7}, {123.3, 12, 9.7}, 24, sign * 5 * k), v);
    const Rider rider = ride.riders.car(0);
    ASSERT_GT(rider.entries(), 400u);
    for (std::size_t i = 0; i + 1 < rider.entries(); ++i) {
      EXPECT_NEAR(rider.value(i, RideValue::roll_rate), sign * glm::degrees(k * v), 2e-3) << i;
      EXPECT_NEAR(rider.value(i, RideValue::roll_acceleration), 0, 0.05) << i;
      EXPECT_NEAR(rider.value(i, RideValue::height), 12, 1e-5) << i;
      EXPECT_NEAR(rider.value(i, RideValue::speed), v, 1e-9) << i;
    }
  }
}

// To the right is +Z on a track along +X.
TEST(riders, a_positive_rate_rolls_to_the_right) {
  RiddenTrain ride(rolling({3.3, 12, 9.7}, {43.3, 12, 9.7}, 1, M_PI / 2), 15);
  const Rider rider = ride.riders.car(0);
  EXPECT_GT(rider.value(20, RideValue::roll_rate), 0);
  const curve::Frame frame = frame_at(ride.derived.shape_at(0), 30);
  EXPECT_GT(frame.up.z, 0.3);
}

TEST(riders, an_even_roll_on_a_slope_accelerates_with_the_train) {
  const double k = 2 * M_PI / 60, v0 = 22, a = -0.6 * kG;
  RiddenTrain ride(rolling({3.3, 12, 9.7}, {35.3, 36, 9.7}, 8, 5 * k), v0);
  const Rider rider = ride.riders.car(0);
  ASSERT_GT(rider.entries(), 60u);
  for (std::size_t i = 0; i + 1 < rider.entries(); ++i) {
    EXPECT_NEAR(rider.value(i, RideValue::roll_rate), glm::degrees(k * (v0 + a * kEntry * static_cast<double>(i))),
                5e-3);
    EXPECT_NEAR(rider.value(i, RideValue::roll_acceleration), glm::degrees(k * a), 0.06);
  }
}

// The angle of roll a s + b s^2 + c s^3 over joints too, on a slope on which the speed changes evenly.
TEST(riders, a_cubic_roll_has_the_rate_and_the_acceleration_of_its_closed_form) {
  const glm::dvec3 from(3.3, 12, 9.7), to(51.3, 48, 9.7);  // 60 m at a slope of 0.6
  const int segments = 4;
  const double a = 0.05, b = -0.004, c = 6e-5, step = glm::distance(from, to) / segments;
  world::Document d = test::straight_document(glm::vec3(from), glm::vec3(to), segments);
  for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
    const double s = step * static_cast<double>(i);
    world::Knot& knot = d.entities.get<world::Knot>(d.track.knots[i]);
    const glm::dvec3 along(knot.tangent), up = curve::perpendicular(along, {0, 1, 0});
    knot.up = glm::vec3(curve::rotate(up, along, s * (a + s * (b + s * c))));
    world::orthonormalise(knot);
    knot.spin = static_cast<float>(a + s * (2 * b + s * 3 * c));
  }
  const double v0 = 27, slowing = -0.6 * kG;
  RiddenTrain ride(d, v0);
  const Rider rider = ride.riders.car(0);
  ASSERT_GT(rider.entries(), 120u);
  double most = 0, least = 0;
  for (std::size_t i = 0; i + 1 < rider.entries(); ++i) {
    const double t = kEntry * static_cast<double>(i), v = v0 + slowing * t, s = 0.2 * step + t * (v0 + v) / 2,
                 spin = a + s * (2 * b + s * 3 * c), acceleration = (2 * b + 6 * c * s) * v * v + spin * slowing;
    EXPECT_NEAR(rider.value(i, RideValue::roll_rate), glm::degrees(spin * v), 5e-3) << i;
    EXPECT_NEAR(rider.value(i, RideValue::roll_acceleration), glm::degrees(acceleration), 0.06) << i;
    most = std::max(most, acceleration), least = std::min(least, acceleration);
  }
  EXPECT_GT(most, 1);
  EXPECT_LT(least, -5);
}

// A level clothoid, curvature c s: at speed v the lateral g grows by v^3 c / g every second (Pendrill and Eager, Phys.
// Educ. 55 (2020) 065012). The filter follows a ramp with a delay and the same slope.
TEST(riders, a_clothoid_at_constant_speed_has_constant_jerk) {
  const double c = 1.0 / 1200, v = 18, step = 2, expected = v * v * v * c / kG;
  world::Document d;
  glm::dvec3 at(3.3, 12, 9.7);
  for (int i = 0; i <= 30; ++i) {
    const double s = step * i, angle = c * s * s / 2, turn = c * step * (s + step / 2);
    const auto handle = static_cast<float>(step * 4 / 3 * std::tan(turn / 4) / turn);
    world::append_knot(d,
                       test::skew_knot(glm::vec3(at), glm::vec3(std::cos(angle), 0, -std::sin(angle)), handle, handle));
    for (int k = 0; k < 200; ++k) {
      const double u = s + step * (k + 0.5) / 200;
      at += step / 200 * glm::dvec3(std::cos(c * u * u / 2), 0, -std::sin(c * u * u / 2));
    }
  }
  RiddenTrain ride(d, v);
  const Rider rider = ride.riders.car(0);
  ASSERT_GT(rider.entries(), 180u);
  for (std::size_t i = 45; i + 2 < rider.entries(); ++i) {  // the filter has settled after 0.75 s
    EXPECT_NEAR(rider.value(i, RideValue::jerk_side), expected, 0.01 * expected) << i;
    EXPECT_NEAR(rider.value(i, RideValue::jerk), expected, 0.01 * expected) << i;
  }
}

// A tilted ring with hills has every kind of force. The quotient is taken here from the envelope's own values.
TEST(riders, jerk_is_the_difference_quotient_of_the_g_that_the_limits_use) {
  RiddenTrain ride(test::ring_document(24, 40.7, 4.3), 16.3, 3);
  for (const int car : {0, 2}) {
    const Rider rider = ride.riders.car(car);
    const std::vector<float> up = pressed(*rider.simulated, car, ForceAxis::down, kCutoff),
                             forward = pressed(*rider.simulated, car, ForceAxis::forward, kCutoff);
    ASSERT_EQ(up.size(), rider.entries());
    double most = 0;
    for (std::size_t i = 1; i + 1 < rider.entries(); ++i) {
      const double rise = (up[i + 1] - up[i - 1]) / (2 * kEntry),
                   push = (forward[i + 1] - forward[i - 1]) / (2 * kEntry);
      EXPECT_NEAR(rider.value(i, RideValue::jerk_up), rise, 1e-4);
      EXPECT_NEAR(rider.value(i, RideValue::jerk_forward), push, 1e-4);
      const double side = rider.value(i, RideValue::jerk_side);
      EXPECT_NEAR(rider.value(i, RideValue::jerk), std::sqrt(rise * rise + push * push + side * side), 2e-4);
      most = std::max(most, rider.value(i, RideValue::jerk));
    }
    EXPECT_GT(most, 0.5);
  }
}

TEST(riders, cars_are_kept_for_the_ride_and_computed_again_for_another_one_or_another_filter) {
  RiddenTrain ride(test::ring_document(24, 40.7, 4.3), 16.3, 3);
  Riders some;
  const SimulatedRide& simulated = *ride.cache.ride(ride.document, ride.derived, ride.cart);
  const RailTables& tables = ride.cache.tables(ride.document, ride.derived);
  some.update(simulated, tables, ride.derived, kCutoff, {1, 1});
  EXPECT_TRUE(some.car(0).samples.empty());
  ASSERT_EQ(some.car(1).samples.size(), some.car(1).entries());
  const RiderSample* const first = some.car(1).samples.data();
  some.update(simulated, tables, ride.derived, kCutoff, {2, 2});
  EXPECT_EQ(some.car(1).samples.data(), first);  // kept
  EXPECT_EQ(some.all().size(), 3u);
  some.update(simulated, tables, ride.derived, 1, {2, 2});
  EXPECT_TRUE(some.car(1).samples.empty());
  ride.update({2, 2});
  double wide = 0, narrow = 0;
  for (std::size_t i = 0; i < some.car(2).entries(); ++i) {
    wide = std::max(wide, ride.riders.car(2).value(i, RideValue::jerk));
    narrow = std::max(narrow, some.car(2).value(i, RideValue::jerk));
  }
  EXPECT_LT(narrow, wide);
  ride.document.start_speed = 17;
  const SimulatedRide& faster = *ride.cache.ride(ride.document, ride.derived, ride.cart);
  some.update(faster, tables, ride.derived, 1, {0, 0});
  EXPECT_TRUE(some.car(2).samples.empty());
}

// Rails continue straight beyond an open end.
TEST(riders, cars_before_the_start_of_an_open_track_do_not_roll) {
  RiddenTrain ride(rolling({3.3, 12, 9.7}, {53.3, 12, 9.7}, 1, 2.5), 20, 8);  // the last car is 11 m before the start
  const Rider back = ride.riders.car(7);
  ASSERT_LT(back.place(0), -10);
  EXPECT_EQ(back.value(0, RideValue::roll_rate), 0);
  EXPECT_GT(std::abs(back.value(60, RideValue::roll_rate)), 10);
}

}  // namespace riders_test
}  // namespace coaster::sim
