// Cameras over a land: their eyes against its heights, and the chase camera in a tunnel against the tube.
#include <gtest/gtest.h>

#include "sim/lands.h"
#include "view/watch.h"
#include "world/appearance_settings.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace camera_ground_test {

using glm::dvec3;
using test::TrackOnLand;

TrackOnLand waves(double water = world::kNoWater) {
  world::Document document = test::straight_document({-60, 30, 0}, {60, 30, 0}, 6);
  test::shape_land(document, [](double x, double z) { return 9 * std::sin(x / 13) * std::cos(z / 19); });
  document.park.water = water;
  return TrackOnLand(document);
}

TEST(CameraOnLand, the_orbit_eye_stays_over_ground_and_water) {
  const TrackOnLand land = waves(-3);
  int raised = 0, wet = 0;
  for (float yaw = 0; yaw < 360; yaw += 17)
    for (const float distance : {5.0f, 20.0f, 55.0f})
      for (const float pitch : {-20.0f, 3.0f, 40.0f}) {
        const world::Camera camera{.target = {11, -4, -7}, .yaw_deg = yaw, .pitch_deg = pitch, .distance = distance};
        const Eye eye = orbit_eye(camera, &land.ground), plane = orbit_eye(camera);
        const double surface = std::max(land.ground.height(eye.position.x, eye.position.z), -3.0);
        EXPECT_GE(eye.position.y, surface + 0.3 - 1e-4);
        raised += eye.position.y < surface + 0.3 + 1e-4, wet += surface == -3;
        EXPECT_EQ(eye.position.x, plane.position.x);
        const dvec3 to = dvec3(camera.target) - eye.position;
        EXPECT_GT(glm::dot(glm::normalize(to), eye.forward), 1 - 1e-6) << "it still looks at its target";
        EXPECT_TRUE(orbit_eye(camera, nullptr).position == plane.position);
      }
  EXPECT_GT(raised, 20);
  EXPECT_GT(wet, 3);
}

TEST(CameraOnLand, flying_stays_above_and_an_empty_track_is_framed_on_its_land) {
  const TrackOnLand land = waves();
  for (int i = 0; i < 40; ++i) {
    const glm::vec3 at(3.1f * static_cast<float>(i) - 60, -20.0f + static_cast<float>(i),
                       31 - 1.7f * static_cast<float>(i));
    const Eye eye = fly_eye({.eye = at}, 45, &land.ground);
    const double least = land.ground.height(eye.position.x, eye.position.z) + 0.5;
    EXPECT_NEAR(eye.position.y, std::max(double{at.y}, least), 1e-4);
  }
  world::Document empty;
  test::shape_land(empty, [](double, double) { return 23.0; });
  EXPECT_NEAR(frame_all({}, empty, {0, 0, 640, 360}).target.y - frame_all({}, {}, {0, 0, 640, 360}).target.y, 23, 1e-3);
}

// A train that goes through a ridge, followed tick by tick.
struct TunnelWatch : Watch {
  sim::Ground ground;
  TunnelWatch(world::Document d, world::CameraMode mode) : Watch(std::move(d), mode) {
    ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
    rig = {};
    look_on(0);
  }
  CameraSubject on_land() const { return {document, derived, motion, settings, true, &ground}; }
  void look_on(int ticks) { follow(rig, on_land(), ticks); }
  void tick_on() {
    sim::step(document, derived, {}, 1, cache, motion);
    look_on(1);
  }
};
world::Document through_a_ridge() {
  world::Document document = with_cart(test::straight_document({-110, 5, 0}, {110, 5, 0}, 11), 15, 3);
  document.resistance = {};
  test::shape_land(document, test::ridge(24, 40));
  return document;
}

TEST(CameraOnLand, chasing_keeps_to_the_tube_in_a_tunnel_and_over_the_ground_outside) {
  TunnelWatch watch(through_a_ridge(), world::CameraMode::chase);
  ASSERT_EQ(watch.ground.tunnels().size(), 1u);
  const sim::Tunnel tunnel = watch.ground.tunnels().front();
  const double from = tunnel.from - 110, to = from + tunnel.length;
  int inside = 0, outside = 0;
  dvec3 last = watch.rig.eye.position;
  while (watch.cart().track_distance < 205) {
    watch.tick_on();
    const dvec3 eye = watch.rig.eye.position;
    if (eye.x > from && eye.x < to) {
      ++inside;
      // About the middle of the tube, 0.45 m over rails at 5 m along x.
      EXPECT_LE(std::hypot(eye.y - 5 - watch.ground.room().lift, eye.z), watch.ground.room().tube - 0.4) << eye.x;
    } else {
      ++outside;
      EXPECT_GE(eye.y, watch.ground.height(eye.x, eye.z) + 0.29) << eye.x;
    }
    EXPECT_LT(glm::distance(eye, last), 0.5) << "without a leap, at " << eye.x;
    last = eye;
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 300);
}

TEST(CameraOnLand, chasing_looks_below_the_roofs_of_stations_that_scenery_shows) {
  for (const bool land : {true, false})
    for (const auto scenery : {world::Scenery::plain, world::Scenery::park}) {
      world::Document document = through_a_ridge();
      document.park = {};
      if (land) test::shape_land(document, [](double, double) { return 2; });
      const world::Entity station = document.track.segments[5];
      document.entities.put(station, world::Equipment{.kind = world::EquipmentKind::station});
      TunnelWatch watch(document, world::CameraMode::chase);
      watch.settings.look->scenery = scenery;
      ASSERT_TRUE(watch.ground.tunnels().empty());
      int below = 0, above_station = 0, elsewhere = 0;
      for (int i = 0; i < 10'000 && watch.cart().track_distance < 205; ++i) {
        watch.tick_on();
        const bool above = watch.rig.eye.position.y - 5 > 3;
        if (watch.cart().segment == station) (above ? above_station : below) += 1;
        else elsewhere += above;
      }
      EXPECT_EQ(above_station == 0, scenery != world::Scenery::plain) << land;
      EXPECT_EQ(below > 100, scenery != world::Scenery::plain) << land;
      EXPECT_GT(elsewhere, 100) << land;
    }
}

TEST(CameraOnLand, riding_goes_below_the_plane_and_through_the_hill) {
  world::Document document = through_a_ridge();
  for (const world::Entity e : document.track.knots) document.entities.get<world::Knot>(e).position.y = -7;
  TunnelWatch watch(document, world::CameraMode::ride);
  for (int i = 0; i < 400; ++i) watch.tick_on();
  EXPECT_NEAR(watch.rig.eye.position.y, -7 + 1.1, 0.2);
}

}  // namespace camera_ground_test
}  // namespace coaster::view
