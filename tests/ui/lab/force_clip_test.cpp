// Force keys copied and pasted with the keyboard; tests/scripts/force_copy.coaster also pastes them.
#include "ui/lab/force_key_editor.h"

#include "edit/commands/commands_force_sections.h"
#include "edit/commands/set_setting.h"
#include "ui/sections_stage.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace force_clip_test {

using platform::Key;
using world::ForceChannel;

class ForceClipTest : public SectionsStage {
 protected:
  void SetUp() override {
    Stage::SetUp();
    good(edit::NewTrack{});
    good(edit::SetStartSpeed{20});
    good(edit::PlaceElement{world::usual_element(world::ElementKind::straight)});
    good(edit::AddForceSection{world::ForceDomain::distance, 40, 0.1});
    for (const double at : {5.0, 20.0})
      good(edit::SetForceKey{{{world::EntityKind::section, 2}}, false, ForceChannel::vertical, 1, at});
    good(edit::Set<&world::Panels::workspace>{world::Workspace::build});
    good(edit::Select{{{world::EntityKind::section, 2}}});
    frames(3);
    commands_.clear();
  }
};

TEST_F(ForceClipTest, the_chosen_key_or_with_shift_the_channel_is_copied) {
  key(Key::tab);
  key(Key::c, {.ctrl = true});
  ASSERT_EQ(all<edit::CopyForceKeys>().size(), 1u);
  EXPECT_EQ(all<edit::CopyForceKeys>()[0].from, 5);
  EXPECT_EQ(all<edit::CopyForceKeys>()[0].to, 5);
  EXPECT_EQ(session_.copied, R"({"force-keys": "distance", "keys": [[5, 1]]})");
  key(Key::c, {.shift = true, .ctrl = true});
  EXPECT_EQ(session_.copied, R"({"force-keys": "distance", "keys": [[5, 1], [20, 1]]})");
  EXPECT_TRUE(all<edit::CopySection>().empty());
}

TEST_F(ForceClipTest, without_a_chosen_key_the_section_is_copied) {
  key(Key::c, {.ctrl = true});
  EXPECT_TRUE(all<edit::CopyForceKeys>().empty());
  EXPECT_EQ(all<edit::CopySection>().size(), 1u);
}

}  // namespace force_clip_test
}  // namespace coaster::ui
