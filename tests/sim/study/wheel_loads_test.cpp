// Loads of a car's wheels, by statics: the forces with which the rails give the car its felt g (docs/ride.md). A car
// has two bogies. Each side of a bogie has a road wheel above the rail, an up-stop wheel below it and a side wheel
// outside it: src/sim/study/riders.
#include "sim/study/riders.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/solids/track_mesh.h"
#include "sim/solids/train_mesh.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace wheel_loads_test {

using glm::dvec3;

constexpr double kG = 9.81;

struct Case {
  FeltAcceleration felt;
  CarBody car;
};
Case random_case(std::mt19937& bits) {
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  const auto g = [&](double low, double high) { return static_cast<float>(uniform(low, high)); };
  return {{.forward = g(-3, 3), .left = g(-3, 3), .up = g(-3, 6)},
          {uniform(200, 20'000), uniform(1, 12), uniform(-1.5, 1.5)}};
}

// Force and moment about the centre of mass that the rails give the car, in N and N m, on the axes forward, left, up.
// Wheels touch the rails at the corners of a rectangle; what moves the car along the track does so between the rails.
struct ActiveLesson {
  dvec3 force{0}, moment{0};
};
ActiveLesson given(const WheelLoads& loads, const Case& c) {
  ActiveLesson sum;
  const auto add = [&](dvec3 force, dvec3 at) {
    sum.force += force;
    sum.moment += glm::cross(at - dvec3(0, 0, c.car.height), force);
  };
  const double ahead = 0.5 * 0.6 * c.car.length, beside = 0.5 * 1.2;
  const dvec3 corners[] = {{ahead, beside, 0}, {ahead, -beside, 0}, {-ahead, beside, 0}, {-ahead, -beside, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    const LoadsByWheelKind& wheels = loads.corners[i];
    add({0, 0, 1000 * wheels.road}, corners[i]);
    add({0, 0, -1000 * wheels.up_stop}, corners[i]);
    add({0, (corners[i].y > 0 ? 1000 : -1000) * wheels.side, 0}, corners[i]);
  }
  add({c.car.mass * kG * c.felt.forward, 0, 0}, {0, 0, 0});
  return sum;
}

TEST(wheel_loads, forces_and_moments_hold_the_car_whatever_it_feels) {
  std::mt19937 bits(7);
  for (int i = 0; i < 20'000; ++i) {
    const Case c = random_case(bits);
    const WheelLoads loads = wheel_loads(c.felt, c.car);
    const ActiveLesson sum = given(loads, c);
    const double weight = c.car.mass * kG;
    EXPECT_LT(glm::distance(sum.force, weight * dvec3(c.felt.forward, c.felt.left, c.felt.up)), 1e-9 * weight) << i;
    EXPECT_LT(glm::length(sum.moment), 1e-8 * weight * c.car.length) << i;
    for (const LoadsByWheelKind& wheels : loads.corners) {
      EXPECT_GE(wheels.road, 0);
      EXPECT_GE(wheels.side, 0);
      EXPECT_GE(wheels.up_stop, 0);
      EXPECT_EQ(wheels.road * wheels.up_stop, 0) << "a wheel on each face of the rail carries";
    }
  }
}

TEST(wheel_loads, a_set_is_the_sum_of_its_wheels) {
  std::mt19937 bits(8);
  for (int i = 0; i < 50; ++i) {
    const Case c = random_case(bits);
    const WheelLoads loads = wheel_loads(c.felt, c.car);
    const auto road = [&](WheelSet set) { return loads.of(set).road; };
    const auto& [fl, fr, rl, rr] = loads.corners;
    EXPECT_EQ(road(WheelSet::front_left), fl.road);
    EXPECT_EQ(road(WheelSet::front_right), fr.road);
    EXPECT_EQ(road(WheelSet::rear_left), rl.road);
    EXPECT_EQ(road(WheelSet::rear_right), rr.road);
    EXPECT_DOUBLE_EQ(road(WheelSet::front), fl.road + fr.road);
    EXPECT_DOUBLE_EQ(road(WheelSet::rear), rl.road + rr.road);
    EXPECT_DOUBLE_EQ(loads.of(WheelSet::left).up_stop, fl.up_stop + rl.up_stop);
    EXPECT_DOUBLE_EQ(loads.of(WheelSet::right).side, fr.side + rr.side);
    EXPECT_NEAR(road(WheelSet::car), fl.road + fr.road + rl.road + rr.road, 1e-12 * c.car.mass);
  }
}

TEST(wheel_loads, a_push_to_the_left_goes_through_the_left_side_wheels_and_loads_the_right_road_wheels) {
  const WheelLoads loads = wheel_loads({0, 0.25f, 1}, {800, 3, 1.1});
  EXPECT_NEAR(loads.of(WheelSet::left).side, 0.25 * 0.8 * kG, 1e-12);
  EXPECT_EQ(loads.of(WheelSet::right).side, 0);
  // Moments about the left rail: the right one carries half the weight and the lateral force times height over gauge.
  EXPECT_NEAR(loads.of(WheelSet::right).road, 0.8 * kG * (0.5 + 0.25 * 1.1 / 1.2), 1e-12);
}

TEST(wheel_loads, a_launch_loads_the_rear_and_brakes_load_the_front) {
  // Moments about the front bogie, 0.6 of 3 m away.
  const double rear = 0.8 * kG * (0.5 + 0.5 * 1.1 / 1.8);
  EXPECT_NEAR(wheel_loads({0.5f, 0, 1}, {800, 3, 1.1}).of(WheelSet::rear).road, rear, 1e-12);
  EXPECT_NEAR(wheel_loads({-0.5f, 0, 1}, {800, 3, 1.1}).of(WheelSet::front).road, rear, 1e-12);
}

// The wheels of a train of one car on its first segment, at a speed.
WheelLoads on_track(world::Document document, double speed, float mass) {
  const world::Entity cart = world::add_cart(document, document.track.segments.at(0), 0.0);
  document.entities.get<world::Train>(cart).mass = mass;
  document.start_speed = speed;
  const DerivedTrack derived = test::derived_of(document);
  world::Motion motion;
  reset(document, derived, motion);
  return wheel_loads(document, derived, cart, *motion.carts.find(cart));
}
void roll_over(world::Document& document) {
  for (const world::Entity k : document.track.knots) {
    world::Knot& knot = document.entities.get<world::Knot>(k);
    knot.up = -knot.up;
  }
}

TEST(wheel_loads, at_rest_on_the_flat_each_road_wheel_carries_a_quarter_of_the_weight) {
  const WheelLoads loads = on_track(test::straight_document({1.1f, 9.3f, 2.7f}, {31.1f, 9.3f, 12.7f}, 3), 0, 840);
  for (const LoadsByWheelKind& wheels : loads.corners) {
    EXPECT_NEAR(wheels.road, 0.84 * kG / 4, 1e-6);
    EXPECT_NEAR(wheels.up_stop, 0, 1e-6);
    EXPECT_NEAR(wheels.side, 0, 1e-6);
  }
}

TEST(wheel_loads, upside_down_at_rest_each_up_stop_carries_a_quarter_of_the_weight) {
  world::Document document = test::straight_document({1.1f, 9.3f, 2.7f}, {31.1f, 9.3f, 12.7f}, 3);
  roll_over(document);
  const WheelLoads loads = on_track(document, 0, 840);
  for (const LoadsByWheelKind& wheels : loads.corners) {
    EXPECT_NEAR(wheels.up_stop, 0.84 * kG / 4, 1e-6);
    EXPECT_NEAR(wheels.road, 0, 1e-6);
  }
}

// The rails are a circle of radius R; riders and mass are h closer to its centre, so they feel v^2 (R - h) / R^2.
TEST(wheel_loads, in_a_valley_of_four_g_the_road_wheels_carry_four_times_the_weight) {
  const double radius = 21.3, height = 1.1, speed = std::sqrt(3 * kG * radius * radius / (radius - height));
  const WheelLoads loads = on_track(test::circle_document(radius, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}, 128), speed, 840);
  EXPECT_NEAR(loads.of(WheelSet::car).road, 4 * 0.84 * kG, 0.02);
  EXPECT_NEAR(loads.of(WheelSet::front).road, loads.of(WheelSet::rear).road, 0.02);
  EXPECT_EQ(loads.of(WheelSet::car).up_stop, 0);
}

TEST(wheel_loads, at_minus_one_g_on_a_crest_the_up_stops_carry_the_weight) {
  const double radius = 21.3, height = 1.1, speed = std::sqrt(2 * kG * radius * radius / (radius + height));
  // The top of a circle with the riders outside: its bottom turned over about the line of travel.
  world::Document document = test::circle_document(radius, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}, 128);
  for (const world::Entity k : document.track.knots) {
    world::Knot& knot = document.entities.get<world::Knot>(k);
    knot.position.y = 60.0f - knot.position.y;
    knot.tangent.y = -knot.tangent.y, knot.up.y = -knot.up.y;
    knot.up = -knot.up;
  }
  const WheelLoads loads = on_track(document, speed, 840);
  EXPECT_NEAR(loads.of(WheelSet::car).up_stop, 0.84 * kG, 0.02);
  EXPECT_EQ(loads.of(WheelSet::car).road, 0);
}

TEST(wheel_loads, the_simulated_ride_and_the_moving_train_agree) {
  world::Document document = test::ring_document(24, 40.7, 4.3);
  const world::Entity train = world::add_cart(document, document.track.segments.at(0), 0.2);
  document.entities.get<world::Train>(train).cars = 3, document.entities.get<world::Train>(train).mass = 730;
  document.start_speed = 16.3;
  const DerivedTrack derived = test::derived_of(document);
  world::Motion motion;
  reset(document, derived, motion);
  RideCache cache;
  const WheelLoads moving = wheel_loads(document, derived, train, *motion.carts.find(train)),
                   simulated = wheel_loads(*cache.ride(document, derived, train), 0, 0);
  EXPECT_GT(moving.of(WheelSet::car).side, 0.5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(simulated.corners[i].road, moving.corners[i].road, 0.05);
    EXPECT_NEAR(simulated.corners[i].up_stop, moving.corners[i].up_stop, 0.05);
    EXPECT_NEAR(simulated.corners[i].side, moving.corners[i].side, 0.05);
  }
}

TEST(wheel_loads, the_bogies_are_where_the_car_has_them) {
  float front = 0;
  int wheels = 0;
  for (const MeshVertex& v : car_mesh({}, false).vertices) {
    if (v.part != static_cast<float>(Material::wheel) || v.position.x < 0) continue;
    front += v.position.x, ++wheels;
  }
  EXPECT_NEAR(2 * front / static_cast<float>(wheels), kBogieShare * world::kCarLength, 1e-3);
  EXPECT_EQ(kGauge, 1.2);
}

}  // namespace wheel_loads_test
}  // namespace coaster::sim
