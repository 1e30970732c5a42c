#include "view/camera_rig.h"

#include <rapidcheck/gtest.h>

#include "view/watch.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace camera_rig_test {

using glm::dvec3;
using world::CameraMode;

TEST(transitions, they_take_48_ticks_are_continuous_and_are_cut_by_reduced_motion) {
  Watch w(sample_track("loop"), CameraMode::orbit);
  for (const CameraMode to :
       {CameraMode::ride, CameraMode::chase, CameraMode::fly, CameraMode::ride, CameraMode::orbit}) {
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
  w.settings.feel->reduced_motion = true;
  w.look(0);
  w.settings.camera_mode = CameraMode::ride;
  w.look(0);
  EXPECT_EQ(w.rig.ticks_left, 0);
  EXPECT_LT(glm::distance(w.rig.eye.position, w.pose().position + 1.1 * w.pose().frame.up), 1e-6);
}

TEST(cameras, without_the_cart_they_are_the_orbit_camera_until_it_comes_back) {
  for (const CameraMode mode : {CameraMode::ride, CameraMode::chase}) {
    Watch w(sample_track("gentle"), mode);
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
  Watch w(sample_track("loop"), CameraMode::chase);
  for (int i = 0; i < 600; ++i) w.tick();
  sim::reset(w.document, w.derived, w.motion);
  w.look(0);
  Watch fresh(sample_track("loop"), CameraMode::chase);
  EXPECT_LT(glm::distance(w.rig.eye.position, fresh.rig.eye.position), 1e-9);
  EXPECT_LT(glm::length(w.rig.eye.forward - fresh.rig.eye.forward), 1e-9);
}

TEST(cameras, vertical_inverted_still_and_degenerate_tracks_give_sound_eyes) {
  std::vector<world::Document> documents{
      test::straight_document({0, 5, 0}, {0, 90, 0}, 3),    // straight up
      test::straight_document({0, 90, 0}, {0, 0, 0}, 3),    // straight down, into the ground
      test::circle_document(7, {0, 0.1, 0}, {1, 0, 0.3}),   // a loop from the ground
      test::straight_document({1, -3, 1}, {40, -3, 1}, 2),  // below the ground
  };
  world::Document tiny;
  for (int i = 0; i < 2; ++i)
    world::append_knot(tiny, {.position = {1, 2, 3}, .in_length = world::kMinHandle, .out_length = world::kMinHandle});
  documents.push_back(tiny);
  for (world::Document& d : documents)
    for (const double speed : {0.0, 30.0, -5.0})
      for (const CameraMode mode : {CameraMode::ride, CameraMode::chase})
        for (const bool reduced : {false, true}) {
          Watch w(with_cart(d, speed, 3), mode);
          w.settings.feel->reduced_motion = reduced, w.settings.feel->head_bob = true;
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

}  // namespace camera_rig_test
}  // namespace coaster::view
