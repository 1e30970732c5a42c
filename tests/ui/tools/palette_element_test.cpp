// Choosing and placing the element of the palette (ui/tools/show_places.h).
#include "ui/tools/show_places.h"

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace palette_element_test {

struct PaletteElementTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
    show(world::Workspace::build);
  }
  void show(world::Workspace workspace) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{workspace}));
    frames(3);
  }
  // Returns the equipment of the preview after a click: 0 for none, 1 and more for the kinds.
  double offered(const std::string& button) {
    click("Elements/" + button);
    frames(2);
    return world::value_of(session_.settings.element, "equipment");
  }
  void place() {
    key(platform::Key::enter);
    frames(2);
  }
};

constexpr double kNone = 0, kStation = 1, kLift = 2, kLaunch = 3;

TEST_F(PaletteElementTest, a_first_straight_is_a_station_and_a_first_climb_a_lift) {
  EXPECT_EQ(offered("Straight"), kStation);
  place();
  EXPECT_EQ(world::value_of(session_.settings.element, "equipment"), kNone) << "the second straight";
  EXPECT_EQ(offered("Climb"), kLift);
  place();
  EXPECT_EQ(world::value_of(session_.settings.element, "equipment"), kNone) << "the second climb";
  EXPECT_EQ(offered("Straight"), kNone);
  EXPECT_EQ(offered("Climb"), kNone);
  EXPECT_EQ(all<edit::PlaceElement>().size(), 2u);
}

TEST_F(PaletteElementTest, the_keyboard_begins_with_a_station_too) {
  key(platform::Key::n);
  frames(2);
  EXPECT_EQ(session_.settings.element.kind, world::ElementKind::straight);
  EXPECT_EQ(world::value_of(session_.settings.element, "equipment"), kStation);
  place();
  key(platform::Key::n);
  frames(2);
  EXPECT_EQ(session_.settings.element.kind, world::ElementKind::curve);
}

TEST_F(PaletteElementTest, a_launch_needs_no_lift_behind_it) {
  EXPECT_EQ(offered("Climb"), kLift) << "the train has no other drive yet";
  EXPECT_EQ(offered("Straight"), kStation);
  world::Element launch = session_.settings.element;
  world::set_value(launch, "equipment", kLaunch);
  ASSERT_TRUE(edit::apply(session_, files_, edit::ChooseElement{launch}));
  frames(2);
  place();
  world::Element climb = world::usual_elements()[static_cast<std::size_t>(world::ElementKind::climb)];
  ASSERT_TRUE(edit::apply(session_, files_, edit::ChooseElement{climb}));
  frames(2);
  EXPECT_EQ(offered("Straight"), kNone);
  EXPECT_EQ(offered("Climb"), kNone);
}

TEST_F(PaletteElementTest, what_is_not_placed_keeps_its_equipment) {
  build_track(session_, files_);
  EXPECT_EQ(offered("Climb"), kLift);
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetClosed{true}));  // nothing fits into a closed track
  frames(2);
  place();
  EXPECT_EQ(world::value_of(session_.settings.element, "equipment"), kLift);
}

// Scripts start there, and choose equipment themselves.
TEST_F(PaletteElementTest, other_workspaces_offer_plain_track) {
  show(world::Workspace::all);
  EXPECT_EQ(offered("Straight"), kNone);
}

}  // namespace palette_element_test
}  // namespace coaster::ui
