// Clicks on positions that view::pick() does not find: the ground, the track in front of the gizmo; and snapping of
// drags.
#include "ui/tools/viewport_tool.h"

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "sim/lands.h"
#include "ui/stage.h"
#include "view/gizmo.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"

namespace coaster::ui {
namespace cursor_places_test {

struct CursorPlacesTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {0, 6, 3}, .distance = 60})));
    frames(3);
  }
  void set_projection(world::Projection to) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Camera::projection>{to}));
    frames(2);
  }
};

TEST_F(CursorPlacesTest, knots_stand_above_the_ground_in_every_view) {
  const view::View& v = host_->view();
  const glm::vec2 low = empty_ground();
  const auto at = append_place(session_.document, v, low);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->y, 2);
  const auto seen = view::project(v, *at);
  ASSERT_TRUE(seen);
  EXPECT_LT(glm::distance(glm::vec2(*seen), low), 0.5f);
  EXPECT_FALSE(append_place(session_.document, v, {v.viewport.x + 5, v.viewport.y + 2})) << "the sky";
  set_projection(world::Projection::front);
  const glm::vec3 last = knot(3).position;
  const auto buried = append_place(session_.document, host_->view(), low),
             top = append_place(session_.document, host_->view(), pixel_of(2));
  ASSERT_TRUE(buried && top);
  EXPECT_EQ(buried->y, 2);
  EXPECT_EQ(buried->z, last.z);
  EXPECT_NEAR(top->y, knot(2).position.y, 1e-3f);
  set_projection(world::Projection::top);
  EXPECT_EQ(append_place(session_.document, host_->view(), low)->y, last.y);
  EXPECT_EQ(append_place({}, host_->view(), low)->y, 2) << "the first knot";
}

TEST_F(CursorPlacesTest, on_a_land_knots_stand_above_it_under_the_cursor_and_snap_to_it) {
  test::shape_land(session_.document, [](double x, double z) { return -9 + 5 * std::sin(x / 14) - 0.05 * z; });
  const sim::Land land(session_.document.park);
  frames(2);
  const view::View& v = host_->view();
  int places = 0;
  for (float down = 0.55f; down < 0.95f; down += 0.1f)
    for (float across = 0.2f; across < 0.9f; across += 0.15f) {
      const glm::vec2 pixel(v.viewport.x + across * v.viewport.width, v.viewport.y + down * v.viewport.height);
      const auto at = append_place(session_.document, v, pixel);
      if (!at) continue;
      ++places;
      EXPECT_NEAR(at->y, land.surface(double{at->x}, double{at->z}) + 2, 1.0 / 32);
      const auto seen = view::project(v, *at);
      ASSERT_TRUE(seen);
      EXPECT_LT(glm::distance(glm::vec2(*seen), pixel), 2.0f);
      const glm::dvec3 to =
          snapped({session_.document, session_.settings, v, pixel}, world::SnapTo::ground, {0, 50, 0}, {0, 50, 0}, {});
      EXPECT_NEAR(to.y, land.surface(to.x, to.z), 1e-6);
      const auto below = view::project(v, glm::vec3(to));
      ASSERT_TRUE(below);
      EXPECT_LT(glm::distance(glm::vec2(*below), pixel), 2.0f);
    }
  EXPECT_GT(places, 15);
  EXPECT_FALSE(append_place(session_.document, v, {v.viewport.x + 5, v.viewport.y + 2})) << "the sky";
  // A lake: knots stand above the water.
  session_.document.park.water = -3;
  const auto wet = append_place(session_.document, v, empty_ground());
  ASSERT_TRUE(wet);
  EXPECT_GE(wet->y, -1);
}

TEST_F(CursorPlacesTest, a_click_on_the_gizmo_selects_the_track_before_it_and_a_drag_moves_the_knots) {
  select(world::EntityKind::knot, 2);
  const view::View v = host_->view();
  const auto gizmo = view::gizmo_of(session_.document, session_.settings, v);
  ASSERT_TRUE(gizmo);
  const glm::vec3 arrow = view::gizmo_place(*gizmo, 1, view::PickKind::axis_x);
  const auto pixel = view::project(v, arrow);
  ASSERT_TRUE(pixel);
  const std::size_t knots = session_.document.track.knots.size();
  click_at(glm::vec2(*pixel));
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2)) << "nothing is in front";
  // A stretch of track that crosses the arrow on the screen, nearer to the eye.
  const glm::vec3 middle = glm::mix(v.eye, arrow, 0.5f), up = 6.0f * view::top_of(v);
  ASSERT_TRUE(edit::apply(session_, files_, edit::AppendKnot{middle + up}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::AppendKnot{middle - up}));
  ASSERT_EQ(session_.document.track.knots.size(), knots + 2);
  const edit::Knots both({{world::EntityKind::knot, 4}, {world::EntityKind::knot, 5}});
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetDirection{both, -up}));  // a straight through the middle
  select(world::EntityKind::knot, 2);
  const glm::vec3 before = knot(2).position;
  hover(glm::vec2(*pixel));
  press();
  hover(glm::vec2(*pixel) + glm::vec2(25, 0));
  release();
  frames(2);
  EXPECT_NE(knot(2).position, before) << "a drag moves the knot";
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Undo{}));
  frames(2);
  click_at(glm::vec2(*pixel));
  frames(2);
  const world::Entity crossing = session_.document.track.segments.back();
  EXPECT_EQ(session_.settings.selected, crossing);
  EXPECT_EQ(knot(2).position, before);
}

TEST_F(CursorPlacesTest, a_drag_says_at_the_cursor_what_it_snaps_to) {
  EXPECT_EQ(find("Cursor/Snapping"), nullptr);
  const auto dragged = [&] {
    hover(pixel_of(2));
    press();
    hover(pixel_of(2) + glm::vec2(20, -20));
    hover(pixel_of(2) + glm::vec2(25, -22));
    const Widget* const label = find("Cursor/Snapping");
    const std::string words = label ? label->value : "nothing";
    release();
    frames(2);
    EXPECT_EQ(find("Cursor/Snapping"), nullptr);
    return words;
  };
  EXPECT_EQ(dragged(), "Snap: off");
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetSnapping{world::SnapTo::grid, 0.5, 15}));
  EXPECT_EQ(dragged(), "Snap: grid 0.5 m");
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetSnapping{world::SnapTo::knots, 0.5, 15}));
  EXPECT_EQ(dragged(), "Snap: knots");
  select(world::EntityKind::knot, 2);
  key(platform::Key::r);
  hover(pixel_of(2) + glm::vec2(60, 0));
  hover(pixel_of(2) + glm::vec2(60, 40));
  ASSERT_NE(find("Cursor/Snapping"), nullptr);
  EXPECT_EQ(find("Cursor/Snapping")->value, "Snap: 15\u00B0");
}

TEST_F(CursorPlacesTest, a_click_beside_the_preview_of_the_first_element_places_no_knot) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::ChooseElement{world::usual_element(world::ElementKind::straight)}));
  frames(3);
  click_at(empty_ground());
  EXPECT_TRUE(session_.document.track.knots.empty());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_element>{false}));
  frames(30);  // no double click
  click_at(empty_ground());
  EXPECT_EQ(session_.document.track.knots.size(), 1u);
}

}  // namespace cursor_places_test
}  // namespace coaster::ui
