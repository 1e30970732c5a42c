// The tutorial in a window whose player leaves it at once.
#include "app/keeper.h"
#include "app/program_fixture.h"
#include "app/script_host.h"
#include "edit/commands/set_setting.h"
#include "world/panels.h"

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

}  // namespace tutorial_test
}  // namespace coaster::app
