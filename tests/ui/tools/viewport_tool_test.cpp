#include "ui/tools/viewport_tool.h"

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"

namespace coaster::ui {
namespace viewport_tool_test {

struct ViewportToolTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    ASSERT_TRUE(
        edit::apply(session_, files_,
                    edit::set_camera({.target = {2.3f, 5.1f, 1.7f}, .yaw_deg = 31, .pitch_deg = 27, .distance = 71}))
            .ok());
    frames(2);
    commands_.clear();
  }
  // Presses at `from`, moves by `by` in four frames; the button stays down.
  void drag(glm::vec2 from, glm::vec2 by, platform::Modifiers m = {}, platform::Button b = platform::Button::left) {
    hover(from);
    press(m, b);
    for (int i = 1; i <= 4; ++i) hover(from + by * (static_cast<float>(i) / 4));
  }
};

TEST_F(ViewportToolTest, a_drag_moves_the_knot_under_the_cursor_as_one_step) {
  const std::size_t steps = session_.history.undo.size();
  const glm::vec2 from = pixel_of(2) + glm::vec2(2, -1), by(61, -43);
  const glm::vec2 grab = pixel_of(2) - from;
  drag(from, by);
  release();
  EXPECT_EQ(all<edit::BeginGesture>().size(), 1u);
  EXPECT_EQ(all<edit::EndGesture>().size(), 1u);
  EXPECT_EQ(all<edit::MoveKnot>().size(), 4u);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2));
  const glm::vec2 off = pixel_of(2) - (from + by + grab);
  EXPECT_LT(glm::length(off), 0.5f) << "the knot stays where it was grabbed, in the camera's plane";
}

TEST_F(ViewportToolTest, a_finger_takes_a_knot_that_a_mouse_misses) {
  const glm::vec2 beside = pixel_of(2) + glm::vec2(9, -10);
  const glm::vec3 start = knot(2).position;
  drag(beside, {40, -30});
  release();
  frame();
  EXPECT_EQ(knot(2).position, start);
  session_.settings.selected = {};
  const glm::vec2 again = pixel_of(2) + glm::vec2(9, -10);
  frame({platform::MouseMove{again.x, again.y, true}});
  press({}, platform::Button::left);
  for (const float part : {0.5f, 1.0f}) frame({platform::MouseMove{again.x + 40 * part, again.y - 30 * part, true}});
  release();
  frame();
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2));
  EXPECT_LT(glm::distance(pixel_of(2), again - glm::vec2(9, -10) + glm::vec2(40, -30)), 0.5f)
      << "it moves as far as the finger";
}

TEST_F(ViewportToolTest, keys_choose_orthographic_views_and_orbiting_leaves_them) {
  using world::Projection;
  const std::tuple<platform::Key, platform::Key, Projection> keys[]{
      {platform::Key::keypad_1, platform::Key::d1, Projection::front},
      {platform::Key::keypad_3, platform::Key::d3, Projection::side},
      {platform::Key::keypad_7, platform::Key::d7, Projection::top},
      {platform::Key::keypad_5, platform::Key::d5, Projection::perspective}};
  for (const auto& [pad, digit, projection] : keys) {
    key(pad);
    EXPECT_EQ(session_.settings.camera.projection, projection);
    key(platform::Key::keypad_5);
    key(digit, {.ctrl = true});
    EXPECT_EQ(session_.settings.camera.projection, projection);
  }
  key(platform::Key::keypad_7);
  frame();
  EXPECT_GT(host_->view().parallel, 0);
  drag(empty_ground(), {0, -30});
  release();
  frame();
  EXPECT_EQ(session_.settings.camera.projection, Projection::perspective);
  EXPECT_EQ(host_->view().parallel, 0);
  EXPECT_NEAR(session_.settings.camera.pitch_deg, world::kMaxPitch - 30 * 0.3f, 1e-3f);
}

// Keys of a French keyboard: minus on the key of 6, digits with Shift, and a keypad whose 2 has no name.
TEST_F(ViewportToolTest, numbers_of_a_move_are_the_text_of_keys) {
  using platform::Key, platform::KeyPress, platform::TextInput;
  select(world::EntityKind::knot, 2);
  const float height = knot(2).position.y;
  hover(empty_ground());
  frame({KeyPress{Key::g, true, false, {}, Key::g}, TextInput{"g"}});
  frame({KeyPress{Key::y, true, false, {}, Key::y}, TextInput{"y"}});
  frame({KeyPress{Key::d6, true, false, {}, Key::d6}, TextInput{"-"}});
  frame({KeyPress{Key::d1, true, false, {.shift = true}, Key::d1}, TextInput{"1"}});
  frame({KeyPress{Key::unknown, true, false, {}, Key{322}}, TextInput{"2"}});
  frame({KeyPress{Key::d3, true, false, {}, Key::d3}, TextInput{"\u06F3"}});  // Persian
  key(Key::keypad_enter);
  frame();
  EXPECT_NEAR(knot(2).position.y, height - 123, 1e-4f);
}

TEST_F(ViewportToolTest, flying_keys_go_by_place) {
  using platform::Key, platform::KeyPress;
  key(Key::d4);
  frame();
  const auto fly = [&](Key printed, Key place) {
    const glm::vec3 before = session_.settings.fly.eye;
    frame({KeyPress{printed, true, false, {}, place}});
    frame({KeyPress{printed, false, false, {}, place}});
    frame();
    return session_.settings.fly.eye - before;
  };
  const glm::vec3 ahead = fly(Key::z, Key::w);  // AZERTY
  EXPECT_GT(glm::length(ahead), 0.01f);
  EXPECT_GT(glm::dot(glm::normalize(ahead), glm::normalize(fly(Key::w, Key::unknown))), 0.999f) << "a script's W";
  EXPECT_EQ(fly(Key::w, Key::z), glm::vec3(0));
}

TEST_F(ViewportToolTest, in_an_orthographic_view_the_wheel_keeps_the_point_under_the_cursor) {
  key(platform::Key::keypad_1);
  frames(2);
  const glm::vec2 at = pixel_of(3);
  frame({platform::MouseMove{at.x, at.y}, platform::Wheel{0, 3}});
  frames(2);
  EXPECT_LT(session_.settings.camera.distance, 60);
  EXPECT_LT(glm::distance(pixel_of(3), at), 0.5f);
}

TEST_F(ViewportToolTest, in_the_front_view_knots_are_moved_and_appended_in_its_plane) {
  key(platform::Key::keypad_1);
  frames(2);
  const glm::vec3 start = knot(2).position, last = knot(3).position;
  drag(pixel_of(2), {40, -30});
  release();
  frame();
  EXPECT_EQ(knot(2).position.z, start.z);
  EXPECT_GT(knot(2).position.x, start.x + 1);
  EXPECT_GT(knot(2).position.y, start.y + 1);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::append_mode>{true}));
  frames(2);
  const glm::vec2 pixel = pixel_of(3) + glm::vec2(70, -90);
  click_at(pixel);
  frames(2);
  ASSERT_EQ(session_.document.track.knots.size(), 4u);
  EXPECT_EQ(knot(4).position.z, last.z);
  EXPECT_LT(glm::distance(pixel_of(4), pixel), 0.5f);
}

TEST_F(ViewportToolTest, a_click_selects_and_changes_nothing_else) {
  const auto before = world::hash(session_.document);
  drag(pixel_of(3), {1.5f, 1.5f});  // below 3 px
  release();
  frame();
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 3));
  EXPECT_EQ(world::hash(session_.document), before);
  EXPECT_EQ(commands_.size(), 1u);
}

TEST_F(ViewportToolTest, on_a_dense_screen_a_click_may_move_as_many_points) {
  density_ = 2;
  resize(2560, 1440);
  const glm::vec3 start = knot(3).position;
  drag(pixel_of(3), {5.6f, 0});  // below 3 points
  release();
  frame();
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 3));
  EXPECT_EQ(knot(3).position, start);
  drag(pixel_of(3) + glm::vec2(0, 8.5f), {6.4f, 0});  // within the knot's 5 points, over 3 points
  release();
  EXPECT_NE(knot(3).position, start);
}

TEST_F(ViewportToolTest, shift_moves_vertically_and_ctrl_along_the_ground) {
  const glm::vec3 start = knot(2).position;
  drag(pixel_of(2), {40, -60}, {.shift = true});
  release({.shift = true});
  EXPECT_EQ(knot(2).position.x, start.x);
  EXPECT_EQ(knot(2).position.z, start.z);
  EXPECT_GT(knot(2).position.y, start.y + 1);
  const glm::vec3 lifted = knot(2).position;
  frames(30);  // no double click
  drag(pixel_of(2), {40, 30}, {.ctrl = true});
  release({.ctrl = true});
  EXPECT_NEAR(knot(2).position.y, lifted.y, 1e-4f);
  EXPECT_GT(glm::length(knot(2).position - lifted), 1);
}

TEST_F(ViewportToolTest, escape_or_undo_in_a_drag_restores_the_document_exactly) {
  for (const auto& [k, m] : {std::pair{platform::Key::escape, platform::Modifiers{}},
                             {platform::Key::z, platform::Modifiers{.ctrl = true}}}) {
    const world::Document before = session_.document;
    const std::size_t steps = session_.history.undo.size();
    drag(pixel_of(2), {55, 31});
    EXPECT_FALSE(session_.document == before);
    key(k, m);
    hover(pixel_of(2) + glm::vec2(120, 90));  // still down: nothing moves any more
    release();
    EXPECT_TRUE(session_.document == before);
    EXPECT_FALSE(session_.history.in_gesture);
    EXPECT_EQ(session_.history.undo.size(), steps);
    frames(30);
  }
}

TEST_F(ViewportToolTest, a_handle_is_dragged_and_turns_the_tangent) {
  select(world::EntityKind::knot, 2);
  const glm::vec3 tangent = knot(2).tangent;
  const auto at = view::project(host_->view(), world::out_handle(knot(2)));
  ASSERT_TRUE(at.has_value());
  drag(glm::vec2(*at), {25, -50});
  release();
  EXPECT_FALSE(all<edit::MoveHandle>().empty());
  EXPECT_LT(glm::dot(knot(2).tangent, tangent), 0.999f);
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2));
}

TEST_F(ViewportToolTest, a_press_on_the_curve_picks_its_place_and_a_double_click_inserts_a_knot) {
  const glm::dvec3 place = curve::point(session_.derived.shape(entity(world::EntityKind::segment, 2)).key.cubic, 0.41);
  const auto at = view::project(host_->view(), glm::vec3(place));
  ASSERT_TRUE(at.has_value());
  click_at(glm::vec2(*at));
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::segment, 2));
  EXPECT_NEAR(session_.settings.selected_t, 0.41, 0.01);
  EXPECT_EQ(session_.document.track.knots.size(), 3u);
  click_at(glm::vec2(*at));
  EXPECT_EQ(session_.document.track.knots.size(), 4u);
}

TEST_F(ViewportToolTest, a_click_on_the_ground_deselects_or_appends_there) {
  select(world::EntityKind::knot, 2);
  click_at(empty_ground());
  EXPECT_FALSE(session_.settings.selected.valid());
  EXPECT_EQ(session_.document.track.knots.size(), 3u);
  key(platform::Key::a);
  ASSERT_TRUE(session_.settings.aids->append_mode);
  frames(30);
  const glm::vec2 pixel = empty_ground() + glm::vec2(-31, -7);
  click_at(pixel);
  ASSERT_EQ(session_.document.track.knots.size(), 4u);
  EXPECT_EQ(knot(4).position.y, 2) << "its rails stand above the ground";
  EXPECT_LT(glm::length(pixel_of(4) - pixel), 0.5f);
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 4));
}

TEST_F(ViewportToolTest, a_drag_of_empty_space_orbits_and_leaves_document_and_selection_alone) {
  select(world::EntityKind::knot, 2);
  const auto before = world::hash(session_.document);
  const world::Camera camera = session_.settings.camera;
  drag(empty_ground(), {80, -25});
  release();
  EXPECT_NE(session_.settings.camera.yaw_deg, camera.yaw_deg);
  EXPECT_EQ(session_.settings.camera.target, camera.target);
  EXPECT_EQ(session_.settings.camera.distance, camera.distance);
  EXPECT_EQ(world::hash(session_.document), before);
  EXPECT_EQ(session_.settings.selected, entity(world::EntityKind::knot, 2));
}

TEST_F(ViewportToolTest, orbit_and_pan_carry_the_scene_with_the_cursor) {
  // Objects between target and eye move to the right when dragged to the right.
  const auto near_x = [&] {
    const view::View& v = host_->view();
    return view::project(v, glm::mix(session_.settings.camera.target, v.eye, 0.3f));
  };
  const glm::vec3 point = glm::mix(session_.settings.camera.target, host_->view().eye, 0.3f);
  const auto from = near_x();
  drag(empty_ground(), {60, 0});
  release();
  frame();
  EXPECT_GT(view::project(host_->view(), point)->x, from->x + 5);
  const glm::vec3 target = session_.settings.camera.target;
  const glm::vec2 before = glm::vec2(*view::project(host_->view(), target));
  frames(30);
  drag(empty_ground(), {47, -29}, {}, platform::Button::middle);
  release({}, platform::Button::middle);
  frame();
  EXPECT_LT(glm::length(glm::vec2(*view::project(host_->view(), target)) - before - glm::vec2(47, -29)), 1.5f);
}

TEST_F(ViewportToolTest, a_drag_pans_on_where_the_wheel_has_zoomed) {
  const glm::vec2 at = empty_ground();
  const world::Camera before = session_.settings.camera;
  frame({platform::MouseMove{at.x, at.y}});
  frame({platform::MouseButton{platform::Button::middle, true, {}}});
  frame({platform::MouseMove{at.x + 20, at.y}, platform::Wheel{0, 2}});
  EXPECT_LT(session_.settings.camera.distance, before.distance);
  EXPECT_EQ(session_.settings.camera.target, before.target);
  frame();
  EXPECT_NE(session_.settings.camera.target, before.target) << "with the movement of the frame before";
  frame({platform::MouseButton{platform::Button::middle, false, {}}});
}

TEST_F(ViewportToolTest, the_wheel_zooms_in_the_viewport_and_scrolls_over_a_panel) {
  const float distance = session_.settings.camera.distance;
  const glm::vec2 at = empty_ground();
  frame({platform::MouseMove{at.x, at.y}, platform::Wheel{0, 2}});
  EXPECT_LT(session_.settings.camera.distance, distance);
  for (int i = 0; i < 30; ++i) frame({platform::Wheel{0, 9}});
  EXPECT_EQ(session_.settings.camera.distance, 0.5f) << "m: near enough for a knot's handles";
  commands_.clear();
  frame({platform::MouseMove{1200, 400}});
  frame({platform::Wheel{0, -2}});
  EXPECT_TRUE(all<edit::SetCamera>().empty());
}

TEST_F(ViewportToolTest, a_press_over_a_panel_is_not_for_the_viewport) {
  hover({1200, 400});
  press();
  hover({640, 400});
  release();
  EXPECT_TRUE(all<edit::SetCamera>().empty());
  EXPECT_TRUE(all<edit::MoveKnot>().empty());
}

}  // namespace viewport_tool_test
}  // namespace coaster::ui
