// The eye behind a train that a test puts anywhere, beside a straight bar of track: where it goes is a closed form.
#include <gtest/gtest.h>

#include "sim/shape/rails.h"
#include "sim/tracks.h"
#include "view/camera_rig.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace camera_chase_test {

using glm::dvec3;

constexpr double kDistance = 20;  // m, of the eye

// A train whose middle is there, and a document with other track.
struct Chased {
  world::Document document;
  world::Settings settings;
  sim::DerivedTrack derived;
  world::Motion motion;
  world::TrainMotion cart;
  RiddenTrain ridden{{}, cart, {}, {}, 0};
  CameraRig rig;

  explicit Chased(dvec3 middle, dvec3 forward = {1, 0, 0}, dvec3 up = {0, 1, 0}) {
    ridden.middle.position = middle, ridden.middle.frame = {forward, up};
    settings.feel->chase_distance = kDistance;
  }
  void put_bar(dvec3 from, dvec3 to) {
    document = test::straight_document(glm::vec3(from), glm::vec3(to));
    document.heartline = 0;
    sim::derive(document, settings, {}, derived);
  }
  CameraSubject watched() const { return {document, derived, motion, settings}; }
  void settle() {
    rig.heading.settle(ridden.middle.frame);
    settle_chase(rig, watched(), ridden);
  }
  Eye eye(double dt = 0) { return chase(rig, watched(), ridden, dt); }
  dvec3 looked_at() const { return ridden.middle.position + dvec3(0, 0.9, 0); }
};

// The eye without track: `up` radians above the horizon and `aside` to the left of a train that goes along x.
dvec3 expected(dvec3 looked_at, double distance, double up, double aside) {
  return looked_at + distance * dvec3(-std::cos(up) * std::cos(aside), std::sin(up), -std::cos(up) * std::sin(aside));
}

TEST(camera_chase, the_eye_is_behind_above_and_beside_the_train) {
  Chased level({5, 40, -7});
  level.settle();
  EXPECT_LT(glm::distance(level.eye().position, expected({5, 40.9, -7}, kDistance, 0.30, 0.26)), 1e-9);
  EXPECT_LT(glm::distance(level.eye().forward, glm::normalize(level.looked_at() - level.eye().position)), 1e-9);
  Chased longer({5, 40, -7});
  longer.ridden.length = 15;
  longer.settle();
  EXPECT_LT(glm::distance(longer.eye().position, expected({5, 40.9, -7}, kDistance + 9, 0.30, 0.26)), 1e-9);
  // Lower uphill by half the slope, higher downhill, within limits.
  for (const auto& [slope, up] : {std::pair(0.2, 0.2), {-0.6, 0.6}, {0.9, 0.10}, {-1.4, 0.95}}) {
    Chased sloped({5, 40, -7}, {std::cos(slope), std::sin(slope), 0}, {-std::sin(slope), std::cos(slope), 0});
    sloped.settle();
    const double aside = 0.26 + 0.3 * std::max(0.0, 0.4 - std::cos(slope));
    EXPECT_LT(glm::distance(sloped.eye().position, expected({5, 40.9, -7}, kDistance, up, aside)), 1e-9) << slope;
  }
  // Farther to the side while it is upside down.
  for (const auto& [up_y, aside] : {std::pair(0.5, 0.26), {0.0, 0.26 + 0.3 * 0.4}, {-1.0, 0.26 + 0.3 * 1.4}}) {
    Chased turned({5, 40, -7}, {1, 0, 0}, {0, up_y, std::sqrt(1 - up_y * up_y)});
    turned.settle();
    EXPECT_LT(glm::distance(turned.eye().position, expected({5, 40.9, -7}, kDistance, 0.30, aside)), 1e-9) << up_y;
  }
}

TEST(camera_chase, the_eye_stays_above_the_ground) {
  Chased low({5, -12, -7});
  low.settle();
  EXPECT_EQ(low.eye().position.y, 1.2);
}

// A bar across the line of sight, `off` metres below its part `part`: the eye rises until the line is 1.3 m above the
// bar, which moves the eye by 1 / (1 - part) of what is missing. The eye itself keeps 2.4 m.
TEST(camera_chase, the_eye_goes_aside_as_far_as_a_clear_view_takes) {
  for (const auto& [part, clear] : {std::pair(0.0, 2.4), {0.25, 1.3}, {0.5, 1.3}})
    for (const double off : {0.4, 0.9, 1.29, 1.31, 2.3, 2.41}) {
      SCOPED_TRACE(testing::Message() << part << ' ' << off);
      Chased watch({5, 40, -7});
      const dvec3 to = watch.looked_at(), from = expected(to, kDistance, 0.30, 0.26), along = (to - from) / kDistance;
      const dvec3 across = glm::normalize(glm::cross(along, dvec3(0, 1, 0))), over = glm::cross(across, along);
      const dvec3 middle = glm::mix(from, to, part) - off * over;
      watch.put_bar(middle - 30.0 * across, middle + 30.0 * across);
      ASSERT_NEAR(nearest_track(watch.derived, glm::mix(from, to, part), 5).distance, off, 1e-5);
      watch.settle();
      const dvec3 wanted = std::max(0.0, clear - off) / (1 - part) * over;
      EXPECT_LT(glm::distance(watch.rig.aside.value, wanted), 1e-4);
      EXPECT_LT(glm::distance(watch.eye().position, from + wanted), 1e-4);
      // And it stays there.
      for (int i = 0; i < 240; ++i) watch.eye(world::kTick);
      EXPECT_LT(glm::distance(watch.rig.aside.value, wanted), 1e-4);
    }
}

TEST(camera_chase, the_nearest_track_is_that_of_a_fine_search) {
  const world::Document ring = test::ring_document(9, 30.3);
  const sim::DerivedTrack derived = test::derived_of(ring);
  std::vector<dvec3> fine;
  for (const world::Entity e : derived.order)
    for (int i = 0; i < 4000; ++i) fine.push_back(sim::rails_point(derived.shape(e), i / 4000.0));
  for (const dvec3 from :
       {dvec3(13, 21, -8), dvec3(40, 20, -8), dvec3(45, 26, 3), dvec3(-20, 18, 5), dvec3(13, 2, 25)}) {
    double least = 1e9;
    for (const dvec3& p : fine) least = std::min(least, glm::distance(p, from));
    for (const double reach : {least + 0.05, least + 30}) {
      const NearestTrack near = nearest_track(derived, from, reach);
      EXPECT_NEAR(near.distance, least, 0.01);
      EXPECT_NEAR(glm::distance(near.point, from), near.distance, 1e-9);
    }
    EXPECT_FALSE(std::isfinite(nearest_track(derived, from, least - 0.05).distance));
  }
}

}  // namespace camera_chase_test
}  // namespace coaster::view
