// The legend of the track's colours (ui/screens/hud.h).
#include <imgui.h>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace legend_test {

class LegendTest : public Stage {
 protected:
  // Vertices of a frame without panels.
  int vertices_with(world::Colouring colouring, bool legend) {
    EXPECT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::show_panels>{false}));
    EXPECT_TRUE(edit::apply(session_, files_, edit::Set<&world::LabView::colouring>{colouring}));
    EXPECT_TRUE(edit::apply(session_, files_, edit::ShowLayer{world::Layer::legend, legend}));
    frames(3);
    return ImGui::GetDrawData()->TotalVtxCount;
  }
};

TEST_F(LegendTest, shows_beside_colours_that_are_numbers_and_hides_with_its_layer) {
  stats_.colour_high = 25;
  resize(640, 360);
  const int plain = vertices_with(world::Colouring::plain, true);
  EXPECT_GT(vertices_with(world::Colouring::speed, true), plain + 50);  // a bar and some ten letters and digits
  EXPECT_EQ(vertices_with(world::Colouring::speed, false), plain);
}

}  // namespace legend_test
}  // namespace coaster::ui
