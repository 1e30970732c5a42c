// A ride followed by an eye, tick by tick.
#pragma once

#include <gtest/gtest.h>

#include "exchange/formats.h"
#include "sim/tracks.h"
#include "view/camera_rig.h"

namespace coaster::view {

inline world::Document sample_track(const std::string& name) {
  base::Files files;
  auto loaded = exchange::load_track(files, std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  EXPECT_TRUE(loaded) << name;
  return loaded ? std::move(loaded->document) : world::Document{};
}

inline world::Document with_cart(world::Document d, double speed, int cars = 1) {
  const world::Entity cart = world::add_cart(d, d.track.segments.front(), 0.1);
  d.entities.get<world::Train>(cart).cars = cars;
  d.start_speed = speed;
  return d;
}

// A ride and the eye that follows it.
struct Watch {
  world::Document document;
  world::Settings settings;
  sim::DerivedTrack derived;
  world::Motion motion;
  sim::RideCache cache;
  CameraRig rig;

  Watch(world::Document d, world::CameraMode mode) : document(std::move(d)) {
    settings.camera_mode = mode;
    sim::derive(document, settings, {}, derived);
    sim::reset(document, derived, motion);
    motion.state = world::RideState::running;
    look(0);
  }
  CameraSubject watched() const { return {document, derived, motion, settings}; }
  void look(int ticks) { follow(rig, watched(), ticks); }
  void tick() {
    sim::step(document, derived, {}, 1, cache, motion);
    look(1);
  }
  const world::TrainMotion& cart() const { return motion.carts.items()[0]; }
  sim::Pose pose() const { return sim::pose(derived, cart(), settings.frames); }
};

inline void expect_sound(const Eye& eye) {
  const View v = view_of(eye, {0, 0, 640, 360});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) ASSERT_TRUE(std::isfinite(v.view[i][j]) && std::isfinite(v.projection[i][j]));
  ASSERT_NEAR(glm::length(eye.forward), 1, 1e-6);
  ASSERT_GE(eye.position.y, kLowestEye - 1e-6);
}

inline double right_height(const Eye& eye) { return glm::normalize(glm::cross(eye.forward, eye.up)).y; }

}  // namespace coaster::view
