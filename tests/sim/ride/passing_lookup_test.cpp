#include "sim/ride/simulated_ride.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/tracks.h"

namespace coaster::sim {
namespace passing_lookup_test {

using world::EquipmentKind;

struct RiddenTrain {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  const SimulatedRide* simulated = nullptr;

  RiddenTrain(world::Document d, double speed, int cars, double fraction = 0) : document(std::move(d)) {
    const world::Entity train = world::add_cart(document, document.track.segments.front(), fraction);
    document.entities.get<world::Train>(train).cars = cars;
    document.start_speed = speed;
    derive(document, {}, {}, derived);
    simulated = cache.ride(document, derived, train);
  }
  double height(double distance) const {
    const TrackPlace at = place_at(derived, distance);
    const SegmentShape& shape = derived.shape_at(at.index);
    return curve::point(shape.key.cubic, shape.arc.parameter(at.s)).y;
  }
};

// A level straight of three segments of 60 m, the second with equipment.
world::Document straight(const world::Equipment& e) {
  world::Document d = test::straight_document({0, 5, 0}, {180, 5, 0}, 3);
  d.entities.put(d.track.segments.at(1), e);
  return d;
}

// The share of the cars on a brake grows by one car each spacing: its work on the train is the sum of these steps.
TEST(passing, a_brake_takes_from_each_train_what_its_cars_on_it_do) {
  for (const int cars : {1, 2, 5, 8}) {
    const RiddenTrain ride(straight({EquipmentKind::brake, 2, 4.3f, 0.2f, 0}), 27, cars, 0.6);
    const double a = 4.3f, d = ride.simulated->start.spacing, in = ride.derived.starts[1], out = ride.derived.starts[2];
    const PassingLookup passings(*ride.simulated);
    ASSERT_TRUE(passings.at(in) && passings.at(out));
    EXPECT_NEAR(passings.at(in)->speed, 27, 1e-6);
    const auto square = [&](double way) {  // that the first car is on the brake
      double v2 = 27 * 27;
      for (int car = 0; car < cars; ++car) v2 -= 2 * a / cars * std::max(0.0, way - car * d);
      return v2;
    };
    for (const double way : {0.3, 2.9, 3.1, 11.0, 33.3, 60.0})
      EXPECT_NEAR(passings.at(in + way)->speed, std::sqrt(square(way)), 1e-6) << cars << " cars, " << way;
    const double last = (cars - 1) * d;
    EXPECT_NEAR(passings.at(in + 7.7, last)->speed, std::sqrt(square(7.7 + last)), 1e-6) << "the last of " << cars;
    EXPECT_NEAR(passings.at(in + 7.7, last)->along, last + 7.7 < 60 ? -a : -a * (cars - 1) / cars, 0.9);
  }
}

TEST(passing, speeds_on_a_tilted_ring_are_those_of_the_energy) {
  const RiddenTrain ride(test::ring_document(24, 40, 6), 19, 1, 0.7);
  ASSERT_TRUE(ride.simulated->lap);
  const double start = ride.height(ride.simulated->start.front);
  const PassingLookup passings(*ride.simulated);
  for (int i = 0; i <= 400; ++i) {
    const double at = ride.derived.length * i / 400;
    ASSERT_TRUE(passings.at(at)) << at;
    const double height = ride.height(std::min(at, ride.derived.length * (1 - 1e-12)));
    EXPECT_NEAR(passings.at(at)->speed, std::sqrt(19 * 19 + 2 * world::kGravity * (start - height)), 2e-6) << at;
  }
}

TEST(passing, a_ride_that_rolls_back_has_its_first_passes_and_one_backwards_its_own) {
  world::Document slope = test::straight_document({0, 0, 0}, {60, 30, 0}, 3);
  slope.rollback_fails = false;
  const RiddenTrain up(slope, 12, 1, 0.5);
  const double top = 12 * 12 / (2 * world::kGravity * std::sin(std::atan2(30, 60))), from = up.simulated->start.front;
  ASSERT_TRUE(passing(*up.simulated, from + 0.9 * top));
  EXPECT_NEAR(passing(*up.simulated, from + 0.9 * top)->speed, 12 * std::sqrt(0.1), 1e-6);
  EXPECT_FALSE(passing(*up.simulated, from + 1.1 * top));
  EXPECT_FALSE(passing(*up.simulated, from - 0.1)) << "a first pass is forwards";
  const RiddenTrain down(slope, 0.5, 1, 0.5);
  const auto back = passing(*down.simulated, down.simulated->start.front - 4);
  ASSERT_TRUE(back);
  const double pull = world::kGravity * std::sin(std::atan2(30, 60));
  EXPECT_NEAR(back->speed, -std::sqrt(0.25 + 2 * pull * 4), 1e-6);
  EXPECT_NEAR(back->along, -pull, 1e-6);
}

}  // namespace passing_lookup_test
}  // namespace coaster::sim
