// Losses in the Operation panel.
#include "edit/commands/commands_operation.h"
#include "ui/panels/panels.h"
#include "ui/stage.h"

namespace coaster::ui {
namespace panel_operation_test {

struct PanelOperationTest : Stage {
  std::string shown() {
    frames(2);
    const Widget* const box = find("Operation/Losses");
    return box ? box->value : "no box";
  }
};

TEST_F(PanelOperationTest, a_set_of_losses_is_chosen_by_its_name) {
  EXPECT_EQ(shown(), "Frictionless");
  click("Operation/Losses");
  EXPECT_EQ(find("Operation/Losses/Own"), nullptr);
  click("Operation/Losses/KexEdit");
  ASSERT_EQ(all<edit::SetLossSet>().size(), 1u);
  EXPECT_EQ(session_.document.resistance, (world::Losses{0.021f, 2e-5f}));
  EXPECT_EQ(shown(), "KexEdit");
}

TEST_F(PanelOperationTest, numbers_of_no_set_are_own_and_own_changes_nothing) {
  type("Operation/Rolling", "0.025");
  EXPECT_EQ(shown(), "Own");
  click("Operation/Losses");
  click("Operation/Losses/Own");
  EXPECT_TRUE(all<edit::SetLossSet>().empty());
  type("Operation/Rolling", "0.03");
  type("Operation/Drag", "0.00002");
  EXPECT_EQ(shown(), "openFVD");
}

}  // namespace panel_operation_test
}  // namespace coaster::ui
