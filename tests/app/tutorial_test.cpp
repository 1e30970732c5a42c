// The tutorial in a window: players who leave it at once, or build something else.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/frame.h"
#include "app/program_fixture.h"
#include "app/script_host.h"
#include "app/user_data_keeper.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::app {
namespace tutorial_test {

class TutorialTest : public ProgramTest {};

TEST_F(TutorialTest, settings_are_as_before_and_none_of_its_own_is_kept) {
  restart_drawing();
  Program& program = *program_;
  surface(program).window = true;
  start_keeping(program, {folder_ / "config", folder_ / "state"}, {}, false);
  ASSERT_TRUE(apply(program, edit::Set<&world::Panels::workspace>{world::Workspace::laboratory}).ok());
  ASSERT_TRUE(apply(program, edit::Set<&world::Panels::show_laboratory>{true}).ok());
  program.time.seconds = 1;
  keep(program);
  ASSERT_EQ(program.keeper->state.settings.session.panels->workspace, world::Workspace::laboratory);
  program.tutorial.wanted = true;
  teach(program);
  ASSERT_TRUE(program.tutorial.card) << last_notice(program);
  EXPECT_EQ(program.session.settings.panels->workspace, world::Workspace::build);
  teach(program);
  EXPECT_TRUE(program.tutorial.card) << "it waits for the player";
  program.tutorial.answer = query::LessonAnswer::leave;
  teach(program);
  EXPECT_FALSE(program.tutorial.card);
  EXPECT_TRUE(program.session.document.track.knots.empty()) << "it began: " << last_notice(program);
  EXPECT_EQ(program.session.settings.panels->workspace, world::Workspace::laboratory);
  EXPECT_TRUE(program.session.settings.panels->show_laboratory);
  EXPECT_EQ(program.keeper->state.settings.session.panels->workspace, world::Workspace::laboratory);
  EXPECT_TRUE(program.keeper->state.settings.session.panels->show_laboratory);
  stop_keeping(program, true);
}

// Answers "Show me" and draws frames until the lesson changes.
void show_lesson(Program& program) {
  const int number = program.tutorial.card->number;
  program.tutorial.answer = query::LessonAnswer::show;
  for (int i = 0; i < 60 && program.tutorial.card && program.tutorial.card->number == number; ++i) teach(program);
}

// A player who places the straight without its station, and more: "Show me" undoes that and does the step.
TEST_F(TutorialTest, show_me_helps_a_player_who_built_something_else) {
  restart_drawing();
  Program& program = *program_;
  surface(program).window = true;
  surface(program).resize({1280, 720});
  program.tutorial.wanted = true;
  teach(program);
  ASSERT_TRUE(program.tutorial.card) << last_notice(program);
  show_lesson(program);
  ASSERT_EQ(program.tutorial.card->number, 2);
  EXPECT_FALSE(program.tutorial.card->strayed);
  const world::Camera view = program.session.settings.camera;
  world::Element wrong = program.session.settings.element;
  ASSERT_TRUE(apply(program, edit::PlaceElement{wrong}).ok());
  wrong = world::usual_element(world::ElementKind::climb);
  ASSERT_TRUE(apply(program, edit::ChooseElement{wrong}).ok());
  ASSERT_TRUE(apply(program, edit::PlaceElement{wrong}).ok());
  ASSERT_TRUE(apply(program, edit::Set<&world::EditingAids::show_element>{false}).ok());
  ASSERT_TRUE(apply(program, edit::Set<&world::Panels::workspace>{world::Workspace::ride}).ok());
  ASSERT_TRUE(apply(program, edit::set_camera({.target = {900, 5, 0}})).ok());
  teach(program);
  ASSERT_TRUE(program.tutorial.card);
  EXPECT_TRUE(program.tutorial.card->strayed);
  show_lesson(program);
  ASSERT_TRUE(program.tutorial.card) << last_notice(program);
  EXPECT_EQ(program.tutorial.card->number, 3) << last_notice(program);
  EXPECT_FALSE(program.tutorial.card->strayed);
  EXPECT_TRUE(program.session.document.track.segments.empty());
  EXPECT_EQ(program.session.settings.element.kind, world::ElementKind::straight);
  EXPECT_EQ(program.session.settings.camera.target, view.target);
  show_lesson(program);
  ASSERT_TRUE(program.tutorial.card) << last_notice(program);
  EXPECT_EQ(program.session.document.track.segments.size(), 1u);
  // Who undoes too much gets it back.
  ASSERT_TRUE(apply(program, edit::Undo{}).ok());
  teach(program);
  EXPECT_TRUE(program.tutorial.card->strayed);
  show_lesson(program);
  ASSERT_TRUE(program.tutorial.card) << last_notice(program);
  EXPECT_EQ(program.session.document.track.segments.size(), 1u);
  EXPECT_EQ(program.session.settings.element.kind, world::ElementKind::climb);
}

// Clicks on "Show me" faster than frames: none of them mixes with those of the lesson.
TEST_F(TutorialTest, hasty_clicks_do_not_disturb_a_lesson) {
  restart_drawing();
  Program& program = *program_;
  surface(program).window = true;
  surface(program).resize({1280, 720});
  program.tutorial.wanted = true;
  const auto frame = [&](platform::Events events) {
    events.emplace_back(platform::Tick{1.0 / 5});
    run_frame(program, events, 0);
    teach(program);
  };
  const auto click = [&](int times) {
    const auto& widgets = program.ui->widgets();
    const auto button = std::ranges::find_if(widgets, [](const query::Widget& w) { return w.is("Lesson/Show me"); });
    ASSERT_NE(button, widgets.end());
    const platform::MouseMove there{button->x + button->width / 2, button->y + button->height / 2};
    platform::Events events{there};
    for (int i = 0; i < times; ++i)
      for (const bool down : {true, false}) {
        events.emplace_back(there);
        events.emplace_back(platform::MouseButton{platform::Button::left, down, {}});
      }
    frame(events);
    for (int i = 0; i < 12; ++i) frame({});
  };
  frame({});
  for (int i = 0; i < 3; ++i) frame({});
  const float yaw = program.session.settings.camera.yaw_deg;
  click(3);
  ASSERT_TRUE(program.tutorial.card);
  EXPECT_EQ(program.tutorial.card->number, 2) << "three clicks before it answers show one lesson";
  const float turned = program.session.settings.camera.yaw_deg;
  EXPECT_NE(turned, yaw);
  click(2);
  ASSERT_TRUE(program.tutorial.card);
  EXPECT_EQ(program.tutorial.card->number, 3);
  EXPECT_TRUE(program.session.settings.aids->show_element);
  EXPECT_EQ(program.session.settings.camera.yaw_deg, turned);
  EXPECT_TRUE(program.session.history.undo.empty()) << "no click went through the card";
}

// Data of another place may lack the tutorial, or have one that this program cannot read.
TEST_F(TutorialTest, a_tutorial_that_is_missing_or_broken_is_told_and_changes_nothing) {
  const char* const before = std::getenv("COASTER_DATA");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("COASTER_DATA", folder_.c_str(), 1);
  Program& program = *program_;
  const world::Settings settings = program.session.settings;
  const auto expect_refused = [&](const std::string& words) {
    program.tutorial.wanted = true;
    teach(program);
    EXPECT_FALSE(program.tutorial.run);
    EXPECT_FALSE(program.tutorial.card);
    EXPECT_NE(last_notice(program).find(words), std::string::npos) << last_notice(program);
    EXPECT_TRUE(program.session.settings == settings);
  };
  expect_refused("first_coaster.coaster");
  std::filesystem::create_directories(folder_ / "tutorials");
  std::ofstream(folder_ / "tutorials" / "first_coaster.coaster") << "coaster-script 1\nno_such_word 3\n";
  expect_refused("no_such_word");
  if (before != nullptr) ::setenv("COASTER_DATA", kept.c_str(), 1);
  else ::unsetenv("COASTER_DATA");
}

}  // namespace tutorial_test
}  // namespace coaster::app
