// The first steps.
#include "edit/commands/set_setting.h"
#include "ui/screens/overlays.h"
#include "ui/stage.h"
#include "world/aids.h"
#include "world/panels.h"

namespace coaster::ui {
namespace hints_test {

struct HintsTest : Stage {};

TEST_F(HintsTest, the_first_steps_show_where_they_leave_half_of_the_view_and_not_on_a_phone) {
  for (const world::Workspace workspace : {world::Workspace::build, world::Workspace::ride}) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{workspace}));
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Aids::show_hints>{true}));
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

}  // namespace hints_test
}  // namespace coaster::ui
