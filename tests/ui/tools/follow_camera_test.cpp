// The camera that follows new track (ui/tools/camera_controls.h).
#include "ui/tools/camera_controls.h"

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/camera_feel.h"
#include "world/element_rows.h"

namespace coaster::ui {
namespace follow_camera_test {

struct FollowCameraTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {0, 6, 3}, .distance = 60})));
    frames(3);
    commands_.clear();
  }
  void follow(bool on) { ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::CameraFeel::follow>{on})); }
  void append(glm::vec3 at) { ASSERT_TRUE(edit::apply(session_, files_, edit::AppendKnot{at})); }
  void place_straight(double length) {
    world::Element element = world::usual_element(world::ElementKind::straight);
    element.values[0] = length;
    ASSERT_TRUE(edit::apply(session_, files_, edit::PlaceElement{element}));
  }
  bool shows(glm::vec3 at) const {
    const auto pixel = view::project(host_->view(), at);
    return pixel && host_->view().viewport.contains(glm::vec2(*pixel));
  }
};

TEST_F(FollowCameraTest, is_off_unless_asked_for) {
  append({150, 6, 3});
  frames(60);
  EXPECT_FALSE(shows({150, 6, 3}));
  EXPECT_TRUE(all<edit::SetCamera>().empty());
}

TEST_F(FollowCameraTest, goes_to_an_open_end_out_of_view_in_small_steps_and_rests) {
  follow(true);
  append({22, 8, 9});
  frames(30);
  EXPECT_TRUE(all<edit::SetCamera>().empty()) << "what shows moves nothing";
  append({150, 6, 3});
  frames(120);
  EXPECT_TRUE(shows({150, 6, 3}));
  const std::vector<edit::SetCamera> steps = all<edit::SetCamera>();
  ASSERT_GT(steps.size(), 10u);
  EXPECT_LT(glm::distance(*steps[0].to.target, glm::vec3(0, 6, 3)), 30.0f);
  commands_.clear();
  frames(30);
  EXPECT_TRUE(all<edit::SetCamera>().empty());
}

TEST_F(FollowCameraTest, shows_a_preview_and_leaves_the_camera_to_the_user) {
  follow(true);
  ASSERT_TRUE(edit::apply(session_, files_, edit::ChooseElement{world::usual_element(world::ElementKind::straight)}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_element>{true}));
  frames(120);
  commands_.clear();
  append({200, 6, 3});
  frames(4);
  EXPECT_FALSE(all<edit::SetCamera>().empty());
  const glm::vec2 at = empty_ground();
  hover(at);
  press();
  hover(at + glm::vec2(20, 0));
  release();
  frame();
  commands_.clear();
  frames(30);
  EXPECT_TRUE(all<edit::SetCamera>().empty()) << "the user has turned the camera";
}

TEST_F(FollowCameraTest, comes_back_from_a_preview_that_becomes_small) {
  follow(true);
  const auto choose = [&](double length) {
    world::Element element = world::usual_element(world::ElementKind::straight);
    element.values[0] = length;
    ASSERT_TRUE(edit::apply(session_, files_, edit::ChooseElement{element}));
    frames(120);
  };
  choose(10);
  const world::Camera before = session_.settings.camera;
  choose(900);
  EXPECT_GT(session_.settings.camera.distance, 3 * before.distance);
  choose(10);
  EXPECT_EQ(session_.settings.camera, before);
  choose(900);
  world::Camera turned = session_.settings.camera;
  turned.yaw_deg += 20;
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera(turned)));
  frames(3);
  choose(10);
  EXPECT_EQ(session_.settings.camera, turned) << "where the user looks";
}

TEST_F(FollowCameraTest, leaves_the_camera_where_it_looks_when_an_end_out_of_the_picture_moves) {
  append({150, 6, 3});
  frames(2);
  follow(true);
  const edit::Target end{{world::EntityKind::knot, 4}};
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{end, {150, 9, 3}}));
  frames(30);
  EXPECT_TRUE(all<edit::SetCamera>().empty());
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{end, {21, 9, 3}}));
  frames(2);
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{end, {150, 9, 3}}));
  frames(120);
  EXPECT_TRUE(shows({150, 9, 3})) << "it leaves the picture";
}

TEST_F(FollowCameraTest, stays_when_undo_moves_the_end_out_of_the_picture_again) {
  append({150, 6, 3});
  frames(2);
  follow(true);
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{{{world::EntityKind::knot, 4}}, {21, 9, 3}}));
  frames(30);
  ASSERT_TRUE(shows({21, 9, 3}));
  key(platform::Key::z, {.ctrl = true});
  frames(60);
  EXPECT_FALSE(shows(knot(4).position));
  EXPECT_TRUE(all<edit::SetCamera>().empty());
  key(platform::Key::y, {.ctrl = true});
  key(platform::Key::z, {.ctrl = true}), key(platform::Key::z, {.ctrl = true});
  frames(60);
  EXPECT_TRUE(all<edit::SetCamera>().empty()) << "the end of the shorter track shows";
}

TEST_F(FollowCameraTest, does_not_follow_a_drag_that_is_cancelled) {
  follow(true);
  const glm::vec2 knot = pixel_of(3);
  hover(knot);
  press();
  for (int i = 1; i <= 10; ++i) hover({knot.x + 0.1f * static_cast<float>(i) * (10 - knot.x), knot.y});
  key(platform::Key::escape);
  frames(10);
  EXPECT_FALSE(all<edit::MoveKnot>().empty());
  EXPECT_TRUE(all<edit::SetCamera>().empty());
  release();
}

TEST_F(FollowCameraTest, keeps_the_end_and_what_is_framed_beside_the_first_steps) {
  follow(true);
  resize(1920, 1080);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_hints>{true}));
  frames(3);
  const Widget* const card = find("Hints/Got it");
  ASSERT_NE(card, nullptr);
  const float right = card->x + 380;
  append({-150, 6, 3});
  frames(120);
  ASSERT_TRUE(shows({-150, 6, 3}));
  EXPECT_GT(pixel_of(4).x, right);
  EXPECT_EQ(last_.free.x + last_.free.width, last_.view.viewport.x + last_.view.viewport.width);
  EXPECT_GT(last_.free.x, right);
  key(platform::Key::f);
  frames(2);
  for (std::uint32_t number = 1; number <= 4; ++number) EXPECT_GT(pixel_of(number).x, right) << number;
}

TEST_F(FollowCameraTest, shows_the_section_just_placed_and_leaves_it_out_of_sight_later) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {150, 2, 0}, .distance = 60})));
  follow(true);
  frames(3);
  place_straight(120);
  frames(120);
  EXPECT_TRUE(shows({0, 2, 0}) && shows({120, 2, 0})) << "both of its ends";
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {150, 2, 0}, .distance = 60})));
  frames(3);
  commands_.clear();
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_element>{true}));
  frames(60);
  EXPECT_FALSE(shows({0, 2, 0})) << "the user has turned to its end, where the preview is";
}

TEST_F(FollowCameraTest, leaves_room_beside_what_it_brings_into_view) {
  follow(true);
  append({150, 6, 3});
  frames(120);
  const view::Viewport& all = host_->view().viewport;
  EXPECT_LT(pixel_of(4).x - all.x, 0.9f * all.width);
  EXPECT_GT(pixel_of(4).x - all.x, 0.5f * all.width);
}

TEST_F(FollowCameraTest, shows_the_closing_section_and_the_completed_circuit) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  place_straight(60), place_straight(60);
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {120, 2, 0}, .distance = 40})));
  follow(true);
  frames(3);
  ASSERT_FALSE(shows({0, 2, 0}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::circuit>{1}));
  frames(120);
  EXPECT_TRUE(shows({0, 2, 0})) << "it ends there";
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {0, 2, 0}, .distance = 40})));
  frames(3);
  ASSERT_FALSE(shows({120, 2, 0}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::CompleteCircuit{1}));
  frames(120);
  for (const world::Entity at : session_.document.track.knots)
    EXPECT_TRUE(shows(world::knot(session_.document, at).position)) << "all of the circuit";
  // From the other side the first knot is out of sight.
  ASSERT_TRUE(edit::apply(session_, files_, edit::Undo{}));
  frames(120);
  ASSERT_TRUE(edit::apply(session_, files_, edit::set_camera({.target = {120, 2, 0}, .distance = 40})));
  frames(3);
  ASSERT_FALSE(shows({0, 2, 0}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::CompleteCircuit{1}));
  frames(120);
  for (const world::Entity at : session_.document.track.knots)
    EXPECT_TRUE(shows(world::knot(session_.document, at).position)) << "all of the circuit again";
}

}  // namespace follow_camera_test
}  // namespace coaster::ui
