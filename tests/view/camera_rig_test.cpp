#include "view/camera_rig.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "exchange/track_file.h"
#include "sim/tracks.h"

namespace coaster::view {
namespace {

using glm::dvec3;
using world::CameraMode;

world::Document sample(const std::string& name) {
  base::Files files;
  auto loaded = exchange::load_track(files, std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  EXPECT_TRUE(loaded) << name;
  return loaded ? std::move(loaded->document) : world::Document{};
}

world::Document with_cart(world::Document d, double speed, int cars = 1) {
  const world::Entity cart = world::add_cart(d, d.track.segments.front(), 0.1);
  d.entities.get<world::Cart>(cart).cars = cars;
  d.start_speed = speed;
  return d;
}

// A ride with an eye on it.
struct Watch {
  world::Document document;
  world::Settings settings;
  sim::Derived derived;
  world::Motion motion;
  sim::GhostMemo memo;
  CameraRig rig;

  Watch(world::Document d, CameraMode mode) : document(std::move(d)) {
    settings.camera_mode = mode;
    sim::derive(document, settings, {}, derived);
    sim::reset(document, derived, motion);
    motion.state = world::RideState::running;
    look(0);
  }
  Watched watched() const { return {document, derived, motion, settings}; }
  void look(int ticks) { follow(rig, watched(), ticks); }
  void tick() {
    sim::step(document, derived, 0, 1, memo, motion);
    look(1);
  }
  const world::CartMotion& cart() const { return motion.carts.items()[0]; }
  sim::Pose pose() const { return sim::pose(derived, cart(), settings.frames); }
};

void expect_sound(const Eye& eye) {
  const View v = view_of(eye, {0, 0, 640, 360});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) ASSERT_TRUE(std::isfinite(v.view[i][j]) && std::isfinite(v.projection[i][j]));
  ASSERT_NEAR(glm::length(eye.forward), 1, 1e-6);
  ASSERT_GE(eye.position.y, kLowestEye - 1e-6);
}

double right_height(const Eye& eye) { return glm::normalize(glm::cross(eye.forward, eye.up)).y; }

// The roll of a frame against the picture's up, about the picture's forward.
double roll_between(const Eye& eye, const curve::Frame& frame) {
  return std::atan2(glm::dot(glm::cross(eye.up, frame.up), frame.forward), glm::dot(eye.up, frame.up));
}

constexpr int kLap = 120 * 120;  // ticks, at most

TEST(chase_camera, it_keeps_its_distance_off_the_ground_and_off_the_track_for_a_lap_and_over_the_closing_joint) {
  for (const char* name : {"loop", "helix", "gentle"})
    for (const int cars : {1, 6}) {
      world::Document d = sample(name);
      d.entities.get<world::Cart>(world::first_cart(d)).cars = cars;
      if (cars > 1) d.start_speed = 9;  // a long train needs it to leave the first crest
      Watch w(std::move(d), CameraMode::chase);
      const double wanted = w.settings.feel.chase_distance + 0.6 * 3.0 * (cars - 1);
      double nearest = 1e9, furthest = 0, from_track = 1e9, off_middle = 0;
      int ticks = 0;
      for (; ticks < kLap && (w.cart().laps == 0 || w.cart().track_distance < 20); ++ticks) {
        w.tick();
        const Eye& eye = w.rig.eye;
        expect_sound(eye);
        ASSERT_GE(eye.position.y, 1.0) << name << " tick " << ticks;
        const sim::Pose middle = sim::car_poses(w.document, w.derived, w.motion.carts.entities()[0], w.cart(), w.settings.frames)[static_cast<std::size_t>(cars / 2)];
        const double distance = glm::distance(eye.position, middle.position);
        nearest = std::min(nearest, distance), furthest = std::max(furthest, distance);
        from_track = std::min(from_track, nearest_track(w.derived, eye.position, 5).distance);
        const auto seen = project(view_of(eye, {0, 0, 1280, 720}), glm::vec3(middle.position));
        ASSERT_TRUE(seen) << name << " tick " << ticks;
        off_middle = std::max(off_middle, static_cast<double>(glm::length(glm::vec2(*seen) - glm::vec2(640, 360))));
      }
      ASSERT_LT(ticks, kLap) << name << cars << " at " << w.cart().track_distance << " state " << static_cast<int>(w.motion.state);
      EXPECT_GT(nearest, 0.5 * wanted) << name;
      EXPECT_LT(furthest, 1.6 * wanted) << name;
      EXPECT_GT(from_track, 0.7) << name;  // 0.45 m is half the track's width
      EXPECT_LT(off_middle, 200) << name;  // px
    }
}

TEST(cameras, an_eye_that_goes_with_a_train_moves_no_further_in_a_tick_than_the_train_and_its_own_swing) {
  for (const char* name : {"loop", "helix", "gentle"})
    for (const CameraMode mode : {CameraMode::ride, CameraMode::chase}) {
      Watch w(sample(name), mode);
      double most = 0, most_turn = 0;
      for (int i = 0; i < kLap && (w.cart().laps == 0 || w.cart().track_distance < 20); ++i) {
        const Eye before = w.rig.eye;
        w.tick();
        most = std::max(most, glm::distance(before.position, w.rig.eye.position) - std::abs(w.cart().speed) * world::kTick);
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
  for (const double lag : {0.0, 0.1, 0.25, 0.6}) {
    Watch w(with_cart(d, 20), CameraMode::ride);
    w.settings.feel.roll_damping = static_cast<float>(lag);
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
  Watch w(sample("loop"), CameraMode::ride);
  w.settings.feel.roll_damping = 0;
  for (int i = 0; i < 3000; ++i) {
    w.tick();
    ASSERT_LT(glm::length(w.rig.eye.up - w.pose().frame.up), 1e-9);
    ASSERT_LT(glm::distance(w.rig.eye.position, w.pose().position + 1.1 * w.pose().frame.up), 1e-6);
  }
}

TEST(reduced_motion, the_horizon_stays_level_and_the_view_is_calm_through_a_loop) {
  for (const char* name : {"loop", "helix"}) {
    world::Document d = sample(name);
    Watch w(std::move(d), CameraMode::ride);
    w.settings.feel.reduced_motion = true, w.settings.feel.head_bob = true;
    w.look(0);
    double most = 0;
    for (int i = 0; i < kLap && w.cart().laps == 0; ++i) {
      const dvec3 before = w.rig.eye.forward;
      w.tick();
      ASSERT_NEAR(right_height(w.rig.eye), 0, 1e-9);
      ASSERT_GT(w.rig.eye.up.y, 0);
      ASSERT_EQ(w.rig.eye.field_of_view_deg, w.settings.feel.ride_view_deg);
      const dvec3 seat = w.pose().position + 1.1 * w.pose().frame.up;
      ASSERT_LT(glm::distance(w.rig.eye.position, seat), 0.071);  // head-bob is off: only what is left of it settles
      most = std::max(most, glm::length(w.rig.eye.forward - before));
    }
    EXPECT_LT(most, 0.035) << name;  // rad a tick: 4 rad/s
  }
}

TEST(transitions, they_take_48_ticks_are_continuous_and_are_cut_by_reduced_motion) {
  Watch w(sample("loop"), CameraMode::orbit);
  for (const CameraMode to : {CameraMode::ride, CameraMode::chase, CameraMode::fly, CameraMode::ride, CameraMode::orbit}) {
    const Eye before = w.rig.eye;
    w.settings.camera_mode = to;
    w.look(0);
    EXPECT_LT(glm::distance(w.rig.eye.position, before.position), 1e-6);
    EXPECT_LT(glm::length(w.rig.eye.forward - before.forward), 1e-6);
    EXPECT_NEAR(w.rig.eye.field_of_view_deg, before.field_of_view_deg, 1e-9);
    for (int i = 0; i < 47; ++i) w.tick();
    EXPECT_EQ(w.rig.ticks_left, 1);
    w.tick();
    EXPECT_EQ(w.rig.ticks_left, 0);
    expect_sound(w.rig.eye);
  }
  w.settings.feel.reduced_motion = true;
  w.look(0);
  w.settings.camera_mode = CameraMode::ride;
  w.look(0);
  EXPECT_EQ(w.rig.ticks_left, 0);
  EXPECT_LT(glm::distance(w.rig.eye.position, w.pose().position + 1.1 * w.pose().frame.up), 1e-6);
}

TEST(cameras, without_the_cart_they_are_the_orbit_camera_until_it_comes_back) {
  for (const CameraMode mode : {CameraMode::ride, CameraMode::chase}) {
    Watch w(sample("gentle"), mode);
    for (int i = 0; i < 300; ++i) w.tick();
    const world::Document with = w.document;
    w.document.entities.destroy(world::first_cart(w.document));
    sim::derive(w.document, w.settings, {}, w.derived);
    sim::reconcile(w.document, w.derived, w.motion);
    w.look(0);
    EXPECT_EQ(w.rig.mode, CameraMode::orbit);
    for (int i = 0; i < 60; ++i) w.look(1);
    EXPECT_EQ(w.rig.eye.position, orbit_eye(w.settings.camera).position);
    w.document = with;
    sim::derive(w.document, w.settings, {}, w.derived);
    sim::reconcile(w.document, w.derived, w.motion);
    w.look(0);
    EXPECT_EQ(w.rig.mode, mode);
  }
  Watch empty({}, CameraMode::ride);
  EXPECT_EQ(empty.rig.mode, CameraMode::orbit);
  expect_sound(empty.rig.eye);
}

TEST(cameras, a_train_that_leaps_is_looked_at_afresh) {
  Watch w(sample("loop"), CameraMode::chase);
  for (int i = 0; i < 600; ++i) w.tick();
  sim::reset(w.document, w.derived, w.motion);
  w.look(0);
  Watch fresh(sample("loop"), CameraMode::chase);
  EXPECT_LT(glm::distance(w.rig.eye.position, fresh.rig.eye.position), 1e-9);
  EXPECT_LT(glm::length(w.rig.eye.forward - fresh.rig.eye.forward), 1e-9);
}

TEST(head_bob, it_is_small_a_function_of_the_ride_and_off_by_default) {
  const auto run = [](bool bob) {
    Watch w(sample("helix"), CameraMode::ride);
    w.settings.feel.head_bob = bob;
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

TEST(cameras, vertical_inverted_still_and_degenerate_tracks_give_sound_eyes) {
  std::vector<world::Document> documents{
      test::straight_document({0, 5, 0}, {0, 90, 0}, 3),    // straight up
      test::straight_document({0, 90, 0}, {0, 0, 0}, 3),    // straight down, into the ground
      test::circle_document(7, {0, 0.1, 0}, {1, 0, 0.3}),  // a loop from the ground
      test::straight_document({1, -3, 1}, {40, -3, 1}, 2),  // below the ground
  };
  world::Document tiny;
  for (int i = 0; i < 2; ++i) world::append_knot(tiny, {.position = {1, 2, 3}, .in_length = world::kMinHandle, .out_length = world::kMinHandle});
  documents.push_back(tiny);
  for (world::Document& d : documents)
    for (const double speed : {0.0, 30.0, -5.0})
      for (const CameraMode mode : {CameraMode::ride, CameraMode::chase})
        for (const bool reduced : {false, true}) {
          Watch w(with_cart(d, speed, 3), mode);
          w.settings.feel.reduced_motion = reduced, w.settings.feel.head_bob = true;
          for (int i = 0; i < 240; ++i) {
            w.tick();
            expect_sound(w.rig.eye);
          }
        }
}

RC_GTEST_PROP(damped, two_steps_are_one_of_their_sum, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) * 0.01; };
  Damped<double> a{number(), number()}, b = a;
  const double target = number(), lag = *rc::gen::inRange(1, 300) * 0.01, dt = *rc::gen::inRange(1, 200) * 0.01;
  a.approach(target, lag, dt);
  b.approach(target, lag, 0.3 * dt), b.approach(target, lag, 0.7 * dt);
  RC_ASSERT(std::abs(a.value - b.value) < 1e-9 && std::abs(a.rate - b.rate) < 1e-9);
}

TEST(fly_camera, it_begins_where_the_eye_is_and_looks_there) {
  const View v = orbit_view({{3, 7, -2}, 33, 21, 40}, {0, 0, 640, 360});
  const Eye fly = fly_eye(fly_from(v), 45);
  EXPECT_LT(glm::distance(fly.position, dvec3(v.eye)), 1e-4);
  const View again = view_of(fly, v.viewport);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(again.view[i][j], v.view[i][j], 1e-5f);
}

}  // namespace
}  // namespace coaster::view
