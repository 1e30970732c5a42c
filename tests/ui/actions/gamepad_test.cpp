#include "ui/actions/gamepad.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"

namespace coaster::ui {
namespace gamepad_test {

using platform::GamepadAxes;
using platform::GamepadButton;
using platform::PadButton;

TEST(gamepad_shape, a_stick_near_its_middle_does_nothing_and_at_its_edge_all) {
  EXPECT_EQ(shaped_stick({0.12f, -0.13f}), glm::vec2(0));
  EXPECT_NEAR(glm::length(shaped_stick({0.6f, 0.8f})), 1, 1e-6);
  EXPECT_NEAR(glm::length(shaped_stick({1, 1})), 1, 1e-6) << "the corners of a square stick are no faster";
  EXPECT_EQ(shaped_trigger(0.05f), 0);
  EXPECT_EQ(shaped_trigger(1), 1);
}

RC_GTEST_PROP(gamepad_shape, a_stick_keeps_its_direction_and_grows_without_a_step, ()) {
  const auto angle = static_cast<float>(*rc::gen::inRange(0, 6283)) * 0.001f,
             far = static_cast<float>(*rc::gen::inRange(0, 999)) * 0.001f;
  const glm::vec2 way(std::cos(angle), std::sin(angle)), near = shaped_stick(far * way),
                                                         further = shaped_stick((far + 0.001f) * way);
  RC_ASSERT(glm::length(further) >= glm::length(near) - 1e-6f);
  RC_ASSERT(glm::length(further) - glm::length(near) < 0.003f);
  if (glm::length(near) > 0) RC_ASSERT(glm::dot(glm::normalize(near), way) > 0.999f);
}

class gamepad : public Stage {
 protected:
  void hold(GamepadAxes axes, int count = 30) {
    frame({axes});
    frames(count - 1);
  }
  const world::Settings& settings() const { return session_.settings; }
};

TEST_F(gamepad, the_right_stick_turns_the_orbit_camera_until_it_is_let_go) {
  const world::Camera before = settings().camera;
  hold({.right_x = 1}, 30);  // half a second
  const float turned = std::abs(std::remainder(settings().camera.yaw_deg - before.yaw_deg, 360.0f));
  EXPECT_NEAR(turned, 65, 1);
  EXPECT_EQ(settings().camera.pitch_deg, before.pitch_deg);
  hold({}, 1);
  const world::Camera after = settings().camera;
  frames(10);
  EXPECT_EQ(settings().camera, after);
  hold({.right_y = -1}, 10);
  EXPECT_GT(settings().camera.pitch_deg, after.pitch_deg) << "up is over the track";
}

// In half a second, by the picture: the right stick turns the view by 65 degrees to the side that it points to and, in
// a sixth of a second, tilts it by 15; the left one and the triggers move the free camera by 10 m.
TEST_F(gamepad, sticks_turn_and_move_cameras_as_they_point) {
  struct Appearance {
    glm::vec3 right, up, forward;
    float heading(const Appearance& other) const {  // to the other one, degrees to the right
      const glm::vec2 a(forward.x, forward.z), b(other.forward.x, other.forward.z);
      return glm::degrees(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
    }
    float pitch() const { return glm::degrees(std::asin(forward.y)); }
  };
  const auto look = [&] {
    const glm::mat4& v = host_->view().view;
    return Appearance{{v[0][0], v[1][0], v[2][0]}, {v[0][1], v[1][1], v[2][1]}, {-v[0][2], -v[1][2], -v[2][2]}};
  };
  for (const world::CameraMode mode : {world::CameraMode::orbit, world::CameraMode::fly}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Settings::camera_mode>{mode}));
    const edit::SetFlyCamera start{world::FlyCamera{{3, 20, 7}, 30, -5}};
    if (mode == world::CameraMode::fly) {
      ASSERT_TRUE(edit::apply(session_, files_, start));
    }
    frames(2);
    for (const float side : {1.0f, -1.0f}) {
      const Appearance before = look();
      hold({.right_x = side}, 30);
      hold({}, 2);
      EXPECT_NEAR(before.heading(look()), 65 * side, 1);
      const float pitch = look().pitch();
      hold({.right_y = side}, 10);
      hold({}, 2);
      const bool over = mode == world::CameraMode::orbit;  // up is over the track: looking further down
      EXPECT_NEAR(look().pitch() - pitch, over ? 15 * side : -15 * side, 0.5);
    }
  }
  const auto flies = [&](GamepadAxes axes) {
    const glm::vec3 before = settings().fly.eye;
    hold(axes, 30);
    hold({}, 2);
    return settings().fly.eye - before;
  };
  const Appearance now = look();
  for (const float sign : {1.0f, -1.0f}) {
    EXPECT_LT(glm::distance(flies({.left_x = sign}), 10 * sign * now.right), 0.2f);
    EXPECT_LT(glm::distance(flies({.left_y = -sign}), 10 * sign * now.forward), 0.2f);
  }
  EXPECT_GT(flies({.right_trigger = 1}).y, 9);
  EXPECT_LT(flies({.left_trigger = 1}).y, -9);
}

TEST_F(gamepad, triggers_zoom_and_the_left_stick_pans) {
  const world::Camera before = settings().camera;
  hold({.right_trigger = 1}, 20);
  EXPECT_LT(settings().camera.distance, before.distance);
  hold({.left_trigger = 1}, 20);
  EXPECT_NEAR(settings().camera.distance, before.distance, 0.02 * before.distance);
  EXPECT_EQ(settings().camera.target, before.target);
  hold({.left_x = 0.8f}, 10);
  const glm::mat4& view = host_->view().view;
  const glm::vec3 right(view[0][0], view[1][0], view[2][0]), moved = settings().camera.target - before.target;
  EXPECT_GT(glm::dot(moved, right), 0.99f * glm::length(moved));
  EXPECT_GT(glm::length(moved), 1);
}

TEST_F(gamepad, sticks_fly_the_free_camera_by_time_and_not_by_frames) {
  const auto flown_in = [&](int count, double dt) {
    (void)edit::apply(session_, files_, edit::Set<&world::Settings::camera_mode>{world::CameraMode::fly});
    (void)edit::apply(session_, files_, edit::SetFlyCamera{world::FlyCamera{{3, 20, 7}, 30, -5}});
    host_->build({GamepadAxes{.left_y = -0.7f}, platform::Tick{0}}, {session_, stats_, seconds_, false}, width_,
                 height_);
    for (int i = 0; i < count; ++i)
      for (const edit::Command& command :
           host_->build({platform::Tick{dt}}, {session_, stats_, seconds_, false}, width_, height_).commands)
        (void)edit::apply(session_, files_, command);
    return settings().fly.eye;
  };
  const glm::vec3 fine = flown_in(40, 1.0 / 80), coarse = flown_in(10, 1.0 / 20);
  EXPECT_LT(glm::distance(fine, coarse), 1e-3f);
  EXPECT_GT(glm::distance(fine, glm::vec3(3, 20, 7)), 2);
}

TEST_F(gamepad, buttons_play_change_the_camera_and_reset) {
  frame({GamepadButton{PadButton::a, true}});
  EXPECT_EQ(session_.motion.state, world::RideState::running);
  frame({GamepadButton{PadButton::a, false}});
  EXPECT_EQ(session_.motion.state, world::RideState::running) << "letting go does nothing";
  frame({GamepadButton{PadButton::y, true}});
  EXPECT_EQ(settings().camera_mode, world::CameraMode::ride);
  select(world::EntityKind::knot, 1);
  frame({GamepadButton{PadButton::b, true}});
  EXPECT_FALSE(settings().selected.valid()) << "cancel comes first";
  EXPECT_EQ(session_.motion.state, world::RideState::running);
  frame({GamepadButton{PadButton::b, true}});
  EXPECT_EQ(session_.motion.state, world::RideState::stopped);
}

TEST_F(gamepad, a_pad_that_drives_another_window_moves_nothing_here) {
  frame({platform::Focus{false}});
  const world::Camera before = settings().camera;
  hold({.right_x = 1});
  frame({GamepadButton{PadButton::a, true}});
  EXPECT_EQ(settings().camera, before);
  EXPECT_NE(session_.motion.state, world::RideState::running);
}

}  // namespace gamepad_test
}  // namespace coaster::ui
