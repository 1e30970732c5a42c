// Poses of cars and what their riders feel.
#include <gtest/gtest.h>

#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace pose_test {

world::TrainMotion at_distance(const DerivedTrack& derived, double distance, double speed) {
  const TrackPlace place = place_at(derived, distance);
  world::TrainMotion cart;
  cart.segment = derived.order[place.index];
  cart.s = place.s;
  cart.speed = speed;
  cart.track_distance = distance;
  cart.segment_length = derived.shape(cart.segment).arc.length();
  return cart;
}

// Of a single car on a plain track.
FeltAcceleration felt_by(const DerivedTrack& derived, const world::TrainMotion& cart) {
  return felt(world::Document{}, derived, world::kNone, cart);
}

TEST(felt, at_rest_on_the_flat_is_one_g_up) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.1f, 2.3f, 2.7f}, {31.1f, 2.3f, 7.7f}, 3));
  for (const double distance : {0.0, 7.3, derived.length}) {
    const FeltAcceleration f = felt_by(derived, at_distance(derived, distance, 0));
    EXPECT_NEAR(f.up, 1, 1e-9);
    EXPECT_NEAR(f.left, 0, 1e-9);
    EXPECT_NEAR(f.forward, 0, 1e-9);
  }
}

TEST(felt, rolling_freely_down_a_straight_slope_is_weightless_forwards) {
  const DerivedTrack derived = test::derived_of(test::straight_document({1.1f, 12.3f, 2.7f}, {25.1f, 2.3f, 2.7f}, 3));
  const FeltAcceleration f = felt_by(derived, at_distance(derived, 11.7, 6.1));
  EXPECT_NEAR(f.forward, 0, 1e-6);
  EXPECT_NEAR(f.up, 24.0 / 26.0, 1e-6);
  EXPECT_NEAR(f.left, 0, 1e-9);
}

TEST(felt, a_circular_loop_has_the_closed_form) {
  // Heartline at radius R - d with the rail's angle s/R: v^2 (R - d)/R^2 towards the centre, 4.64 g at R = 7.5 m, d
  // = 1.1 m, 20 m/s; along the rails -g sin(a) (R - d)/R. Gravity comes on top.
  const double radius = 7.5, inside = 6.4, speed = 20;
  const DerivedTrack derived = test::derived_of(test::circle_document(radius, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}));
  const double turn = speed * speed * inside / (radius * radius) / 9.81;
  EXPECT_NEAR(turn, 4.64, 0.005);
  for (const double a : {0.05, 1.3, M_PI / 2, 2.9, 4.4}) {
    const FeltAcceleration f = felt_by(derived, at_distance(derived, a * radius, speed));
    // 64 cubics: their curvature strays from 1/R by 1e-4 of it.
    EXPECT_NEAR(f.up, turn + std::cos(a), 5e-3) << a;
    EXPECT_NEAR(f.forward, std::sin(a) * (1 - inside / radius), 5e-3) << a;
    EXPECT_NEAR(f.left, 0, 2e-3) << a;
  }
}

TEST(felt, a_flat_turn_to_the_left_pushes_to_the_left) {
  const double radius = 20, speed = 11.3;
  const DerivedTrack derived = test::derived_of(test::ring_document(64, radius, 0));
  const FeltAcceleration f = felt_by(derived, at_distance(derived, 31.7, speed));
  EXPECT_NEAR(f.left, speed * speed / radius / 9.81, 3e-3);
  EXPECT_NEAR(f.up, 1, 1e-3);
  EXPECT_NEAR(felt_by(derived, at_distance(derived, 31.7, -speed)).left, f.left, 1e-9);
}

TEST(pose, sits_on_the_curve_facing_along_it) {
  const world::Document d = test::sample_document();
  const DerivedTrack derived = test::derived_of(d);
  const world::TrainMotion cart = at_distance(derived, 41.3, 5);
  const Pose p = pose(derived, cart, world::FrameMethod::knots);
  const curve::NearestPoint near = curve::nearest_point(world::cubic_of(d, cart.segment), p.position);
  EXPECT_LT(near.distance, 1e-6);
  EXPECT_NEAR(curve::arc_length(world::cubic_of(d, cart.segment), 0, near.t), cart.s, 1e-6);
  EXPECT_NEAR(glm::dot(p.frame.forward, glm::normalize(curve::derivative(world::cubic_of(d, cart.segment), near.t))), 1,
              1e-9);
}

TEST(pose, cars_follow_each_other_at_the_trains_spacing) {
  const double spacing = 3.7, radius = 20.3;
  for (const bool round : {false, true}) {
    world::Document d = round ? test::ring_document(64, radius, 0.0)
                              : test::straight_document({1.1f, 2.3f, 2.7f}, {41.1f, 9.3f, 7.7f}, 3);
    const world::Entity train = world::add_cart(d, d.track.segments[0], 0.0);
    d.entities.get<world::Train>(train).cars = 4;
    d.entities.get<world::Train>(train).spacing = static_cast<float>(spacing);
    const DerivedTrack derived = test::derived_of(d);
    const world::TrainMotion cart = at_distance(derived, 25.3, 5);
    const std::vector<Pose> cars = car_poses(d, derived, train, cart, world::FrameMethod::knots);
    ASSERT_EQ(cars.size(), 4u);
    EXPECT_LT(glm::distance(cars[0].position, pose(derived, cart, world::FrameMethod::knots).position), 1e-9);
    for (std::size_t i = 1; i < cars.size(); ++i) {
      const double chord = round ? 2 * radius * std::sin(spacing / (2 * radius)) : spacing;
      EXPECT_NEAR(glm::distance(cars[i - 1].position, cars[i].position), chord, 1e-4) << round;
      EXPECT_GT(glm::dot(cars[i - 1].position - cars[i].position, cars[i].frame.forward), 0);
    }
  }
}

// On a level straight that rolls evenly from 0 to 90 degrees.
TEST(felt, each_car_feels_the_place_where_it_is) {
  world::Document d = test::straight_document({1.1f, 22.3f, 2.7f}, {31.1f, 22.3f, 2.7f});
  world::append_knot(d, test::skew_knot({61.1f, 22.3f, 2.7f}, {1, 0, 0}, 10, 10));
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[1]), 90);
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[2]), 90);
  for (const std::size_t i : {0u, 1u})
    d.entities.get<world::Knot>(d.track.knots[i]).spin = static_cast<float>(M_PI / 2 / 30);
  const world::Entity train = world::add_cart(d, d.track.segments[0], 0.0);
  d.entities.get<world::Train>(train).cars = 3;
  d.entities.get<world::Train>(train).spacing = 10;
  const DerivedTrack derived = test::derived_of(d);
  const world::TrainMotion cart = at_distance(derived, 25, 0);  // cars at 25, 15 and 5 m of 30 m
  for (int car = 0; car < 3; ++car) {
    const double roll = M_PI / 2 * (25 - 10 * car) / 30;
    const FeltAcceleration f = felt(d, derived, train, cart, car);
    EXPECT_NEAR(f.up, std::cos(roll), 1e-3) << car;
    EXPECT_NEAR(std::abs(f.left), std::sin(roll), 1e-3) << car;
  }
}

TEST(pose, frenet_points_up_to_the_centre_of_curvature) {
  const DerivedTrack derived = test::derived_of(test::circle_document(7.5, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}));
  const glm::dvec3 centre(3.3, 9.2, -2.9);
  for (const double distance : {1.3, 17.1, 30.7}) {
    const Pose p = pose(derived, at_distance(derived, distance, 5), world::FrameMethod::frenet);
    EXPECT_TRUE(p.defined);
    EXPECT_NEAR(glm::dot(p.frame.up, glm::normalize(centre - p.position)), 1, 1e-5);
  }
}

TEST(pose, where_frenet_is_undefined_the_knots_frame_stands_in) {
  // Along an axis the control points are collinear to the bit.
  world::Document d = test::straight_document({1.25f, 2.5f, 2.75f}, {31.25f, 2.5f, 2.75f});
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[0]), 25);
  const DerivedTrack derived = test::derived_of(d);
  const world::TrainMotion cart = at_distance(derived, 11.3, 5);
  const Pose frenet = pose(derived, cart, world::FrameMethod::frenet),
             knots = pose(derived, cart, world::FrameMethod::knots);
  EXPECT_FALSE(frenet.defined);
  EXPECT_EQ(frenet.frame.up, knots.frame.up);
  EXPECT_TRUE(knots.defined);
}

}  // namespace pose_test
}  // namespace coaster::sim
