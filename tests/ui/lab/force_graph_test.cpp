// The force graph of Build (ui/lab/strips.h).
#include "ui/lab/strips.h"

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace force_graph_test {

struct ForceGraphTest : Stage {
  void place(world::ElementKind kind, double equipment) {
    world::Element element = world::usual_elements()[static_cast<std::size_t>(kind)];
    world::set_value(element, "equipment", equipment);
    ASSERT_TRUE(edit::apply(session_, files_, edit::PlaceElement{element}));
    frames(3);
  }
  std::string end_of_ride() const {
    const Widget* const shown = find("Forces/Ride ends");
    return shown != nullptr ? shown->value : "";
  }
};

TEST_F(ForceGraphTest, says_where_the_ride_ends_before_the_track_does) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::NewTrack{}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  resize(1280, 720);
  constexpr double kNone = 0, kLift = 2;
  place(world::ElementKind::straight, kNone);
  EXPECT_EQ(end_of_ride(), "") << "it runs off the end of the track, which is there to be built on";
  place(world::ElementKind::climb, kNone);
  // The climb's bend is a circle of at least 20 m behind a ramp: at 1 m/s the train rises 51 mm, some metres into it.
  double metres = 0;
  EXPECT_EQ(std::sscanf(end_of_ride().c_str(), "The train rolls back at %lf m", &metres), 1) << end_of_ride();
  EXPECT_GT(metres, 31);
  EXPECT_LT(metres, 38);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Undo{}));
  place(world::ElementKind::climb, kLift);
  EXPECT_EQ(end_of_ride(), "");
}

}  // namespace force_graph_test
}  // namespace coaster::ui
