// The wheel loads in the Ride panel, and numbers of a ride without a train or a lap.
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/panels/panels.h"
#include "ui/stage.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace panel_ride_test {

constexpr const char* kRows[] = {"Ride/Front left", "Ride/Front right", "Ride/Rear left", "Ride/Rear right"};

struct PanelRideTest : Stage {
  // Road, up-stop and side wheels, kN.
  std::string loads(const char* row) {
    frames(2);
    const Widget* const found = find(row);
    return found ? found->value : "no row";
  }
};

TEST_F(PanelRideTest, wheels_of_a_train_at_rest_on_the_flat_carry_a_quarter_of_its_weight_each) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());
  EXPECT_EQ(loads(kRows[0]), "no row");
  for (const glm::vec3 place : {glm::vec3(0, 4, 0), glm::vec3(30, 4, 0)})
    ASSERT_TRUE(edit::apply(session_, files_, edit::AppendKnot{place}).ok());
  const world::EntityName train = world::name_of(session_.document, world::first_cart(session_.document));
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetTrain{{train}, 1, 0, 0, 2000}).ok());
  for (const char* const row : kRows) {
    EXPECT_EQ(loads(row), "4.9 0.0 0.0");
    EXPECT_TRUE(reach(row)) << row;
  }
}

TEST_F(PanelRideTest, without_a_train_nothing_of_the_ride_has_a_number) {
  const auto shown = [&](world::Workspace workspace, const char* path) {
    EXPECT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{workspace}).ok());
    frames(2);
    const Widget* const widget = find(path);
    return widget != nullptr ? widget->value : "no such widget";
  };
  EXPECT_NE(shown(world::Workspace::build, "Status/Speed"), "--");
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}).ok());
  EXPECT_EQ(shown(world::Workspace::build, "Status/Speed"), "--");
  EXPECT_EQ(shown(world::Workspace::build, "Status/g"), "--");
  EXPECT_EQ(shown(world::Workspace::build, "Status/Length").substr(0, 3), "0.0");
  EXPECT_EQ(shown(world::Workspace::ride, "Ride/Speed"), "--");
  EXPECT_EQ(shown(world::Workspace::all, "Ride/Energy"), "-- J/kg");
  EXPECT_EQ(shown(world::Workspace::all, "Ride/State"), "--");
}

TEST_F(PanelRideTest, a_lap_that_is_not_completed_has_no_time) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::LoadTrack{COASTER_SOURCE_DIR "/tracks/loop.json"}).ok());
  ASSERT_TRUE(reach("Goal"));
  click("Goal");
  frames(2);
  ASSERT_NE(find("Goal/Now"), nullptr);
  EXPECT_NE(find("Goal/Now")->value, "-- s");
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetClosed{false}).ok());
  frames(2);
  EXPECT_EQ(find("Goal/Now")->value, "-- s");
}

}  // namespace panel_ride_test
}  // namespace coaster::ui
