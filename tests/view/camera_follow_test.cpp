// The camera that follows a train: its direction and its lag.
#include "view/camera_rig.h"

#include <rapidcheck/gtest.h>

#include <numbers>

#include "base/tries.h"
#include "view/watch.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace camera_follow_test {

using glm::dvec3;
using world::CameraMode;

// The roll of a frame against the picture's up, about the picture's forward.
double roll_between(const Eye& eye, const curve::Frame& frame) {
  return std::atan2(glm::dot(glm::cross(eye.up, frame.up), frame.forward), glm::dot(eye.up, frame.up));
}

constexpr int kLap = 120 * 120;  // ticks, at most

TEST(chase_camera, it_keeps_its_distance_off_the_ground_and_off_the_track_for_a_lap_and_over_the_closing_joint) {
  int i = 0;
  for (const char* name : {"loop", "helix", "gentle"})
    for (const int cars : {1, 6}) {
      if (!test::tried(i++)) continue;
      world::Document d = sample_track(name);
      d.entities.get<world::Train>(world::first_cart(d)).cars = cars;
      if (cars > 1) d.start_speed = 9;  // a long train needs it to leave the first crest
      Watch w(std::move(d), CameraMode::chase);
      const double wanted = w.settings.feel->chase_distance + 0.6 * 3.0 * (cars - 1);
      double nearest = 1e9, furthest = 0, from_track = 1e9, off_middle = 0;
      int ticks = 0;
      for (; ticks < kLap && (w.cart().laps == 0 || w.cart().track_distance < 20); ++ticks) {
        w.tick();
        const Eye& eye = w.rig.eye;
        expect_sound(eye);
        ASSERT_GE(eye.position.y, 1.0) << name << " tick " << ticks;
        const sim::Pose middle = sim::car_poses(w.document, w.derived, w.motion.carts.entities()[0], w.cart(),
                                                w.settings.frames)[static_cast<std::size_t>(cars / 2)];
        const double distance = glm::distance(eye.position, middle.position);
        nearest = std::min(nearest, distance), furthest = std::max(furthest, distance);
        from_track = std::min(from_track, nearest_track(w.derived, eye.position, 5).distance);
        const auto seen = project(view_of(eye, {0, 0, 1280, 720}), glm::vec3(middle.position));
        ASSERT_TRUE(seen) << name << " tick " << ticks;
        off_middle = std::max(off_middle, static_cast<double>(glm::length(glm::vec2(*seen) - glm::vec2(640, 360))));
      }
      ASSERT_LT(ticks, kLap) << name << cars << " at " << w.cart().track_distance << " state "
                             << static_cast<int>(w.motion.state);
      EXPECT_GT(nearest, 0.5 * wanted) << name;
      EXPECT_LT(furthest, 1.6 * wanted) << name;
      EXPECT_GT(from_track, 0.7) << name;  // 0.45 m is half the track's width
      EXPECT_LT(off_middle, 200) << name;  // px
    }
}

TEST(cameras, an_eye_that_goes_with_a_train_moves_no_further_in_a_tick_than_the_train_and_its_own_swing) {
  for (const char* name : {"loop", "helix", "gentle"})
    for (const CameraMode mode : {CameraMode::ride, CameraMode::chase}) {
      Watch w(sample_track(name), mode);
      double most = 0, most_turn = 0;
      for (int i = 0; i < kLap && (w.cart().laps == 0 || w.cart().track_distance < 20); ++i) {
        const Eye before = w.rig.eye;
        w.tick();
        most = std::max(most,
                        glm::distance(before.position, w.rig.eye.position) - std::abs(w.cart().speed) * world::kTick);
        most_turn = std::max(most_turn, glm::length(before.forward - w.rig.eye.forward));
      }
      // The rider sits 1.1 m off the rails and turns with them; the chaser swings about the train.
      EXPECT_LT(most, mode == CameraMode::ride ? 0.05 : 0.25) << name;
      EXPECT_LT(most_turn, 0.06) << name;
    }
}

TEST(ride_camera, a_steady_roll_is_followed_as_late_as_the_setting_says) {
  // A straight line that rolls by 360 degrees in 40 m at 20 m/s: half a turn a second.
  world::Document d = test::straight_document({3, 30, -7}, {803, 30, -7}, 20);
  for (const world::Entity e : d.track.segments) d.entities.get<world::Segment>(e).turns = 1;
  sim::set_automatic_spins(d);
  for (const double lag : {0.0, 0.1, 0.25, 0.6, 1.4}) {  // the last is late by more than half a turn
    Watch w(with_cart(d, 20), CameraMode::ride);
    w.settings.feel->roll_damping = static_cast<float>(lag);
    for (int i = 0; i < 6 * 120; ++i) w.tick();
    EXPECT_NEAR(std::abs(w.rig.roll_lag), std::numbers::pi * lag, 0.02 * std::numbers::pi * lag + 0.02) << lag;
    EXPECT_NEAR(glm::dot(w.rig.eye.up, w.pose().frame.up), std::cos(std::numbers::pi * lag), 0.05) << lag;
    EXPECT_LT(glm::length(w.rig.eye.forward - w.pose().frame.forward), 1e-9) << "the way ahead is not damped";
  }
}

TEST(ride_camera, the_damped_roll_comes_to_the_tracks_without_jump_or_overshoot) {
  // Rolls by half a turn within one segment, then goes straight on.
  world::Document d = test::straight_document({3, 30, -7}, {803, 30, -7}, 20);
  const glm::vec3 up = world::knot(d, d.track.knots[2]).up;
  for (std::size_t i = 3; i < d.track.knots.size(); ++i) {
    world::Knot& k = d.entities.get<world::Knot>(d.track.knots[i]);
    k.up = std::cos(1.9f) * up + std::sin(1.9f) * glm::cross(k.tangent, up);
  }
  Watch w(with_cart(d, 20), CameraMode::ride);
  double last = 0, most = 0, step = 0;
  for (int i = 0; i < 15 * 120; ++i) {
    const dvec3 before = w.rig.eye.up;
    w.tick();
    last = roll_between(w.rig.eye, w.pose().frame);
    most = std::max(most, last);
    step = std::max(step, glm::length(w.rig.eye.up - before));
    ASSERT_GT(last, -1e-3) << "overshoot";
  }
  EXPECT_GT(most, 0.05) << "there was a roll to be late for";
  EXPECT_NEAR(last, 0, 1e-4);
  EXPECT_LT(step, 1.9 / 2 * 1.5 / 120 * 2);  // rad a tick: 1.9 rad in 2 s, at twice the steady rate
}

TEST(ride_camera, without_damping_the_roll_is_the_tracks_at_once) {
  Watch w(sample_track("loop"), CameraMode::ride);
  w.settings.feel->roll_damping = 0;
  for (int i = 0; i < 3000; ++i) {
    w.tick();
    ASSERT_LT(glm::length(w.rig.eye.up - w.pose().frame.up), 1e-9);
    ASSERT_LT(glm::distance(w.rig.eye.position, w.pose().position + 1.1 * w.pose().frame.up), 1e-6);
  }
}

TEST(reduced_motion, the_horizon_stays_level_and_the_view_is_calm_through_a_loop) {
  for (const char* name : {"loop", "helix"}) {
    world::Document d = sample_track(name);
    Watch w(std::move(d), CameraMode::ride);
    w.settings.feel->reduced_motion = true, w.settings.feel->head_bob = true;
    w.look(0);
    double most = 0;
    for (int i = 0; i < kLap && w.cart().laps == 0; ++i) {
      const dvec3 before = w.rig.eye.forward;
      w.tick();
      ASSERT_NEAR(right_height(w.rig.eye), 0, 1e-9);
      ASSERT_GT(w.rig.eye.up.y, 0);
      ASSERT_EQ(w.rig.eye.field_of_view_deg, w.settings.feel->ride_view_deg);
      const dvec3 seat = w.pose().position + 1.1 * w.pose().frame.up;
      ASSERT_LT(glm::distance(w.rig.eye.position, seat), 0.071);  // head-bob is off: only what is left of it settles
      most = std::max(most, glm::length(w.rig.eye.forward - before));
    }
    EXPECT_LT(most, 0.035) << name;  // rad a tick: 4 rad/s
  }
}

TEST(head_bob, it_is_small_a_function_of_the_ride_and_off_by_default) {
  const auto run = [](bool bob) {
    Watch w(sample_track("helix"), CameraMode::ride);
    w.settings.feel->head_bob = bob;
    std::vector<double> off;
    for (int i = 0; i < 2400; ++i) {
      w.tick();
      off.push_back(glm::distance(w.rig.eye.position, w.pose().position + 1.1 * w.pose().frame.up));
    }
    return off;
  };
  const std::vector<double> without = run(false), with = run(true);
  EXPECT_FALSE(world::CameraFeel{}.head_bob);
  EXPECT_LT(*std::max_element(without.begin(), without.end()), 1e-6);
  EXPECT_GT(*std::max_element(with.begin(), with.end()), 0.01);
  EXPECT_LT(*std::max_element(with.begin(), with.end()), 0.12);
  EXPECT_EQ(with, run(true));
}

}  // namespace camera_follow_test
}  // namespace coaster::view
