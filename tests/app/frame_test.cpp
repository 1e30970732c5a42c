#include "app/frame.h"

#include "app/program_fixture.h"
#include "app/scene.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "edit/commands/set_setting.h"
#include "edit/session/findings_memory.h"
#include "edit/session_fixture.h"
#include "gfx/image.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/layers.h"
#include "world/sections.h"

namespace coaster::app {
namespace frame_test {

class Frame : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    restart_drawing();
  }
  static void place(Program& program, world::ElementKind kind) {
    ASSERT_TRUE(apply(program, edit::PlaceElement{world::usual_element(kind)}).ok());
  }
  static void press(Program& program, platform::Key key) {
    constexpr platform::Modifiers kCtrl{.ctrl = true};
    run_frame(program, {platform::KeyPress{key, true, false, kCtrl}, platform::Tick{1.0 / 60}}, 0);
    run_frame(program, {platform::KeyPress{key, false, false, {}}, platform::Tick{1.0 / 60}}, 0);
  }
  static std::string last_kind(const Program& program) {
    const world::Document& document = program.session.document;
    return std::string(world::kind_name(world::section(document, world::sections_of(document).back().section)));
  }
  static std::size_t sections(const Program& program) { return world::sections_of(program.session.document).size(); }
};

TEST_F(Frame, sections_are_copied_from_one_program_to_another_as_text) {
  place(*program_, world::ElementKind::straight);
  place(*program_, world::ElementKind::loop);
  ASSERT_TRUE(apply(*program_, edit::Select{{{world::EntityKind::section, 2}}}).ok());
  press(*program_, platform::Key::c);
  const std::string text = surface(*program_).copied;
  EXPECT_NE(text.find("loop"), std::string::npos);
  restart_drawing();
  place(*program_, world::ElementKind::straight);
  surface(*program_).copied = text;
  press(*program_, platform::Key::v);
  EXPECT_EQ(sections(*program_), 2u);
  EXPECT_EQ(last_kind(*program_), "loop");
}

// Setting a tolerance plans the section again and derives several times, lastly nothing new.
TEST_F(Frame, rebuilds_are_those_of_all_derivations_since_the_last_frame) {
  for (const char* const line :
       {"start_speed 25", "element straight", "add_cart @s1 at 0", "element force_valley slope 20",
        "element force_valley g 0 slope -20", "element force_valley"})
    ASSERT_TRUE(apply(*program_, test::command_of(line)).ok()) << line;
  run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
  run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
  EXPECT_EQ(program_->stats.rebuilds, 0);
  for (const char* const line : {"force.tolerance @q2 to 0.06", "start_speed 24"}) {
    ASSERT_TRUE(apply(*program_, test::command_of(line)).ok()) << line;
    run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
    EXPECT_GT(program_->stats.uploads, 0) << line;
    EXPECT_GE(program_->stats.rebuilds, program_->stats.uploads) << line;
  }
}

// Photos without panels, pictures of movies: whatever is selected, previewed or switched on for building.
TEST_F(Frame, a_scene_alone_shows_the_track_without_any_aid) {
  build_track(*program_);
  surface(*program_).resize({320, 240});
  ASSERT_TRUE(apply(*program_, edit::Select{}).ok());
  ASSERT_TRUE(apply(*program_, edit::ShowLayer{world::Layer::polyline, false}).ok());
  run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
  const view::Viewport whole{0, 0, 320, 240};
  const auto alone = [&] {
    run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
    draw_scene_alone(*program_, {320, 240});
    return program_->renderer->read_pixels();
  };
  const view::View view = view::view_of(program_->picture.rig.eye, whole);
  const PictureSettings look{program_->session.settings, view, {}, true};
  (void)draw_scene(*program_, look, find_seen(*program_, look), {320, 240});  // with everything switched off by command
  const gfx::Image plain = program_->renderer->read_pixels();
  ASSERT_TRUE(apply(*program_, edit::ShowLayer{world::Layer::polyline, true}).ok());
  (void)draw_scene(*program_, look, find_seen(*program_, look), {320, 240});
  EXPECT_GT(gfx::compare(program_->renderer->read_pixels(), plain).pixels, 50) << "the polyline can be seen";
  const auto same = [&](const char* with) { EXPECT_EQ(gfx::compare(alone(), plain).pixels, 0) << with; };
  same("the polyline");
  ASSERT_TRUE(apply(*program_, edit::Select{{{world::EntityKind::knot, 2}}}).ok());
  ASSERT_TRUE(apply(*program_, edit::Set<&world::EditingAids::show_gizmo>{true}).ok());
  same("knots and their arrows");
  ASSERT_TRUE(apply(*program_, edit::Select{{{world::EntityKind::section, 1}}}).ok());
  same("a section");
  ASSERT_TRUE(apply(*program_, edit::Set<&world::EditingAids::show_element>{true}).ok());
  same("an element");
}

TEST_F(Frame, pasted_lines_of_numbers_open_as_points_after_a_question) {
  surface(*program_).copied = "0 5 0\r\n60 5 0\r\n120 5 20\r\n";
  press(*program_, platform::Key::v);
  EXPECT_TRUE(program_->session.document.track.knots.empty());
  const auto enter = [&] { return platform::KeyPress{platform::Key::enter, true, false, {}}; };
  for (int i = 0; i < 3; ++i) run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
  run_frame(*program_, {enter(), platform::Tick{1.0 / 60}}, 0);
  ASSERT_EQ(program_->session.document.track.knots.size(), 3u);
  EXPECT_EQ(world::knot(program_->session.document, program_->session.document.track.knots[1]).position,
            glm::vec3(60, 5, 0));
  EXPECT_EQ(program_->session.file.path, "");
}

// A search would hold up each frame of the drag.
TEST_F(Frame, closing_sections_are_not_searched_for_while_a_drag_changes_the_track) {
  place(*program_, world::ElementKind::straight);
  place(*program_, world::ElementKind::curve);
  ASSERT_TRUE(apply(*program_, edit::Set<&world::EditingAids::circuit>{1}).ok());
  const auto length = [&] {
    run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
    const std::vector<sim::CircuitProposal>& found = program_->session.findings->circuit.found().list;
    return found.empty() ? 0.0 : found.front().plan.length;
  };
  const double before = length();
  ASSERT_GT(before, 1);
  const world::Document& document = program_->session.document;
  const world::Entity last = document.track.knots.back();
  ASSERT_TRUE(apply(*program_, edit::BeginGesture{}).ok());
  const glm::vec3 to = world::knot(document, last).position + glm::vec3(0, 3, 0);
  ASSERT_TRUE(apply(*program_, edit::MoveKnot{world::name_of(document, last), to}).ok());
  EXPECT_EQ(length(), before);
  ASSERT_TRUE(apply(*program_, edit::EndGesture{}).ok());
  EXPECT_NE(length(), before);
}

TEST_F(Frame, a_window_shows_nothing_before_its_track_is_open) {
  surface(*program_).window = true;
  run_frame(*program_, {platform::Tick{0}}, 0);
  EXPECT_EQ(surface(*program_).presented, 0);
  EXPECT_GT(program_->picture.view.viewport.width, 0) << "known to the camera that frames the track";
  run_frame(*program_, {platform::Tick{1.0 / 60}}, 0);
  EXPECT_EQ(surface(*program_).presented, 1);
}

TEST_F(Frame, what_was_copied_here_is_pasted_where_the_clipboard_holds_something_else) {
  press(*program_, platform::Key::v);
  EXPECT_EQ(last_notice(*program_), "Nothing was copied: copy sections first.");
  place(*program_, world::ElementKind::straight);
  ASSERT_TRUE(apply(*program_, edit::Select{{{world::EntityKind::section, 1}}}).ok());
  press(*program_, platform::Key::c);
  surface(*program_).copied = "an address, perhaps";
  press(*program_, platform::Key::v);
  EXPECT_EQ(sections(*program_), 2u);
}

// A driver's compiler that rejects a shader shows only when a picture is drawn: the work until then is kept.
TEST_F(Frame, without_shaders_the_program_ends_with_the_code_of_the_graphics) {
  program_->gl.CompileShader = [](GLuint) {};
  EXPECT_EXIT((run_frame(*program_, {platform::Tick{1.0 / 60}}, 0), draw_pixels(*program_)),
              testing::ExitedWithCode(base::exit_code(base::Code::graphics)), "shader .*vert");
}

}  // namespace frame_test
}  // namespace coaster::app
