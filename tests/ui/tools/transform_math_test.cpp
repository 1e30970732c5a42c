// The geometry of transforms, and selecting by clicks and boxes.
#include "ui/tools/transform_tool.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "edit/perform/apply.h"
#include "ui/tools/selecting.h"
#include "world/appearance_settings.h"
#include "world/sample_documents.h"
#include "world/selection.h"

namespace coaster::ui {
namespace transform_math_test {

constexpr view::Viewport kViewport{0, 0, 800, 600};
const view::View kView = view::orbit_view({{0, 5, 0}, 25, 20, 60}, kViewport);

glm::vec2 pixel_of(glm::vec3 place) {
  const auto at = view::project(kView, place);
  EXPECT_TRUE(at);
  return {at->x, at->y};
}

TEST(transform_math, the_cursor_over_a_place_on_the_axis_finds_that_place) {
  const glm::vec3 pivot(1, 4, -2);
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 place = pivot;
    place[axis] += 7.5f;
    const auto hit = meet(kView, pixel_of(place), pivot, {Constraint::Kind::axis, axis});
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::length(*hit - glm::dvec3(place)), 1e-2) << axis;
    glm::vec3 in_plane = pivot;
    in_plane[(axis + 1) % 3] += 3, in_plane[(axis + 2) % 3] -= 4;
    const auto in = meet(kView, pixel_of(in_plane), pivot, {Constraint::Kind::plane, axis});
    ASSERT_TRUE(in);
    EXPECT_LT(glm::length(*in - glm::dvec3(in_plane)), 1e-2) << axis;
  }
}

TEST(transform_math, a_turn_of_the_cursor_is_that_turn_about_the_axis) {
  // Two places that a rotation of 40 degrees about the vertical takes into each other, seen from above.
  const view::View above = view::orbit_view({{0, 0, 0}, 0, 89, 60}, kViewport);
  const auto at = [&](double degrees) {
    const double a = degrees * 3.14159265358979 / 180;
    const auto p = view::project(above, {10 * std::cos(a), 0, -10 * std::sin(a)});
    return glm::vec2(p->x, p->y);
  };
  EXPECT_NEAR(turned_angle(above, at(10), at(50), glm::vec3(0), {0, 1, 0}) * 180 / 3.14159265358979, 40, 0.5);
  EXPECT_NEAR(turned_angle(above, at(10), at(50), glm::vec3(0), {0, -1, 0}) * 180 / 3.14159265358979, -40, 0.5);
}

TEST(transform_math, snapping_leaves_alone_what_the_constraint_does_not_allow) {
  const world::Document document = test::sample_document();
  world::Settings settings;
  settings.snapping.step = 2;
  const SnapScene scene{document, settings, kView, {400, 300}};
  const glm::dvec3 start(0.3, 0.4, 0.5), wanted(3.2, 4.9, -7.2);
  EXPECT_EQ(snapped(scene, world::SnapTo::grid, wanted, start, {}), glm::dvec3(4, 4, -8));
  EXPECT_EQ(snapped(scene, world::SnapTo::grid, wanted, start, {Constraint::Kind::axis, 1}), glm::dvec3(0.3, 4, 0.5));
  EXPECT_EQ(snapped(scene, world::SnapTo::ground, wanted, start, {Constraint::Kind::plane, 0}),
            glm::dvec3(0.3, 0, -7.2));
  EXPECT_EQ(snapped(scene, world::SnapTo::off, wanted, start, {}), wanted);
}

TEST(transform_math, snapping_to_knots_takes_the_one_under_the_cursor_but_no_selected_one) {
  world::Document document;
  for (const glm::vec3 place : {glm::vec3(0, 2, 0), glm::vec3(6, 3, 1), glm::vec3(-7, 5, 2)})
    world::append_knot(document, test::skew_knot(place, {1, 0, 0}, 2, 2));
  world::Settings settings;
  settings.selected = document.track.knots[0];
  const glm::vec2 over = pixel_of({6, 3, 1});
  EXPECT_EQ(
      snapped({document, settings, kView, over + glm::vec2(5, 5)}, world::SnapTo::knots, {9, 9, 9}, {0, 2, 0}, {}),
      glm::dvec3(6, 3, 1));
  EXPECT_EQ(
      snapped({document, settings, kView, over + glm::vec2(40, 5)}, world::SnapTo::knots, {9, 9, 9}, {0, 2, 0}, {}),
      glm::dvec3(9, 9, 9));
  EXPECT_EQ(snapped({document, settings, kView, pixel_of({0, 2, 0})}, world::SnapTo::knots, {9, 9, 9}, {0, 2, 0}, {}),
            glm::dvec3(9, 9, 9));
}

TEST(transform_math, snapping_to_knots_reaches_twelve_pixels_at_scale_1) {
  world::Document document;
  world::append_knot(document, test::skew_knot({6, 3, 1}, {1, 0, 0}, 2, 2));
  world::Settings settings;
  const glm::dvec3 start(0, 2, 0), wanted(9, 9, 9);
  for (const float scale : {1.0f, 1.5f}) {
    settings.look->ui_scale = scale;
    for (const glm::vec2 way : {glm::vec2(1, 0), glm::vec2(-0.6f, 0.8f), glm::vec2(0, -1)})
      for (const auto& [reach, place] : {std::pair(11.8f, glm::dvec3(6, 3, 1)), {12.2f, wanted}}) {
        const SnapScene scene{document, settings, kView, pixel_of({6, 3, 1}) + scale * reach * way};
        EXPECT_EQ(snapped(scene, world::SnapTo::knots, wanted, start, {}), place) << scale << " " << reach;
      }
  }
}

TEST(selecting, up_to_takes_the_shorter_way_round_a_closed_track) {
  edit::Session session = edit::make_session({});
  session.document = test::sample_document();
  const std::vector<world::Entity> k = session.document.track.knots;
  session.settings.selected = k[4];
  base::Files files;
  EXPECT_TRUE(edit::apply(session, files, up_to(session, k[1])));
  EXPECT_EQ(world::selected_knots(session.document, session.settings).size(), 4u);  // an open track has one way
  EXPECT_EQ(session.settings.selected, k[1]);
  world::set_closed(session.document, true);
  session.settings.also.clear();
  session.settings.selected = k[4];
  EXPECT_TRUE(edit::apply(session, files, up_to(session, k[1])));
  std::vector<world::Entity> chosen = world::selected_knots(session.document, session.settings),
                             wanted{k[4], k[0], k[1]};
  EXPECT_EQ(chosen.back(), k[1]);
  std::sort(chosen.begin(), chosen.end()), std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(chosen, wanted);
}

}  // namespace transform_math_test
}  // namespace coaster::ui
