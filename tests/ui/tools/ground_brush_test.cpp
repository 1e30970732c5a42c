// The brush of the ground, and the panel that chooses it.
#include "ui/tools/ground_brush.h"

#include "edit/commands/commands_park.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "sim/ground/land.h"
#include "ui/stage.h"
#include "world/aid_settings.h"

namespace coaster::ui {
namespace ground_brush_test {

using world::Brush;

struct GroundBrushTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    for (const edit::Command& command :
         {edit::Command(edit::SetLand{world::Land::meadow}),
          edit::Command(edit::set_camera({.target = {5, 3, 2}, .yaw_deg = 31, .pitch_deg = 40, .distance = 90}))})
      ASSERT_TRUE(edit::apply(session_, files_, command).ok());
  }
  void choose(Brush brush) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::brush>{brush}).ok());
    frames(2);
    commands_.clear();
  }
  // A stroke of about half a second from the empty ground, by `by`.
  void stroke(glm::vec2 by = {0, 0}, platform::Modifiers m = {}) {
    const glm::vec2 from = empty_ground();
    hover(from);
    press(m);
    for (int i = 1; i <= 30; ++i) hover(from + by * (static_cast<float>(i) / 30));
    release(m);
    frames(2);
  }
  double height(glm::vec2 at) const { return sim::Land(session_.document.park).height(at.x, at.y); }
};

TEST_F(GroundBrushTest, holding_the_button_raises_the_ground_as_one_step_and_shift_lowers_it) {
  choose(Brush::raise);
  const std::size_t steps = session_.history.undo.size();
  const world::Document before = session_.document;
  stroke();
  const auto dabs = all<edit::RaiseGround>();
  ASSERT_GE(dabs.size(), 8u) << "a mouse that is held still goes on";
  EXPECT_LE(dabs.size(), 12u) << "20 a second";
  EXPECT_EQ(all<edit::BeginGesture>().size(), 1u);
  EXPECT_EQ(all<edit::EndGesture>().size(), 1u);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
  EXPECT_EQ(dabs[0].radius, session_.settings.aids->brush_radius);
  sim::Land land(before.park);
  EXPECT_GT(height(dabs[0].at), land.height(dabs[0].at.x, dabs[0].at.y) + 1.5);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Undo{}).ok());
  EXPECT_TRUE(session_.document == before);
  stroke({}, {.shift = true});
  EXPECT_LT(all<edit::RaiseGround>().back().by, 0);
  EXPECT_LT(height(dabs[0].at), land.height(dabs[0].at.x, dabs[0].at.y) - 1.5);
}

TEST_F(GroundBrushTest, the_ground_becomes_as_high_as_where_the_stroke_began) {
  choose(Brush::flatten);
  stroke({160, -120});
  const auto dabs = all<edit::FlattenGround>();
  ASSERT_GE(dabs.size(), 5u);
  for (const edit::FlattenGround& dab : dabs) EXPECT_EQ(dab.to, dabs[0].to);
  EXPECT_GT(glm::distance(dabs.front().at, dabs.back().at), 5);
  EXPECT_NEAR(height(dabs.back().at), dabs[0].to, 0.1);
}

TEST_F(GroundBrushTest, a_slope_is_two_clicks_with_the_view_free_between_them) {
  choose(Brush::slope);
  const std::size_t steps = session_.history.undo.size();
  const world::Document before = session_.document;
  const glm::vec2 first = empty_ground(), second = first + glm::vec2(200, -100);
  click_at(first);
  click_at(first);
  EXPECT_TRUE(all<edit::SlopeGround>().empty()) << "a double click is no slope";
  const float yaw = session_.settings.camera.yaw_deg;
  hover(second);
  press({}, platform::Button::right);
  for (int i = 1; i <= 6; ++i) hover(second + glm::vec2(2.0f * static_cast<float>(i), 0));
  release({}, platform::Button::right);
  EXPECT_NE(session_.settings.camera.yaw_deg, yaw);
  frames(2);
  EXPECT_TRUE(all<edit::SlopeGround>().empty());
  click_at(second);
  const auto slopes = all<edit::SlopeGround>();
  ASSERT_EQ(slopes.size(), 1u);
  EXPECT_GT(glm::distance(slopes[0].from, slopes[0].to), 5);
  EXPECT_EQ(slopes[0].radius, session_.settings.aids->brush_radius);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
  sim::Land land(before.park);
  const glm::vec2 middle = 0.5f * (slopes[0].from + slopes[0].to);
  const double from = land.height(slopes[0].from.x, slopes[0].from.y), to = land.height(slopes[0].to.x, slopes[0].to.y);
  EXPECT_NEAR(height(middle), 0.5 * (from + to), 0.1);
  click_at(second);
  EXPECT_EQ(all<edit::SlopeGround>().size(), 1u) << "the next slope begins anew";
}

TEST_F(GroundBrushTest, escape_forgets_where_a_slope_began_and_so_does_another_brush) {
  choose(Brush::slope);
  const glm::vec2 first = empty_ground(), second = first + glm::vec2(160, -80);
  click_at(first);
  key(platform::Key::escape);
  EXPECT_EQ(session_.settings.aids->brush, Brush::slope);
  click_at(second);
  EXPECT_TRUE(all<edit::SlopeGround>().empty());
  choose(Brush::smooth);
  choose(Brush::slope);
  click_at(first);
  EXPECT_TRUE(all<edit::SlopeGround>().empty());
  key(platform::Key::escape);
  key(platform::Key::escape);
  frames(2);
  EXPECT_EQ(session_.settings.aids->brush, Brush::off);
}

TEST_F(GroundBrushTest, woods_follow_the_mouse_and_shift_clears_them) {
  choose(Brush::woods);
  stroke({200, 0});
  ASSERT_GE(all<edit::PaintWoods>().size(), 2u);
  EXPECT_EQ(all<edit::PaintWoods>()[0].to, 1);
  commands_.clear();
  stroke({}, {.shift = true});
  ASSERT_EQ(all<edit::PaintWoods>().size(), 1u) << "once where it does not move";
  EXPECT_EQ(all<edit::PaintWoods>()[0].to, 0);
  stroke({}, {.ctrl = true});
  EXPECT_EQ(all<edit::ResetWoods>().size(), 1u);
}

TEST_F(GroundBrushTest, the_wheel_sets_the_size_and_with_ctrl_it_zooms) {
  choose(Brush::raise);
  hover(empty_ground());
  const float distance = session_.settings.camera.distance, radius = session_.settings.aids->brush_radius;
  frame({platform::Wheel{0, 1}});
  frame();
  EXPECT_GT(session_.settings.aids->brush_radius, radius);
  EXPECT_EQ(session_.settings.camera.distance, distance);
  for (int i = 0; i < 60; ++i) frame({platform::Wheel{0, -1}});
  EXPECT_EQ(session_.settings.aids->brush_radius, world::kLeastBrush);
  frame({platform::KeyPress{platform::Key::unknown, true, false, {.ctrl = true}}, platform::Wheel{0, 1}});
  frames(2);
  EXPECT_LT(session_.settings.camera.distance, distance);
}

TEST_F(GroundBrushTest, escape_reverts_a_stroke_and_then_leaves_the_brush) {
  choose(Brush::raise);
  const world::Document before = session_.document;
  const glm::vec2 at = empty_ground();
  hover(at);
  press();
  for (int i = 0; i < 20; ++i) hover(at);
  EXPECT_FALSE(session_.document == before);
  key(platform::Key::escape);
  EXPECT_TRUE(session_.document == before);
  EXPECT_EQ(session_.settings.aids->brush, Brush::raise);
  release();
  frames(3);
  EXPECT_TRUE(session_.document == before);
  key(platform::Key::escape);
  frames(2);
  EXPECT_EQ(session_.settings.aids->brush, Brush::off);
  commands_.clear();
  stroke();
  EXPECT_TRUE(all<edit::RaiseGround>().empty());
}

TEST_F(GroundBrushTest, other_buttons_move_the_camera_and_knots_are_left_alone) {
  choose(Brush::smooth);
  const float yaw = session_.settings.camera.yaw_deg;
  const glm::vec2 at = empty_ground();
  hover(at);
  press({}, platform::Button::right);
  for (int i = 1; i <= 6; ++i) hover(at + glm::vec2(12.0f * static_cast<float>(i), 0));
  release({}, platform::Button::right);
  EXPECT_NE(session_.settings.camera.yaw_deg, yaw);
  const glm::vec3 place = knot(2).position;
  hover(pixel_of(2));
  press();
  for (int i = 1; i <= 6; ++i) hover(pixel_of(2) + glm::vec2(0, 9.0f * static_cast<float>(i)));
  release();
  frames(2);
  EXPECT_EQ(knot(2).position, place);
}

TEST_F(GroundBrushTest, without_a_land_the_mouse_selects_as_usual) {
  choose(Brush::raise);
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetLand{world::Land::plain}).ok());
  frames(2);
  EXPECT_FALSE(GroundBrush::chosen(session_));
  stroke();
  EXPECT_TRUE(all<edit::RaiseGround>().empty());
}

TEST_F(GroundBrushTest, the_panel_sets_land_sliders_and_brush) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{}).ok());
  frames(2);
  click("Park");
  EXPECT_EQ(find("Park/Land")->value, "Meadow");
  click("Park/Water");
  EXPECT_EQ(session_.document.park.water, world::kNoWater);
  click("Park/Water");
  EXPECT_EQ(session_.document.park.water, -1.2);
  const std::uint32_t seed = session_.document.park.seed;
  click("Park/Roll the die");
  EXPECT_NE(session_.document.park.seed, seed);
  type("Park/Seed", "77");
  EXPECT_EQ(session_.document.park.seed, 77u);
  click("Park/Brush");
  click("Park/Brush/Smooth");
  EXPECT_EQ(session_.settings.aids->brush, Brush::smooth);
  frames(2);
  ASSERT_NE(find("Park/Take strokes away"), nullptr);
  EXPECT_FALSE(find("Park/Take strokes away")->enabled);
  click("Park/Land");
  click("Park/Land/Plain");
  frames(2);
  EXPECT_EQ(find("Park/Seed"), nullptr);
}

TEST_F(GroundBrushTest, a_new_track_begins_on_the_land_that_the_user_wants) {
  session_.file.saved_hash = world::hash(session_.document);
  session_.settings.aids->new_land = world::Land::island;
  frames(2);
  key(platform::Key::n, {.ctrl = true});
  frames(3);
  EXPECT_EQ(session_.document.park.land, world::Land::island);
  const std::uint32_t seed = session_.document.park.seed;
  seconds_ += 7;
  key(platform::Key::n, {.ctrl = true});
  frames(3);
  EXPECT_NE(session_.document.park.seed, seed) << "another one each time";
  session_.settings.aids->new_land = world::Land::plain;
  key(platform::Key::n, {.ctrl = true});
  frames(3);
  EXPECT_TRUE(session_.document.park == world::Park());
}

}  // namespace ground_brush_test
}  // namespace coaster::ui
