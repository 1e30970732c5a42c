#include <limits>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "edit/session_fixture.h"
#include "world/appearance_settings.h"
#include "world/camera_feel.h"
#include "world/evaluation_settings.h"

namespace coaster::edit {
namespace perform_settings_test {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class ChangingSettings : public test::SessionTest {};

TEST_F(ChangingSettings, settings_touch_neither_document_nor_motion_nor_history) {
  const std::uint64_t before = hash(), motion = world::hash(session.document, session.motion);
  for (const char* line : {"evaluator bernstein",
                           "resolution 17",
                           "arc_length simpson",
                           "frames_by frenet",
                           "polyline off",
                           "camera target 1 2 3 yaw 10 pitch 20 distance 30",
                           "camera_mode ride",
                           "camera_mode chase",
                           "camera_mode fly",
                           "camera.fly eye 1 2 3 yaw 4 pitch 5",
                           "camera.field_of_view 60",
                           "camera.ride_view 80",
                           "camera.widening 3",
                           "camera.roll_damping 0.5",
                           "camera.chase_distance 20",
                           "camera.head_bob on",
                           "camera.reduced_motion on",
                           "select @k3",
                           "panels off",
                           "append_mode on",
                           "scale 1.5",
                           "vertex_budget 5000"})
    good(line);
  for (const sim::Integrator& row : sim::integrators()) good("integrator " + std::string(row.name));
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(world::hash(session.document, session.motion), motion);
  EXPECT_TRUE(session.history.undo.empty());
  EXPECT_EQ(session.derived.vertices, 4 * 18);
  EXPECT_FALSE(dirty(session));
}

TEST_F(ChangingSettings, the_resolution_is_clamped) {
  clamped("resolution 5000", "Reduced resolution from 5000 to the limit of 4096");
  EXPECT_EQ(session.settings.evaluation->steps, 4096);
  clamped("resolution 0", "limit of 1");
  EXPECT_EQ(session.settings.evaluation->steps, 1);
  clamped("vertex_budget 5", "limit of 1000");
  clamped("vertex_budget 99999999999", "limit of 1000000000");
}

TEST_F(ChangingSettings, how_the_cameras_feel_is_clamped) {
  clamped("camera.field_of_view 20", "limit of 30 degrees");
  clamped("camera.field_of_view 111", "limit of 110 degrees");
  EXPECT_EQ(session.settings.camera.field_of_view_deg, 110);
  good("camera target 1 2 3 yaw 0 pitch 0 distance 30");
  EXPECT_EQ(session.settings.camera.field_of_view_deg, 110) << "a field of view has a command of its own";
  clamped("camera.ride_view 5", "limit of 30 degrees");
  clamped("camera.widening 21", "limit of 20 degrees");
  clamped("camera.roll_damping -1", "limit of 0 s");
  clamped("camera.chase_distance 1", "limit of 5 m");
  clamped("camera.fly eye 1 -2 3 yaw 370 pitch 9", "limit of 0.5 m");
  clamped("camera.fly eye 1 0.5 3 yaw 370 pitch 95", "limit of 89 degrees");
  EXPECT_EQ(session.settings.fly, (world::FlyCamera{{1, 0.5f, 3}, 10, 89}));
  refused(SetFlyCamera{{{0, kNan, 0}, 0, 0}}, "finite");
  refused(Set<&world::CameraFeel::roll_damping>{kNan}, "finite");
  refused(Set<&world::Settings::camera_mode>{static_cast<world::CameraMode>(9)}, "no row 9");
}

TEST_F(ChangingSettings, the_camera_is_clamped_and_yaw_wraps) {
  clamped("camera target 1 2 3 yaw 370 pitch 99 distance 30", "Reduced pitch from 99 to the limit of 89 degrees.");
  EXPECT_EQ(session.settings.camera, (world::Camera{{1, 2, 3}, 10, 89, 30}));
  clamped("camera target 1 2 3 yaw 0 pitch -99 distance 30", "limit of -89");
  clamped("camera target 1 2 3 yaw 0 pitch 0 distance 0", "limit of 0.5 m");
  clamped("camera target 1 2 3 yaw 0 pitch 0 distance 1e6", "limit of 20000 m");
  clamped("camera target 1e6 2 3 yaw 0 pitch 0 distance 10", "target.x");
  good("camera target 1 2 3 yaw 10 pitch 20 distance 30");
  good("camera distance 40 yaw 5");
  EXPECT_EQ(session.settings.camera, (world::Camera{{1, 2, 3}, 5, 20, 40})) << "the other values stay";
  good("camera target 4 5 6");
  EXPECT_EQ(session.settings.camera, (world::Camera{{4, 5, 6}, 5, 20, 40}));
  good("camera pitch 7");
  EXPECT_EQ(session.settings.camera, (world::Camera{{4, 5, 6}, 5, 7, 40}));
  refused(set_camera({{kNan, 0, 0}, 0, 0, 10}), "finite");
  refused(set_camera({{0, 0, 0}, kNan, 0, 10}), "finite");
  refused(set_camera({{0, 0, 0}, 0, kNan, 10}), "finite");
  refused(set_camera({{0, 0, 0}, 0, 0, kNan}), "finite");
}

TEST_F(ChangingSettings, a_segment_is_selected_with_its_place) {
  good("select @s2 at 0.3");
  EXPECT_EQ(session.settings.selected, entity("s2"));
  EXPECT_EQ(session.settings.selected_t, 0.3);
  for (const char* const t : {"1.5", "-0.01", "1.0000001", "1e9"})
    refused(std::string("select @s2 at ") + t, "expected a parameter t from 0 to 1, found ");
  refused("select @k2 at 1.5", "from 0 to 1, found 1.5");
  EXPECT_EQ(session.settings.selected_t, 0.3);
  good("select @s2 at 1"), good("select @s2 at 0");
  good("select none");
  EXPECT_EQ(session.settings.selected, world::kNone);
  refused("select @k9", "there is no knot @k9");
  refused(Select{{{world::EntityKind::segment, 2}}, std::numeric_limits<double>::quiet_NaN()}, "finite");
}

TEST_F(ChangingSettings, rows_that_no_table_has_are_refused) {
  refused(Set<&world::Evaluation::evaluator>{curve::EvaluatorId{99}}, "no row 99");
  refused(Set<&world::Evaluation::arc_length>{curve::ArcLengthId{-1}}, "no row -1");
  refused(Set<&world::Settings::integrator>{world::IntegratorId{99}}, "no row 99");
}

TEST_F(ChangingSettings, the_scale_is_clamped) {
  clamped("scale 0.1", "limit of 0.75");
  clamped("scale 10", "limit of 3");
  refused(Set<&world::Appearance::ui_scale>{kNan}, "finite");
}

TEST_F(ChangingSettings, saying_the_same_at_a_limit_renews_the_notice) {
  clamped("resolution 5000", "limit");
  const std::size_t count = session.notices.list.size();
  const std::uint64_t serial = session.notices.list.back().serial;
  clamped("resolution 5000", "limit");
  EXPECT_EQ(session.notices.list.size(), count);
  EXPECT_GT(session.notices.list.back().serial, serial);
  for (int i = 0; i < 100; ++i) clamped("resolution " + std::to_string(5000 + i), "limit");
  EXPECT_EQ(session.notices.list.size(), 32u);
}

}  // namespace perform_settings_test
}  // namespace coaster::edit
