#include "view/gizmo.h"

#include <random>

#include <gtest/gtest.h>

#include "world/aid_settings.h"
#include "world/sample_documents.h"

namespace coaster::view {
namespace gizmo_test {

constexpr Viewport kViewport{100, 20, 900, 600};

struct Scene {
  world::Document document = test::sample_document();
  world::Settings settings;
  Scene() { settings.selected = document.track.knots[1]; }
  View view(float yaw = 30, float pitch = 25) const {
    return orbit_view({world::knot(document, settings.selected).position, yaw, pitch, 60}, kViewport);
  }
};

glm::vec2 pixel_of(const View& view, glm::vec3 place) {
  const auto at = project(view, place);
  EXPECT_TRUE(at);
  return {at->x, at->y};
}

TEST(gizmo, stands_at_the_middle_of_the_selected_knots_and_nowhere_else) {
  Scene s;
  EXPECT_EQ(gizmo_of(s.document, s.settings, s.view())->at, world::knot(s.document, s.settings.selected).position);
  s.settings.also = {s.document.track.knots[3]};
  const glm::vec3 a = world::knot(s.document, s.document.track.knots[1]).position,
                  b = world::knot(s.document, s.document.track.knots[3]).position;
  EXPECT_LT(glm::length(gizmo_of(s.document, s.settings, s.view())->at - 0.5f * (a + b)), 1e-4f);
  s.settings.selected = s.document.track.segments[0], s.settings.also.clear();
  EXPECT_FALSE(gizmo_of(s.document, s.settings, orbit_view({a, 30, 25, 60}, kViewport)));
  s.settings.selected = s.document.track.knots[1], s.settings.aids->show_gizmo = false;
  EXPECT_FALSE(gizmo_of(s.document, s.settings, s.view()));
}

TEST(gizmo, every_part_is_picked_where_a_script_aims_from_any_side) {
  const Scene s;
  for (int yaw = -170; yaw < 180; yaw += 23)
    for (const float pitch : {12.0f, 35.0f, 60.0f}) {
      const View view = s.view(static_cast<float>(yaw), pitch);
      const auto gizmo = gizmo_of(s.document, s.settings, view);
      ASSERT_TRUE(gizmo);
      int found = 0;
      for (int part = static_cast<int>(PickKind::axis_x); part <= static_cast<int>(PickKind::plane_z); ++part) {
        const auto kind = static_cast<PickKind>(part);
        const PickKind picked = pick_gizmo(*gizmo, view, 1, pixel_of(view, gizmo_place(*gizmo, 1, kind)));
        found += picked == kind;
        // Parts that are not found are seen from their end or edge, or are behind another part.
        EXPECT_TRUE(picked == PickKind::none || is_gizmo(picked)) << yaw << ' ' << pitch << ' ' << part;
      }
      EXPECT_GE(found, 4) << yaw << ' ' << pitch;
    }
}

// From between the arrows of x and -z the squares beside y lie over each other; the one on the eye's side is in front.
TEST(gizmo, of_two_squares_over_each_other_the_nearer_is_picked) {
  const Scene s;
  for (const auto& [yaw, nearer, other] :
       {std::tuple(-45.0f, PickKind::plane_x, PickKind::plane_z), {135.0f, PickKind::plane_z, PickKind::plane_x}})
    for (const float turned : {-2.0f, 0.0f, 2.0f}) {
      const View view = s.view(yaw + turned, 5);
      const auto gizmo = gizmo_of(s.document, s.settings, view);
      const glm::vec2 a = pixel_of(view, gizmo_place(*gizmo, 1, nearer)),
                      b = pixel_of(view, gizmo_place(*gizmo, 1, other));
      ASSERT_LT(glm::distance(a, b), 5) << "they are over each other";
      EXPECT_EQ(pick_gizmo(*gizmo, view, 1, a), nearer) << yaw + turned;
      EXPECT_EQ(pick_gizmo(*gizmo, view, 1, b), nearer) << yaw + turned;
    }
}

TEST(gizmo, keeps_its_size_on_the_screen) {
  Scene s;
  for (const float distance : {20.0f, 200.0f, 2000.0f}) {
    const View view = orbit_view({world::knot(s.document, s.settings.selected).position, 0, 5, distance}, kViewport);
    const auto gizmo = gizmo_of(s.document, s.settings, view);
    const glm::vec2 from = pixel_of(view, gizmo->at), to = pixel_of(view, gizmo_place(*gizmo, 1, PickKind::axis_x));
    EXPECT_NEAR(glm::length(to - from), 0.82 * kGizmoLength, 3) << distance;
  }
}

TEST(gizmo, knots_and_handles_are_picked_before_it_and_it_before_the_curve) {
  Scene s;
  const View view = s.view();
  sim::DerivedTrack derived;
  world::Motion motion;
  const auto gizmo = gizmo_of(s.document, s.settings, view);
  const auto pick_at = [&](glm::vec3 place) {
    return pick(s.document, derived, motion, s.settings, view, pixel_of(view, place)).kind;
  };
  EXPECT_EQ(pick_at(world::knot(s.document, s.settings.selected).position), PickKind::knot);
  EXPECT_EQ(pick_at(world::out_handle(world::knot(s.document, s.settings.selected))), PickKind::handle_out);
  EXPECT_EQ(pick_at(gizmo_place(*gizmo, 1, PickKind::axis_y)), PickKind::axis_y);
}

}  // namespace gizmo_test
}  // namespace coaster::view
