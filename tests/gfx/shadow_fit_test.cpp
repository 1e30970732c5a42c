// The area of shadow maps: it contains all shadow casters, and does not creep with the eye.
#include "gfx/sun_shadows.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "sim/tracks.h"

namespace coaster::gfx {
namespace shadow_fit_test {

const glm::vec3 kSun = glm::normalize(glm::vec3(0.42f, 0.78f, 0.46f));

glm::vec3 map_place(const glm::mat4& to_map, glm::vec3 at) { return glm::vec3(to_map * glm::vec4(at, 1)); }

// Of -1 to 1.
float random_part() { return static_cast<float>(*rc::gen::inRange(-10'000, 10'001)) / 10'000; }
glm::vec3 random_vector(float size) { return size * glm::vec3(random_part(), random_part(), random_part()); }

RC_GTEST_PROP(shadow_fit, axes_are_unit_perpendicular_and_right_handed, ()) {
  glm::vec3 sun = random_vector(1);
  RC_PRE(glm::length(sun) > 0.1f);
  const SunAxes axes(sun);
  for (const auto& [a, b] : {std::pair{axes.across, axes.over}, {axes.over, axes.sun}, {axes.sun, axes.across}}) {
    RC_ASSERT(std::abs(glm::dot(a, b)) < 1e-5f);
    RC_ASSERT(std::abs(glm::length(a) - 1) < 1e-5f);
  }
  RC_ASSERT(glm::dot(glm::cross(axes.across, axes.over), axes.sun) > 0.999f);
  const glm::vec3 at = random_vector(300);
  RC_ASSERT(glm::distance(axes.world(axes.of(at)), at) < 1e-3f);
}

TEST(shadow_fit, axes_exist_under_a_sun_overhead) {
  for (const glm::vec3 sun : {glm::vec3(0, 1, 0), glm::vec3(0, 0.3f, 0)}) {
    const SunAxes axes(sun);
    EXPECT_NEAR(glm::length(axes.across), 1, 1e-6f);
    EXPECT_NEAR(glm::length(axes.over), 1, 1e-6f);
  }
}

TEST(shadow_fit, places_on_one_ray_of_light_share_a_place_in_the_map_and_the_nearer_to_the_sun_is_less_deep) {
  const SunAxes axes(kSun);
  LightBox box;
  for (const glm::vec3 at : {glm::vec3(-30, 0, 12), glm::vec3(44, 31, -20)}) box.add(axes.of(at), 3);
  const glm::mat4 to_map = map_of(axes, fit_shadow(axes, box, 128, {0, 10, 80}, {0, 0, -1}));
  const glm::vec3 ground(7, 0, 3), a = map_place(to_map, ground), b = map_place(to_map, ground + 25.0f * kSun);
  EXPECT_NEAR(a.x, b.x, 1e-5f);
  EXPECT_NEAR(a.y, b.y, 1e-5f);
  EXPECT_GT(a.z, b.z + 0.1f);
  // Clip space is the same map from -1 to 1.
  const glm::vec3 c = map_place(clip_of(axes, fit_shadow(axes, box, 128, {0, 10, 80}, {0, 0, -1})), ground);
  EXPECT_NEAR(glm::distance(0.5f * c + 0.5f, a), 0, 1e-5f);
}

TEST(shadow_fit, the_whole_track_and_its_feet_are_in_the_map_while_the_eye_is_near_or_far) {
  const sim::DerivedTrack derived = test::derived_of(test::ring_document(9, 17.3));
  const SunAxes axes(kSun);
  const LightBox box = TrackBox().update(axes, derived);
  for (const float away : {5.0f, 90.0f, 900.0f}) {
    const ShadowFit fit = fit_shadow(axes, box, 128, {away, 10, away}, {-0.7f, 0, -0.7f});
    EXPECT_EQ(fit.side, 128);
    const glm::mat4 to_map = map_of(axes, fit);
    for (const world::Entity e : derived.order)
      for (const glm::vec3 p : test::polyline_of(derived.shape(e)))
        for (const glm::vec3 at : {p, glm::vec3(p.x, 0, p.z)}) {
          const glm::vec3 place = map_place(to_map, at);
          for (int i = 0; i < 3; ++i) EXPECT_TRUE(place[i] > 0 && place[i] < 1) << place[i];
        }
  }
}

TEST(shadow_fit, nothing_throws_no_shadow) {
  const SunAxes axes(kSun);
  EXPECT_TRUE(TrackBox().update(axes, sim::DerivedTrack{}).empty());
  EXPECT_TRUE(light_box(axes, std::span<const sim::Pose>{}).empty());
  EXPECT_EQ(fit_shadow(axes, LightBox{}, 128, {}, {0, 0, -1}).side, 0);
}

TEST(shadow_fit, the_box_of_a_track_follows_its_changes_and_looks_only_near_them) {
  constexpr std::size_t kSegments = 1000;
  world::Document document = test::ring_document(kSegments, 4000);
  world::Settings settings;
  settings.evaluation->steps = 1;
  sim::DerivedTrack derived;
  TrackBox kept;
  const auto expect_fresh = [&](const SunAxes& axes, std::size_t most) {
    world::settle_joints(document);
    sim::derive(document, settings, {}, derived);
    const LightBox box = kept.update(axes, derived), fresh = TrackBox().update(axes, derived);
    EXPECT_EQ(box.low, fresh.low);
    EXPECT_EQ(box.high, fresh.high);
    EXPECT_LE(kept.looked_at(), most);
    EXPECT_EQ(kept.update(axes, derived).low, fresh.low);
    EXPECT_EQ(kept.looked_at(), 0u);
    return box;
  };
  const SunAxes axes(kSun), other({0.1f, 1, 0});
  const LightBox ring = expect_fresh(axes, kSegments);
  glm::vec3& place = document.entities.get<world::Knot>(document.track.knots[500]).position;
  for (const float aside : {9000.0f, -9000.0f}) {  // widens the box, and narrows it again
    place.y += aside;
    const LightBox box = expect_fresh(axes, 128);
    EXPECT_EQ(box.high == ring.high, aside < 0);
  }
  expect_fresh(other, kSegments);
  world::remove_knot(document, document.track.knots[3]);
  expect_fresh(other, kSegments);
}

TEST(shadow_fit, a_large_track_has_its_map_about_the_eye_and_all_of_it_from_far_away) {
  const sim::DerivedTrack derived = test::derived_of(test::ring_document(60, 900));
  const SunAxes axes(kSun);
  const LightBox box = TrackBox().update(axes, derived);
  const glm::vec3 on_track = test::polyline_of(derived.shape(derived.order[11])).front();
  const ShadowFit near = fit_shadow(axes, box, 128, on_track, {1, 0, 0});
  EXPECT_EQ(near.side, 128);
  const glm::vec3 place = map_place(map_of(axes, near), on_track);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(place[i] > 0 && place[i] < 1) << place[i];
  const ShadowFit far = fit_shadow(axes, box, 128, {0, 1500, 0}, {0, -1, 0});
  EXPECT_GE(far.side, 1800);
  for (const world::Entity e : derived.order) {
    const glm::vec3 there = map_place(map_of(axes, far), test::polyline_of(derived.shape(e)).front());
    EXPECT_TRUE(there.x > 0 && there.x < 1 && there.y > 0 && there.y < 1);
  }
}

// The map of a large track moves by whole eighths of itself, so by whole texels, and seldom.
RC_GTEST_PROP(shadow_fit, texels_stay_where_they_are_while_the_eye_moves, ()) {
  const SunAxes axes(kSun);
  LightBox box;
  for (const glm::vec3 corner :
       {glm::vec3(-3000, 0, -3000), glm::vec3(3000, 0, -3000), glm::vec3(-3000, 60, 3000), glm::vec3(3000, 60, 3000)})
    box.add(axes.of(corner), 3);
  const glm::vec3 eye = random_vector(800) * glm::vec3(1, 0, 1) + glm::vec3(0, 12, 0),
                  step = random_vector(30) * glm::vec3(1, 0, 1);
  const ShadowFit a = fit_shadow(axes, box, 128, eye, {0, 0, -1}),
                  b = fit_shadow(axes, box, 128, eye + step, {0, 0, -1});
  RC_ASSERT(a.side == b.side);
  RC_ASSERT(a.depth == b.depth);
  const glm::vec3 moved = (b.middle - a.middle) / (a.side / 8);
  RC_ASSERT(moved.x == std::round(moved.x));
  RC_ASSERT(moved.y == std::round(moved.y));
  RC_ASSERT(moved.z == 0);
}

}  // namespace shadow_fit_test
}  // namespace coaster::gfx
