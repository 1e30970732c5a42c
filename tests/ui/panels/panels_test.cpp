#include "ui/panels/panels.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "curve/evaluators.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace panels_test {

struct PanelsTest : Stage {};

// Whatever the column was scrolled to, what a click chooses is in sight: the parameters of an element, the closing
// sections, the section.
TEST_F(PanelsTest, the_parameters_begin_with_what_was_just_chosen) {
  resize(1280, 720);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}).ok());
  frames(3);
  const auto scroll_down = [&] {
    const view::Viewport& scene = host_->view().viewport;
    hover({scene.x - 60, scene.y + scene.height - 40});
    for (int i = 0; i < 5; ++i) frame({platform::Wheel{0, -10}});
    frames(3);
  };
  const auto in_sight = [&](const std::string& path) {
    const Widget* const widget = find(path);
    return widget != nullptr && widget->visible;
  };
  select(world::EntityKind::knot, 2);
  frames(3);
  scroll_down();
  ASSERT_FALSE(in_sight("Inspector/Selected")) << "it is scrolled away";
  click("Elements/Climb");
  frames(3);
  EXPECT_TRUE(in_sight("Elements/Height"));
  scroll_down();
  ASSERT_FALSE(in_sight("Elements/Height"));
  click("Elements/Complete circuit");
  frames(3);
  EXPECT_TRUE(in_sight("Elements"));
  key(platform::Key::escape);
  key(platform::Key::escape);
  select(world::EntityKind::knot, 2);
  frames(3);
  scroll_down();
  select(world::EntityKind::section, 1);
  frames(3);
  EXPECT_TRUE(in_sight("Section/Title"));
  scroll_down();
  frames(3);
  EXPECT_FALSE(in_sight("Section/Title")) << "a panel that stays is left where it was scrolled to";
}

// In Build the column begins with the element that is placed, then what is selected; a challenge is above the track
// alone.
TEST_F(PanelsTest, panels_are_in_the_order_of_what_was_chosen) {
  resize(1280, 1400);
  const std::string path = COASTER_SOURCE_DIR "/challenges/01_first_hill.json";
  ASSERT_TRUE(edit::apply(session_, files_, edit::StartChallenge{path}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  const auto order = [&] {
    frames(3);
    std::vector<Widget> headers;
    for (const Widget& w : host_->widgets())
      if (w.kind == "header" && w.x < host_->view().viewport.x) headers.push_back(w);
    std::ranges::sort(headers, {}, &Widget::y);
    std::vector<std::string> names;
    for (const Widget& w : headers) names.push_back(w.path);
    return names;
  };
  const auto first = [&](const std::string& name) {
    const std::vector<std::string> names = order();
    return std::ranges::find(names, name) - names.begin();
  };
  const auto count = [&] { return static_cast<std::ptrdiff_t>(order().size()); };
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{}));
  EXPECT_EQ(first("Challenge"), 0);
  EXPECT_LT(first("Track"), count()) << "shows, below";
  for (const auto& [kind, number, panel] : {std::tuple{world::EntityKind::knot, 2u, "Inspector"},
                                            {world::EntityKind::segment, 1u, "Inspector"},
                                            {world::EntityKind::section, 1u, "Section"}}) {
    select(kind, number);
    EXPECT_EQ(first(panel), 0) << panel << " of " << number;
    EXPECT_TRUE(first("Challenge") > 0) << panel;
  }
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::show_element>{true}));
  EXPECT_EQ(first("Elements"), 0);
  EXPECT_LT(first("Elements"), first("Section"));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{}));
  EXPECT_EQ(first("Elements"), 0);
}

TEST_F(PanelsTest, every_panel_draws_and_paths_are_unique_for_every_selection) {
  edit::ActiveChallenge& challenge = session_.game.challenge.emplace();  // whose panel is there for it alone
  challenge.file.name = "Three", challenge.file.teaches = "How to count.";
  challenge.file.rules[0] = {{"knots <= 3", "Three knots"}};
  for (const auto& [kind, number] : {std::pair{world::EntityKind::knot, 2u},
                                     {world::EntityKind::segment, 1u},
                                     {world::EntityKind::cart, 1u},
                                     {world::EntityKind::section, 1u}}) {
    select(kind, number);
    std::set<std::string> paths;
    for (const Widget& widget : host_->widgets()) {
      EXPECT_TRUE(paths.insert(widget.path).second) << widget.path << " twice";
      EXPECT_TRUE(widget.alias.empty() || paths.insert(widget.alias).second) << widget.alias << " twice";
    }
    for (const Panel& panel : panels()) {
      const std::string start = std::string(panel.name) + "/";
      if (panel.name == "Section" && kind != world::EntityKind::section) {
        EXPECT_FALSE(paths.contains("Section")) << "it is there for a section alone";
        continue;
      }
      const auto inside = [&](const std::string& path) { return path.starts_with(start); };
      // Those that are folded at first: tests/scripts/shape.coaster.
      EXPECT_EQ(std::any_of(paths.begin(), paths.end(), inside), panel.open) << panel.name;
      EXPECT_TRUE(paths.contains(std::string(panel.name))) << "no header of " << panel.name;
    }
  }
}

TEST_F(PanelsTest, labels_that_scripts_use_are_there) {
  select(world::EntityKind::knot, 2);
  for (const char* path : {"Track/Name",
                           "Track/Closed",
                           "Track/Add curve",
                           "Track/Insert point",
                           "Track/Delete",
                           "Track/Append points",
                           "Track/Add cart",
                           "Track/Start speed",
                           "Track/Datum",
                           "Track/New",
                           "Track/File",
                           "Track/Open",
                           "Track/Save",
                           "Inspector/Position/x",
                           "Inspector/Position/y",
                           "Inspector/Position/z",
                           "Inspector/Direction/x",
                           "Inspector/Handles/in",
                           "Inspector/Handles/out",
                           "Inspector/Roll",
                           "Inspector/Joint",
                           "Evaluation/Steps per segment",
                           "Evaluation/Vertex budget",
                           "Evaluation/Show polyline",
                           "Evaluation/Arc length",
                           "Ride/Play",
                           "Ride/Pause",
                           "Ride/Step",
                           "Ride/Reset",
                           "Ride/Frenet-Serret",
                           "Ride/Rotation-minimising",
                           "Ride/Integrator",
                           "Camera/Orbit",
                           "Camera/Ride",
                           "Camera/Chase",
                           "Camera/Fly",
                           "Camera/Field of view",
                           "Camera/Roll damping",
                           "Camera/Head-bob",
                           "Camera/Reduced motion",
                           "Menu/File",
                           "Menu/Edit",
                           "Menu/View",
                           "Menu/Ride"})
    EXPECT_NE(find(path), nullptr) << path;
  for (const auto& row : curve::evaluators())
    EXPECT_NE(find("Evaluation/" + std::string(row.label)), nullptr) << row.label;
  EXPECT_EQ(find("Inspector/Nothing selected"), nullptr);
}

TEST_F(PanelsTest, every_widget_can_be_scrolled_to_in_a_small_window_and_lies_in_a_column) {
  resize(640, 360);
  select(world::EntityKind::knot, 2);
  std::vector<std::string> paths;
  for (const Widget& widget : host_->widgets()) paths.push_back(widget.path);
  for (const std::string& path : paths) {
    ASSERT_TRUE(reach(path)) << path;
    const Widget& w = *find(path);
    EXPECT_FALSE(w.covered) << path;
    const view::Viewport& scene = host_->view().viewport;
    EXPECT_TRUE(w.x + w.width <= scene.x + 0.5f || w.x >= scene.x + scene.width || w.y + w.height <= scene.y ||
                w.y >= scene.y + scene.height - 0.5f)
        << path << " lies over the viewport";
    EXPECT_GE(w.x, 0) << path;
    EXPECT_LE(w.x + w.width, 640.5f) << path;
  }
}

TEST_F(PanelsTest, the_same_frame_again_asks_for_nothing) {
  select(world::EntityKind::segment, 2);
  commands_.clear();
  frames(5);
  EXPECT_TRUE(commands_.empty()) << commands_.size();
}

TEST_F(PanelsTest, times_are_hidden_from_scripts) {
  stats_.fps = 61.7;
  stats_.cpu_ms = 3.21;
  frames(2);
  EXPECT_EQ(find("Statistics/Frames per second")->value, "62 fps");
  scripted_ = true;
  frames(2);
  EXPECT_EQ(find("Statistics/Frames per second")->value, "-- fps");
  EXPECT_EQ(find("Statistics/Frame")->value, "-- ms");
}

TEST_F(PanelsTest, a_new_hint_of_a_challenge_comes_into_sight) {
  const std::string path = COASTER_SOURCE_DIR "/challenges/01_first_hill.json";
  ASSERT_TRUE(edit::apply(session_, files_, edit::StartChallenge{path}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  resize(1280, 720);
  for (const char* hint : {"Challenge/Hint 1", "Challenge/Hint 2"}) {
    EXPECT_EQ(find(hint), nullptr);
    click("Challenge/Hint");
    frames(4);
    ASSERT_NE(find(hint), nullptr);
    EXPECT_TRUE(find(hint)->visible) << hint;
  }
}

TEST_F(PanelsTest, the_hint_button_tells_how_many_are_left) {
  const std::string path = COASTER_SOURCE_DIR "/challenges/01_first_hill.json";
  ASSERT_TRUE(edit::apply(session_, files_, edit::StartChallenge{path}));
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::Panels::workspace>{world::Workspace::build}));
  resize(1280, 720);
  const auto all_hints = static_cast<int>(session_.game.challenge->file.hints.size());
  ASSERT_GT(all_hints, 1);
  for (int left = all_hints; left >= 0; --left) {
    EXPECT_EQ(find("Challenge/Hint")->enabled, left > 0) << left;
    const std::string words = words_over("Challenge/Hint");
    EXPECT_NE(words.find(left > 0 ? std::to_string(left) + " left." : "No more hints."), std::string::npos) << words;
    hover({640, 300});
    if (left > 0) click("Challenge/Hint");
    frames(4);
  }
}

TEST_F(PanelsTest, insert_point_needs_a_segment_and_splits_it_at_the_picked_place) {
  frames(2);
  EXPECT_FALSE(find("Track/Insert point")->enabled);
  ASSERT_TRUE(edit::apply(session_, files_, edit::Select{{{world::EntityKind::segment, 2}}, 0.37}).ok());
  click("Track/Insert point");
  ASSERT_EQ(all<edit::SplitSegment>().size(), 1u);
  EXPECT_EQ(all<edit::SplitSegment>()[0].at, 0.37);
  EXPECT_EQ(session_.document.track.knots.size(), 4u);
}

TEST_F(PanelsTest, ride_buttons_start_hold_and_reset) {
  click("Ride/Play");
  EXPECT_EQ(session_.motion.state, world::RideState::running);
  click("Ride/Pause");
  EXPECT_EQ(session_.motion.state, world::RideState::paused);
  click("Ride/Step");
  EXPECT_EQ(all<edit::RideStep>().size(), 1u);
  click("Ride/Reset");
  EXPECT_EQ(session_.motion.state, world::RideState::stopped);
}

}  // namespace panels_test
}  // namespace coaster::ui
