#include "view/camera.h"

#include <gtest/gtest.h>

#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::view {
namespace camera_test {

const Viewport kViewport{137, 41, 913, 617};

world::Camera camera(glm::vec3 target, float yaw, float pitch, float distance) {
  return {target, yaw, pitch, distance};
}

TEST(camera, yaw_0_looks_along_minus_z_and_turns_about_y) {
  const View a = orbit_view(camera({3.3f, 7.1f, -2.9f}, 0, 0, 10), kViewport);
  EXPECT_LT(glm::distance(a.eye, glm::vec3(3.3f, 7.1f, 7.1f)), 1e-5f);
  const View b = orbit_view(camera({3.3f, 7.1f, -2.9f}, 90, 30, 10), kViewport);
  EXPECT_LT(glm::distance(b.eye, glm::vec3(3.3f + 10 * std::cos(M_PI / 6), 12.1f, -2.9f)), 1e-5f);
}

TEST(camera, the_target_is_in_the_middle_and_pixels_go_right_and_down) {
  const View v = orbit_view(camera({3.3f, 7.1f, -2.9f}, 0, 0, 10), kViewport);
  const auto middle = project(v, {3.3f, 7.1f, -2.9f}), right = project(v, {4.3f, 7.1f, -2.9f}),
             up = project(v, {3.3f, 8.1f, -2.9f});
  ASSERT_TRUE(middle && right && up);
  EXPECT_NEAR(middle->x, 137 + 913 / 2.0, 1e-2);
  EXPECT_NEAR(middle->y, 41 + 617 / 2.0, 1e-2);
  // A metre at 10 m covers height / (2 * 10 * tan(22.5 degrees)) pixels either way.
  const double metre = 617 / (20 * std::tan(M_PI / 8));
  EXPECT_NEAR(right->x - middle->x, metre, 1e-2);
  EXPECT_NEAR(middle->y - up->y, metre, 1e-2);
  EXPECT_GT(middle->z, -1);
  EXPECT_LT(middle->z, 1);
}

TEST(camera, what_is_behind_the_eye_is_not_projected) {
  const View v = orbit_view(camera({3.3f, 7.1f, -2.9f}, 0, 0, 10), kViewport);
  EXPECT_FALSE(project(v, {3.3f, 7.1f, 8.1f}));
  EXPECT_FALSE(project(v, v.eye));
}

TEST(camera, rays_go_through_what_is_projected) {
  for (const float yaw : {-130.0f, 17.0f, 201.0f})
    for (const float pitch : {-20.0f, 12.0f, 71.0f}) {
      const View v = orbit_view(camera({33.3f, 27.1f, -12.9f}, yaw, pitch, 47), kViewport);
      const glm::vec3 point(35.1f, 31.3f, -17.7f);
      const auto at = project(v, point);
      ASSERT_TRUE(at);
      const Ray ray = ray_through(v, glm::vec2(*at));
      EXPECT_NEAR(glm::length(ray.direction), 1, 1e-5);
      EXPECT_LT(glm::length(glm::cross(ray.direction, point - ray.origin)), 2e-3f);
      EXPECT_GT(glm::dot(ray.direction, point - ray.origin), 0);
    }
}

TEST(camera, the_eye_stays_over_the_ground_and_matrices_stay_finite) {
  for (const float pitch : {-89.0f, -40.0f, 0.0f, 89.0f})
    for (const float y : {-50.0f, 0.0f, 0.3f, 5.0f})
      for (const float distance : {0.0f, 1.0f, 300.0f}) {
        const View v = orbit_view(camera({1.3f, y, 2.7f}, 37, pitch, distance), kViewport);
        EXPECT_GE(v.eye.y, 0.3f);
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) EXPECT_TRUE(std::isfinite(v.view[i][j]) && std::isfinite(v.projection[i][j]));
        // Never upside down: the picture's up has no downward part.
        EXPECT_GE(v.view[1][1], -1e-4f);
      }
}

TEST(camera, a_viewport_without_area_counts_as_a_pixel) {
  const View v = orbit_view({}, {10, 10, 0, 0});
  EXPECT_TRUE(std::isfinite(v.projection[0][0]));
  EXPECT_TRUE(project(v, {0, 5, 0}).has_value());
}

TEST(camera, the_rider_looks_forward_from_over_the_rails) {
  sim::Pose pose;
  pose.position = {3.3, 7.1, -2.9};
  pose.frame = {{0.6, 0, 0.8}, {0, 1, 0}};
  const View v = view_of(ride_eye(pose, 45), kViewport);
  EXPECT_LT(glm::distance(v.eye, glm::vec3(3.3f, 8.2f, -2.9f)), 1e-5f);
  const auto ahead = project(v, v.eye + glm::vec3(6, 0, 8)), left = project(v, v.eye + glm::vec3(6.8f, 0, 7.4f));
  ASSERT_TRUE(ahead && left);
  EXPECT_NEAR(ahead->x, 137 + 913 / 2.0, 1e-2);
  EXPECT_LT(left->x, ahead->x);
}

TEST(camera, planes_and_verticals_are_met) {
  const Ray ray{{1.3f, 9.7f, 2.1f}, glm::normalize(glm::vec3(2, -3, 1))};
  const auto ground = meet_plane(ray, {100, 0, 100}, {0, 1, 0});
  ASSERT_TRUE(ground);
  EXPECT_LT(glm::distance(*ground, glm::vec3(1.3f + 2 * 9.7f / 3, 0, 2.1f + 9.7f / 3)), 1e-4f);
  EXPECT_FALSE(meet_plane(ray, {0, 20, 0}, {0, 1, 0}));  // behind
  EXPECT_FALSE(meet_plane({{0, 5, 0}, {1, 0, 0}}, {0, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(meet_plane({{0, 50, 0}, glm::normalize(glm::vec3(1, -1e-4f, 0))}, {0, 0, 0}, {0, 1, 0}));  // 500 km off
  const auto height = meet_vertical(ray, {1.3f + 4, 123, 2.1f + 2});
  ASSERT_TRUE(height);
  EXPECT_NEAR(*height, 9.7 - 6, 1e-4);
  EXPECT_FALSE(meet_vertical({{0, 5, 0}, {0, -1, 0}}, {1, 1, 1}));
  EXPECT_FALSE(meet_vertical(ray, {-5, 0, -5}));
}

world::Camera flat(world::Projection projection, float distance) {
  world::Camera c = camera({33.3f, 27.1f, -12.9f}, 77, 13, distance);  // yaw and pitch do not matter
  c.projection = projection;
  return c;
}
constexpr world::Projection kFlat[] = {world::Projection::front, world::Projection::side, world::Projection::top};

// By hand: front shows (x, y), side (-z, y), top (x, -z), in metres to the right and to the top.
glm::vec2 across(world::Projection projection, glm::vec3 p) {
  if (projection == world::Projection::front) return {p.x, p.y};
  if (projection == world::Projection::side) return {-p.z, p.y};
  return {p.x, -p.z};
}

TEST(camera, an_orthographic_view_shows_two_coordinates_at_the_scale_of_the_target) {
  for (const world::Projection projection : kFlat)
    for (const float distance : {3.0f, 47.0f, 900.0f}) {
      const View v = orbit_view(flat(projection, distance), kViewport);
      const float metre = 617 / (2 * distance * std::tan(static_cast<float>(M_PI) / 8));  // as in perspective, px
      for (const glm::vec3 off : {glm::vec3(0), glm::vec3(1.3f, -0.7f, 0.9f), glm::vec3(-400, 300, 5000),
                                  glm::vec3(700, -90, -6000)}) {  // before and behind the eye
        const glm::vec3 p = glm::vec3(33.3f, 27.1f, -12.9f) + off;
        const auto at = project(v, p);
        ASSERT_TRUE(at);
        const glm::vec2 by = across(projection, off) * metre;
        EXPECT_NEAR(at->x, 137 + 913 / 2.0 + by.x, 1e-2 + 1e-4 * std::abs(by.x));
        EXPECT_NEAR(at->y, 41 + 617 / 2.0 - by.y, 1e-2 + 1e-4 * std::abs(by.y));
        EXPECT_LE(std::abs(at->z), 1);
        // The line of sight through that pixel goes through the point, on either side of the eye.
        const Ray ray = ray_through(v, glm::vec2(*at));
        EXPECT_LT(glm::length(glm::cross(ray.direction, p - ray.origin)), 1e-3f * distance + 1e-5f * glm::length(off));
        const auto hit = meet_plane(ray, p, line_of_sight(v));
        ASSERT_TRUE(hit);
        EXPECT_LT(glm::distance(*hit, p), 1e-3f * distance + 1e-5f * glm::length(off));
      }
      EXPECT_FLOAT_EQ(metres_per_pixel(v, 1), 1 / metre);
      EXPECT_FLOAT_EQ(metres_per_pixel(v, 1000), 1 / metre);
    }
}

TEST(camera, leaving_an_orthographic_view_keeps_what_it_looks_at) {
  for (const world::Projection projection : kFlat) {
    const world::Camera from = flat(projection, 47), to = in_perspective(from);
    EXPECT_EQ(to.projection, world::Projection::perspective);
    const View a = orbit_view(from, kViewport), b = orbit_view(to, kViewport);
    EXPECT_GT(glm::dot(line_of_sight(a), line_of_sight(b)), std::cos(0.02f));
    EXPECT_GT(glm::dot(top_of(a), top_of(b)), std::cos(0.02f));
    EXPECT_LT(glm::distance(a.eye, b.eye), 1.0f);
  }
}

TEST(camera, framing_fills_an_orthographic_view_with_a_margin) {
  const glm::vec3 low(13.1f, 42.3f, -77.7f), high(91.9f, 61.1f, 7.3f);
  for (const world::Projection projection : kFlat) {
    const world::Camera c = frame_box(flat(projection, 1), low, high, kViewport);
    const View v = orbit_view(c, kViewport);
    const auto a = project(v, low), b = project(v, high);
    ASSERT_TRUE(a && b);
    const float wide = std::abs(a->x - b->x) / 913, tall = std::abs(a->y - b->y) / 617;
    EXPECT_NEAR(std::max(wide, tall), 1 / 1.1, 1e-3);
    EXPECT_NEAR((a->x + b->x) / 2, 137 + 913 / 2.0, 0.1);
    EXPECT_NEAR((a->y + b->y) / 2, 41 + 617 / 2.0, 0.1);
  }
}

// By brute force: a camera that shows all points with the margin, and none on a grid of smaller moves does.
TEST(camera, what_is_kept_in_view_moves_the_camera_as_little_as_possible) {
  const auto shows = [](const world::Camera& c, std::span<const glm::vec3> points) {
    const View v = orbit_view(c, kViewport);
    for (const glm::vec3 p : points) {
      const auto at = project(v, p);
      if (!at) return false;
      const glm::vec2 off = glm::abs(glm::vec2(*at) - glm::vec2(137 + 913 / 2.0f, 41 + 617 / 2.0f));
      if (off.x > 913 / 2.2f + 0.5f || off.y > 617 / 2.2f + 0.5f) return false;
    }
    return true;
  };
  for (const world::Projection projection : {world::Projection::perspective, kFlat[0], kFlat[1], kFlat[2]}) {
    world::Camera from = flat(projection, 60);
    from.yaw_deg = 31, from.pitch_deg = 22;
    const glm::vec3 here[] = {from.target, from.target + glm::vec3(3, 4, 5)};
    EXPECT_EQ(kept_in_view(from, here, kViewport, kViewport), from) << "all of it shows";
    for (const glm::vec3 off : {glm::vec3(70, 3, -60), glm::vec3(-60, 40, 25), glm::vec3(39, 50, -66)}) {
      const glm::vec3 points[] = {from.target + off, from.target + 0.9f * off + glm::vec3(1, 2, 3)};
      const world::Camera to = kept_in_view(from, points, kViewport, kViewport);
      EXPECT_TRUE(shows(to, points));
      EXPECT_EQ(to.yaw_deg, from.yaw_deg);
      EXPECT_EQ(to.distance, from.distance) << "two near points need no more room";
      const glm::vec3 moved = to.target - from.target;
      for (const float part : {0.0f, 0.5f, 0.9f, 0.98f}) {
        world::Camera less = from;
        less.target += part * moved;
        EXPECT_FALSE(shows(less, points)) << part;
      }
    }
    const glm::vec3 apart[] = {from.target + glm::vec3(200, 90, 170), from.target - glm::vec3(210, 20, 190)};
    const world::Camera back = kept_in_view(from, apart, kViewport, kViewport);
    EXPECT_TRUE(shows(back, apart));
    EXPECT_GT(back.distance, from.distance);
  }
}

// Both points end at a tenth of the free part's width from its nearer side, or within it.
TEST(camera, what_a_card_would_cover_is_kept_beside_it) {
  const Viewport right{137 + 400, 41, 913 - 400, 617}, lower{137, 41 + 300, 913, 617 - 300};
  for (const world::Projection projection : {world::Projection::perspective, kFlat[0]}) {
    world::Camera from = flat(projection, 60);
    from.yaw_deg = 31, from.pitch_deg = 22;
    for (const Viewport& free : {right, lower})
      for (const float apart : {3.0f, 150.0f}) {
        const glm::vec3 points[] = {from.target + glm::vec3(-30, 9, 4), from.target + glm::vec3(-30 + apart, 12, 7)};
        const View v = orbit_view(kept_in_view(from, points, kViewport, free), kViewport);
        for (const glm::vec3 p : points) {
          const auto at = project(v, p);
          ASSERT_TRUE(at);
          EXPECT_LT(std::abs(at->x - free.x - free.width / 2), free.width / 2.2f + 0.5f);
          EXPECT_LT(std::abs(at->y - free.y - free.height / 2), free.height / 2.2f + 0.5f);
        }
      }
  }
}

// Every corner inside; in the fuller direction the margins on both sides are the same tenth: nothing is cut, no camera
// is nearer.
TEST(camera, framing_fills_the_viewport_with_a_margin) {
  for (const Viewport viewport : {kViewport, Viewport{0, 0, 400, 900}, Viewport{50, 60, 1600, 300}})
    for (const float yaw : {-100.0f, 35.0f, 170.0f})
      for (const float pitch : {3.0f, 25.0f, 80.0f}) {
        const glm::vec3 low(13.1f, 42.3f, -77.7f), high(91.9f, 61.1f, 7.3f);
        const world::Camera c = frame_box(camera({}, yaw, pitch, 1), low, high, viewport);
        EXPECT_EQ(c.yaw_deg, yaw);
        EXPECT_EQ(c.pitch_deg, pitch);
        const View v = orbit_view(c, viewport);
        glm::vec2 least(9), most(-9);  // of the viewport, whose sides are at -1 and 1
        for (int i = 0; i < 8; ++i) {
          const auto at = project(v, {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
          ASSERT_TRUE(at);
          const glm::vec2 place =
              (glm::vec2(*at) - glm::vec2(viewport.x, viewport.y)) / glm::vec2(viewport.width, viewport.height) * 2.0f -
              1.0f;
          least = glm::min(least, place), most = glm::max(most, place);
        }
        const glm::vec2 size = most - least;
        const int fuller = size.x > size.y ? 0 : 1;
        EXPECT_NEAR(most[fuller], 1 / 1.1, 1e-3);
        EXPECT_NEAR(least[fuller], -1 / 1.1, 1e-3);
        EXPECT_LT(most[1 - fuller], 1);
        EXPECT_GT(least[1 - fuller], -1);
      }
}

TEST(camera, framing_all_shows_every_place_of_the_track) {
  for (const world::Document& d : {test::sample_document(), test::ring_document(8, 21.3),
                                   test::circle_document(7.5, {3, 30, 2}, {1, 0, 0.2}, 8)}) {
    const View v = orbit_view(frame_all({}, d, kViewport), kViewport);
    for (const world::Entity e : d.track.segments)
      for (int i = 0; i <= 50; ++i) {
        const auto at = project(v, glm::vec3(curve::point(world::cubic_of(d, e), i / 50.0)));
        ASSERT_TRUE(at && kViewport.contains(glm::vec2(*at)));
      }
  }
}

TEST(camera, framing_nothing_shows_forty_metres_about_the_origin) {
  const View v = orbit_view(frame_all({}, {}, kViewport), kViewport);
  for (const glm::vec3 p : {glm::vec3(-20, 0, -20), glm::vec3(20, 0, 20), glm::vec3(20, 0, -20)}) {
    const auto at = project(v, p);
    ASSERT_TRUE(at && kViewport.contains(glm::vec2(*at)));
  }
}

TEST(camera, framing_an_entity_shows_it) {
  world::Document d = test::sample_document();
  for (const world::Entity e : {d.track.knots[2], d.track.segments[1], d.entities.pool<world::Train>().entities()[0]}) {
    const world::Camera c = frame_entity({}, d, e, kViewport);
    EXPECT_LT(c.distance, frame_all({}, d, kViewport).distance);
  }
  const View v = orbit_view(frame_entity({}, d, d.track.knots[2], kViewport), kViewport);
  const auto at = project(v, world::knot(d, d.track.knots[2]).position);
  ASSERT_TRUE(at && kViewport.contains(glm::vec2(*at)));
}

}  // namespace camera_test
}  // namespace coaster::view
