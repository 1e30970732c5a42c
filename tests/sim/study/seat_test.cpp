// Curves and values of a seat along a ride.
#include "sim/study/riders.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/tracks.h"
#include "world/laboratory.h"

namespace coaster::sim {
namespace seat_test {

constexpr double kG = world::kGravity;

struct RiddenTrain {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  Riders riders;
  const SimulatedRide* simulated = nullptr;
  RiddenTrain(world::Document d, double speed, int cars, double spacing = 3) : document(std::move(d)) {
    const world::Entity cart = world::add_cart(document, document.track.segments.at(0), 0.3);
    document.entities.get<world::Train>(cart).cars = cars;
    document.entities.get<world::Train>(cart).spacing = static_cast<float>(spacing);
    document.start_speed = speed, document.rollback_fails = false;
    derive(document, {}, {}, derived);
    simulated = cache.ride(document, derived, cart);
    riders.update(*simulated, cache.tables(document, derived), derived, 5, {0, cars - 1});
  }
};

// A train that always rides in a vertical circle. With n cars, an angle q apart, the mean height is R - R S cos(m), m
// the middle's angle from the bottom and S = sin(n q/2) / (n sin(q/2)), so that every car's g has a closed form
// (Pendrill, Eur. J. Phys. 34 (2013) 1379; docs/ride.md).
struct Loop {
  static constexpr int kCars = 7;
  double radius = 10, spacing = 3, v0 = 24;
  RiddenTrain ride{test::circle_document(radius, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}), v0, kCars, spacing};
  double q = spacing / radius, share = std::sin(kCars * q / 2) / (kCars * std::sin(q / 2));
  double first = ride.simulated->start.front / radius - 3 * q;  // the middle's angle at the start

  // Vertical g of a car at an angle from the bottom.
  double up(int car, double angle) const {
    const double middle = angle + (car - 3) * q;
    const double v2 = v0 * v0 + 2 * kG * radius * share * (std::cos(middle) - std::cos(first));
    return v2 * (radius - ride.document.heartline) / (radius * radius) / kG + std::cos(angle);
  }
  double speed(int car, double angle) const {
    return std::sqrt(v0 * v0 + 2 * kG * radius * share * (std::cos(angle + (car - 3) * q) - std::cos(first)));
  }
};
constexpr double kNear = 2.5e-3;  // g: the tables are linear over 0.25 m
constexpr auto kUp = static_cast<std::size_t>(RideValue::vertical), kSpeed = static_cast<std::size_t>(RideValue::speed);

TEST(seat, each_car_has_its_own_g_in_a_loop) {
  const Loop loop;
  double apart = 0;
  for (const auto& [seat, car] : {std::pair(world::Seat::front, 0), std::pair(world::Seat::middle, 3),
                                  std::pair(world::Seat::back, 6), std::pair(world::Seat::car, 4)}) {
    const CarRange cars = cars_of(seat, 5, Loop::kCars);
    ASSERT_EQ(cars.first, car);
    ASSERT_EQ(cars.last, car);
    const SeatCurves curves = curves_by_place(loop.ride.riders.cars(cars));
    ASSERT_GT(curves.place.size(), 100u);
    EXPECT_TRUE(curves.most[kUp].empty());
    for (std::size_t i = 0; i < curves.place.size(); ++i) {
      const double angle = curves.place[i] / loop.radius;
      EXPECT_NEAR(curves.least[kUp][i], loop.up(car, angle), kNear) << car << " at " << angle;
      EXPECT_NEAR(curves.least[kSpeed][i], loop.speed(car, angle), 1e-3) << car << " at " << angle;
      apart = std::max(apart, std::abs(loop.up(car, angle) - loop.up(3, angle)));
    }
  }
  EXPECT_GT(apart, 0.5);  // so that a wrong car would be seen
}

TEST(seat, the_band_holds_every_car_at_every_place_of_a_closed_track) {
  const Loop loop;
  const SeatCurves band = curves_by_place(loop.ride.riders.all());
  const double lap = loop.ride.derived.length;
  ASSERT_NEAR(band.place.back() - band.place.front(), lap, 0.5);
  EXPECT_NEAR(band.place.front(), loop.ride.simulated->start.front - 3 * loop.spacing, 1e-9);  // of the middle car
  for (std::size_t i = 0; i < band.place.size(); ++i) {
    const double angle = band.place[i] / loop.radius;
    double least = 1e9, most = -1e9;
    for (int car = 0; car < Loop::kCars; ++car)
      least = std::min(least, loop.up(car, angle)), most = std::max(most, loop.up(car, angle));
    EXPECT_NEAR(band.least[kUp][i], least, kNear) << angle;
    EXPECT_NEAR(band.most[kUp][i], most, kNear) << angle;
  }
}

TEST(seat, by_time_the_band_holds_every_car_at_every_moment) {
  const Loop loop;
  const SeatCurves band = curves_by_time(loop.ride.riders.all());
  const SimulatedRide& simulated = *loop.ride.simulated;
  ASSERT_EQ(band.time.size() * Loop::kCars, simulated.forces.size());
  for (std::size_t k = 0; k < band.time.size(); ++k) {
    EXPECT_NEAR(band.time[k], static_cast<double>(k) / 60, 1e-12);
    const auto begin = simulated.forces.begin() + static_cast<std::ptrdiff_t>(k * Loop::kCars);
    const auto [least, most] =
        std::minmax_element(begin, begin + Loop::kCars,
                            [](const FeltAcceleration& a, const FeltAcceleration& b) { return a.left < b.left; });
    const auto side = static_cast<std::size_t>(RideValue::lateral);
    EXPECT_EQ(band.least[side][k], static_cast<double>(least->left));
    EXPECT_EQ(band.most[side][k], static_cast<double>(most->left));
  }
}

TEST(seat, a_value_at_a_distance_is_that_of_the_car_there) {
  const Loop loop;
  for (const int car : {0, 3, 6})
    for (const double distance : {0.7, 13.9, 31.4, 47.2, 62.1}) {
      const auto value = value_at(loop.ride.riders.car(car), distance, RideValue::vertical);
      ASSERT_TRUE(value) << car << " at " << distance;
      EXPECT_NEAR(*value, loop.up(car, distance / loop.radius), kNear) << car << " at " << distance;
    }
  EXPECT_FALSE(value_at(loop.ride.riders.car(0), NAN, RideValue::vertical));
}

// Up a slope, down again backwards, and off the start.
TEST(seat, places_ascend_though_the_train_rolls_back_and_an_open_track_ends) {
  RiddenTrain ride(test::straight_document({3.1f, 2.7f, -1.9f}, {83.1f, 42.7f, -1.9f}, 4), 12.0, 3);
  const SeatCurves band = curves_by_place(ride.riders.all());
  EXPECT_TRUE(std::is_sorted(band.place.begin(), band.place.end()));
  EXPECT_LT(band.place.size(), ride.riders.car(0).entries());
  EXPECT_LT(band.place.back(), 40);
  EXPECT_FALSE(value_at(ride.riders.car(0), 60, RideValue::speed));
  // The front car passes a place faster than those behind it: the train is still lower then.
  const auto front = value_at(ride.riders.car(0), band.place[20], RideValue::speed);
  ASSERT_TRUE(front);
  EXPECT_NEAR(band.most[kSpeed][20], *front, 1e-4);
  EXPECT_GT(band.most[kSpeed][20], band.least[kSpeed][20] + 0.5);
}

TEST(seat, a_ride_backwards_has_its_places) {
  RiddenTrain ride(test::circle_document(10, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}), -24, 2);
  const SeatCurves curves = curves_by_place(ride.riders.cars({0, 0}));
  ASSERT_GT(curves.place.size(), 100u);
  EXPECT_TRUE(std::is_sorted(curves.place.begin(), curves.place.end()));
  EXPECT_LT(curves.place.front(), -50);
  EXPECT_LT(*std::max_element(curves.least[kSpeed].begin(), curves.least[kSpeed].end()), -5);
}

TEST(seat, the_largest_value_has_its_sign_its_car_and_its_place) {
  const Loop loop;
  const Extreme most = most_of(loop.ride.riders.all(), RideValue::vertical);
  double largest = 0;
  for (int car = 0; car < Loop::kCars; ++car)
    for (double angle = 0; angle < 2 * M_PI; angle += 1e-3) largest = std::max(largest, loop.up(car, angle));
  EXPECT_NEAR(most.value, largest, 0.01);
  EXPECT_NEAR(most.value, loop.up(most.car, most.distance / loop.radius), kNear);
  const Extreme one = most_of(loop.ride.riders.cars({6, 6}), RideValue::longitudinal);
  EXPECT_EQ(one.car, 6);
  EXPECT_EQ(most_of({}, RideValue::jerk).value, 0);
}

TEST(seat, seats_name_cars_of_any_train) {
  const auto expect = [](world::Seat seat, int own, int cars, int first, int last) {
    const CarRange range = cars_of(seat, own, cars);
    EXPECT_EQ(range.first, first) << base::name_of(seat) << " of " << cars;
    EXPECT_EQ(range.last, last) << base::name_of(seat) << " of " << cars;
  };
  for (const world::Seat seat : {world::Seat::front, world::Seat::middle, world::Seat::back, world::Seat::all})
    expect(seat, 9, 1, 0, 0);
  expect(world::Seat::middle, 1, 4, 2, 2);
  expect(world::Seat::back, 1, 4, 3, 3);
  expect(world::Seat::all, 1, 4, 0, 3);
  expect(world::Seat::car, 2, 4, 1, 1);
  expect(world::Seat::car, 9, 4, 3, 3);
  EXPECT_EQ((CarRange{0, 4}).middle(), 2);
  EXPECT_EQ((CarRange{3, 3}).middle(), 3);
}

}  // namespace seat_test
}  // namespace coaster::sim
