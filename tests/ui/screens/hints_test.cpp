// The first steps.
#include <algorithm>
#include <utility>

#include "edit/commands/set_setting.h"
#include "ui/actions/actions.h"
#include "ui/screens/hud.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace hints_test {

struct HintsTest : Stage {};

TEST_F(HintsTest, the_first_steps_show_where_they_leave_half_of_the_view_and_not_on_a_phone) {
  for (const world::Workspace workspace : {world::Workspace::build, world::Workspace::ride}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{workspace}));
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_hints>{true}));
    const struct {
      int width, height;
      float density;
      bool shown;
    } kScreens[] = {{1280, 720, 1, true}, {1024, 768, 1, true}, {1920, 1080, 1, true}, {2048, 1536, 2, true},
                    {844, 390, 1, false}, {800, 360, 1, false}, {2532, 1170, 3, false}};
    for (const auto& screen : kScreens) {
      density_ = screen.density;
      resize(screen.width, screen.height);
      const Widget* const button = find("Hints/Got it");
      EXPECT_EQ(button != nullptr, screen.shown) << screen.width << "x" << screen.height;
    }
  }
}

TEST_F(HintsTest, the_first_steps_are_those_of_the_workspace) {
  using world::Workspace;
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_hints>{true}));
  resize(1920, 1080);
  const std::pair<std::string, std::vector<Workspace>> kSteps[] = {
      {"Palette", {Workspace::build}},
      {"G R S", {Workspace::build}},
      {"1 2 3", {Workspace::ride}},
      {"Space", {Workspace::build, Workspace::ride}},
      {"M", {Workspace::laboratory}},
      {"E", {Workspace::laboratory}},
      {"F8", {Workspace::ride, Workspace::laboratory}},
      {"Ctrl+P", {Workspace::build, Workspace::ride, Workspace::laboratory}}};
  for (const Workspace workspace : {Workspace::build, Workspace::ride, Workspace::laboratory}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{workspace}));
    frames(3);
    ASSERT_NE(find("Hints/Got it"), nullptr) << base::name_of(workspace);
    for (const auto& [step, where] : kSteps)
      EXPECT_EQ(find("Hints/" + step) != nullptr, std::find(where.begin(), where.end(), workspace) != where.end())
          << step << " in " << base::name_of(workspace);
  }
}

TEST(foot_text, of_an_empty_track_names_the_palette_only_where_it_shows) {
  const ViewportTool tool;
  edit::Session session = edit::make_session({});
  base::Files files;
  std::vector<std::string> problems;
  const KeyMap keys = KeyMap::make(key_rows(), {}, problems);
  for (const world::Workspace workspace :
       {world::Workspace::all, world::Workspace::build, world::Workspace::ride, world::Workspace::laboratory}) {
    ASSERT_TRUE(edit::apply(session, files, edit::Set<&world::Panels::workspace>{workspace}));
    const bool palette = workspace == world::Workspace::all || workspace == world::Workspace::build;
    const std::string text = foot_text(tool, session, keys);
    EXPECT_EQ(text.starts_with("Choose an element"), palette) << text;
    EXPECT_EQ(text.starts_with("F8 shows the elements"), !palette) << text;
    EXPECT_NE(text.find("click on the ground"), std::string::npos) << text;
  }
}

}  // namespace hints_test
}  // namespace coaster::ui
