#include "sim/ride/train.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace train_test {

TEST(train, cars_stand_their_spacing_apart_over_joints_and_the_seam) {
  const world::Document d = test::ring_document(12, 20.3);
  const DerivedTrack derived = test::derived_of(d);
  const double spacing = 3.7;
  std::vector<TrackPlace> places;
  place_cars(derived, {0, 1.3}, 9, spacing, places);
  ASSERT_EQ(places.size(), 9u);
  for (std::size_t i = 0; i < places.size(); ++i) {
    double expected = 1.3 - spacing * static_cast<double>(i);
    if (expected < 0) expected += derived.length;
    EXPECT_NEAR(derived.starts[places[i].index] + places[i].s, expected, 1e-9) << i;
    EXPECT_GE(places[i].s, 0);
    EXPECT_LE(places[i].s, derived.shape(derived.order[places[i].index]).arc.length());
  }
}

TEST(train, behind_goes_forward_by_negative_distances) {
  const DerivedTrack derived = test::derived_of(test::ring_document(7, 11.1));
  const TrackPlace there = behind(derived, {3, 2.2}, -25.5);
  const TrackPlace back = behind(derived, there, 25.5);
  EXPECT_EQ(back.index, 3u);
  EXPECT_NEAR(back.s, 2.2, 1e-9);
}

TEST(train, a_train_longer_than_the_circuit_loses_cars) {
  const DerivedTrack derived = test::derived_of(test::ring_document(7, 3.1, 0.2));
  world::Train design;
  design.cars = 20, design.spacing = 3;
  EXPECT_EQ(cars_on(derived, design), static_cast<int>(derived.length / 3));
  design.cars = 2;
  EXPECT_EQ(cars_on(derived, design), 2);
}

TEST(train, cars_hang_over_an_open_start_along_its_tangent) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.1f, 9.3f, 2.7f}, {31.1f, 6.3f, 2.7f}, 3));
  std::vector<TrackPlace> places;
  place_cars(derived, {0, 1.0}, 3, 4.0, places);
  const TrainContext context{derived, places, 0, 0, {}, 0, 0};
  const double slope = -3.0 / std::hypot(30.0, 3.0);
  EXPECT_NEAR(context.height(0.0), 9.3 + slope * (1.0 - 4.0), 1e-5);  // the mean of 1, -3 and -7 m
  EXPECT_NEAR(context.height(0.7), 9.3 + slope * (1.7 - 4.0), 1e-5);
  EXPECT_NEAR(context.gravity(0.0), -world::kGravity * slope, 1e-6);
}

TEST(train, gravity_is_the_slope_of_the_mean_height) {
  const DerivedTrack derived = test::derived_of(test::ring_document(12, 20.3));
  std::vector<TrackPlace> places;
  place_cars(derived, {5, 2.0}, 8, 3.0, places);
  const TrainContext context{derived, places, 0, 0, {}, 0, 0};
  const double h = 1e-4;
  EXPECT_NEAR(context.gravity(0.0), -world::kGravity * (context.height(h) - context.height(-h)) / (2 * h), 1e-5);
}

TEST(train, joints_ahead_and_behind_are_the_nearest_of_any_car) {
  const DerivedTrack derived = test::derived_of(test::ring_document(12, 20.3));
  std::vector<TrackPlace> places;
  place_cars(derived, {5, 2.0}, 3, 3.0, places);
  const TrainContext context{derived, places, 0, 0, {}, 0, 0};
  double ahead = 1e9, back = -1e9;
  for (const TrackPlace& car : places) {
    const double length = derived.shape(derived.order[car.index]).arc.length();
    ahead = std::min(ahead, length - car.s), back = std::max(back, -car.s);
  }
  EXPECT_EQ(joint_ahead(context), ahead);
  EXPECT_EQ(joint_behind(context), back);
}

}  // namespace train_test
}  // namespace coaster::sim
