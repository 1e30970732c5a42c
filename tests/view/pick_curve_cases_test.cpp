// Picking in special cases: crossings on screen, joints, points, views of nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/tracks.h"
#include "view/pick.h"

namespace coaster::view {
namespace pick_curve_cases_test {

const Viewport kViewport{57, 31, 640, 480};

// A straight across the picture, and behind (or before) it an upright one, in one track.
world::Document crossing(bool upright_first) {
  world::Document d;
  const auto knot = [&](glm::vec3 p, glm::vec3 along) { world::append_knot(d, test::skew_knot(p, along, 6, 6)); };
  const glm::vec3 left{-20, 15, 1}, right{20, 15, 1}, low{0.3f, 2, -9}, high{0.3f, 40, -9};
  if (upright_first)
    knot(low, {0, 1, 0}), knot(high, {0, 1, 0}), knot({-60, 50, -4}, {0, 0, 1}), knot(left, {1, 0, 0}),
        knot(right, {1, 0, 0});
  else
    knot(left, {1, 0, 0}), knot(right, {1, 0, 0}), knot({60, 50, -4}, {-1, 0, 0}), knot(high, {0, -1, 0}),
        knot(low, {0, -1, 0});
  return d;
}

TEST(pick_curve_cases, where_the_track_crosses_itself_on_screen_the_front_one_is_picked) {
  for (const bool upright_first : {false, true}) {
    const world::Document d = crossing(upright_first);
    const sim::DerivedTrack derived = test::derived_of(d);
    const world::Entity across = d.track.segments[upright_first ? 3 : 0],
                        upright = d.track.segments[upright_first ? 0 : 3];
    for (const float yaw : {0.0f, 180.0f}) {  // from the other side the upright one is in front
      const View view = orbit_view({{0.3f, 15, -4}, yaw, 0, 60}, kViewport);
      const glm::vec2 crossing(*project(view, {0.3f, 15, 1})), behind(*project(view, {0.3f, 15, -9}));
      const world::Entity front = yaw == 0 ? across : upright, back = yaw == 0 ? upright : across;
      const glm::vec2 at(behind.x, crossing.y);
      const glm::vec2 off =
          yaw == 0 ? glm::vec2(0, 1) : glm::vec2(1, 0);  // away from the front one, along the one behind
      EXPECT_EQ(pick_curve(derived, view, at, 8)->entity, front);
      EXPECT_EQ(pick_curve(derived, view, at + 0.8f * off, 8)->entity, front);
      EXPECT_EQ(pick_curve(derived, view, at + 1.3f * off, 8)->entity, back);
      EXPECT_EQ(pick_curve(derived, view, at - 1.3f * off, 8)->entity, back);
    }
  }
}

TEST(pick_curve_cases, a_joint_belongs_to_the_segment_that_it_ends) {
  const world::Document d = test::ring_document(12, 31);
  const sim::DerivedTrack derived = test::derived_of(d);
  const View view = orbit_view(frame_all({}, d, kViewport), kViewport);
  for (std::size_t i = 0; i < 12; ++i) {
    const glm::vec3 joint = world::knot(d, d.track.knots[i]).position;
    const auto found = pick_curve(derived, view, glm::vec2(*project(view, joint)), 8);
    ASSERT_TRUE(found);
    EXPECT_LT(glm::distance(found->position, joint), 2e-3f);
    const bool at_start = found->t < 0.5;
    EXPECT_EQ(found->entity, d.track.segments[at_start ? i : (i + 11) % 12]);
  }
  // Seen square on, the pixel is exactly beside the joint.
  const world::Document straight = test::straight_document({-20, 5, 1}, {20, 5, 1}, 2);
  const sim::DerivedTrack of_straight = test::derived_of(straight);
  const View square = orbit_view({{0, 5, 1}, 0, 0, 60}, kViewport);
  for (const float off : {0.0f, 3.0f, -7.0f}) {
    const auto found = pick_curve(of_straight, square, glm::vec2(57 + 320, 31 + 240 + off), 8);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->entity, straight.track.segments[0]);
    EXPECT_NEAR(found->t, 1, 1e-6);
  }
}

TEST(pick_curve_cases, without_segments_or_an_eye_nothing_is_found) {
  sim::DerivedTrack nothing;
  const View view = orbit_view({{0, 5, 1}, 0, 0, 60}, kViewport);
  EXPECT_FALSE(pick_curve(nothing, view, {100, 100}, 8));
  EXPECT_FALSE(pick_curve_of_all(nothing, view, {100, 100}, 8));
  const world::Document d = test::ring_document(12, 31);
  const sim::DerivedTrack derived = test::derived_of(d);
  for (const View& blind : {View{}, View{glm::mat4(0), glm::mat4(0), {0, 0, 0}, kViewport},
                            View{glm::mat4(1), glm::mat4(NAN), {0, 0, 0}, kViewport}}) {
    EXPECT_FALSE(pick_curve(derived, blind, {100, 100}, 8));
    EXPECT_FALSE(pick_curve_of_all(derived, blind, {100, 100}, 8));
    EXPECT_FALSE(pick_segment(derived, blind, {100, 100}, derived.order[0]));
  }
  EXPECT_FALSE(pick_curve(derived, view, {NAN, 100}, 8));
}

TEST(pick_curve_cases, straights_seen_end_on_and_places_without_extent_are_places_too) {
  const world::Document d = test::straight_document({1, 5, 30}, {1, 5, -30}, 3);
  const sim::DerivedTrack derived = test::derived_of(d);
  const View along = orbit_view({{1, 5, 0}, 0, 0, 60}, kViewport);  // all of it is one point
  const auto found = pick_curve(derived, along, {57 + 320 + 2, 31 + 240 + 3}, 8);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->t >= 0 && found->t <= 1);  // any will do
  EXPECT_LT(glm::distance(glm::vec2(found->position), glm::vec2(1, 5)), 1e-4f);

  world::Document crumpled;
  for (int i = 0; i < 4; ++i) world::append_knot(crumpled, test::skew_knot({7, 8, 9}, {1, 0, 0}, 0.01f, 0.01f));
  const sim::DerivedTrack of_crumpled = test::derived_of(crumpled);
  const View view = orbit_view({{7, 8, 9}, 30, 20, 40}, kViewport);
  const auto spot = pick_curve(of_crumpled, view, {57 + 320 + 4, 31 + 240}, 8);
  ASSERT_TRUE(spot);
  EXPECT_LT(glm::distance(spot->position, glm::vec3(7, 8, 9)), 0.02f);
}

}  // namespace pick_curve_cases_test
}  // namespace coaster::view
