// The window in the user's units: displayed values, and the meaning of typed numbers.
#include "base/units.h"

#include <cmath>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "edit/commands/set_setting.h"
#include "ui/panels/panels.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace units_test {

struct UnitsTest : Stage {
  template <auto Setting, class T>
  void set(T to) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<Setting>{to}).ok());
    frames(2);
  }
  void show_in(base::UnitSystem units) { set<&world::Appearance::units>(units); }

  // Paths and values of the widgets of this frame that have a metric unit. The names of a challenge's rules are what
  // its file calls them.
  void add_metric(std::vector<std::string>& found) const {
    static const std::regex kMetric("(^|[0-9. (])(mm|cm|m|km|m/s|m/s\u00B2|km/h|1/m|\u00B0/m)($|[ ).,;])");
    for (const Widget& widget : host_->widgets()) {
      const bool rule = widget.path.starts_with("Challenge/");
      if ((!rule && std::regex_search(widget.path, kMetric)) || std::regex_search(widget.value, kMetric))
        found.push_back(widget.path + " = " + widget.value);
    }
  }
  // The same of every panel and every page, for every kind of selection, with a preview and after a ride.
  std::vector<std::string> metric_widgets() {
    std::vector<std::string> found;
    for (const Panel& panel : panels()) {
      const Widget* const header = find(std::string(panel.name));
      if (header != nullptr && header->value == "closed") click(std::string(panel.name));
    }
    for (const auto& [kind, number] : {std::pair{world::EntityKind::knot, 2u},
                                       {world::EntityKind::segment, 1u},
                                       {world::EntityKind::cart, 1u},
                                       {world::EntityKind::section, 1u}}) {
      select(kind, number);
      add_metric(found);
    }
    for (std::size_t page = 0; page < std::size(world::kLabPages); ++page) {
      set<&world::LabView::page>(static_cast<world::LabPage>(page));
      add_metric(found);
    }
    return found;
  }
};

TEST_F(UnitsTest, in_feet_no_panel_shows_a_metric_unit) {
  resize(1920, 1080);
  edit::ActiveChallenge& challenge = session_.game.challenge.emplace();
  challenge.file.name = "Long", challenge.file.teaches = "How to build 30 m of track.";
  challenge.file.rules[0] = {{"length >= 30", "At least 30 m of track"}};
  set<&world::Panels::show_laboratory>(true);
  set<&world::EditingAids::show_element>(true);
  set<&world::EditingAids::show_card>(true);
  ASSERT_TRUE(edit::apply(session_, files_, edit::RideStart{}).ok());
  edit::advance(session_, 120 * 120);
  ASSERT_TRUE(session_.game.result);
  frames(2);
  click("Score/Details");
  frames(2);
  EXPECT_GE(metric_widgets().size(), 40u);
  show_in(base::UnitSystem::feet);
  for (const std::string& widget : metric_widgets()) ADD_FAILURE() << widget;
  const auto ends_in = [&](const char* path, const char* unit) {
    const Widget* const widget = find(path);
    ASSERT_NE(widget, nullptr) << path;
    EXPECT_TRUE(widget->value.ends_with(unit)) << path << " = " << widget->value;
  };
  ends_in("Status/Length", " ft");
  ends_in("Status/Speed", " mph");
  ends_in("Score/Highest drop", " ft");
  ends_in("Score/Top speed", " mph");
  EXPECT_NE(find("Challenge/Teaches")->value.find("98.4 ft"), std::string::npos) << find("Challenge/Teaches")->value;
}

TEST_F(UnitsTest, a_number_is_typed_in_the_shown_unit_or_in_any) {
  show_in(base::UnitSystem::feet);
  select(world::EntityKind::knot, 2);
  const std::pair<const char*, float> cases[]{{"33", 10.0584f}, {"10 m", 10.0f}, {"1 ft + 12 in", 0.6096f}};
  for (const auto& [typed, metres] : cases) {
    commands_.clear();
    type("Inspector/Position/x", typed);
    ASSERT_EQ(all<edit::MoveKnot>().size(), 1u) << typed;
    EXPECT_EQ(knot(2).position.x, metres) << typed;
  }
  EXPECT_EQ(find("Inspector/Position/x")->value, "2.000");
  show_in(base::UnitSystem::kmh);
  type("Track/Start speed", "90");
  EXPECT_EQ(session_.document.start_speed, 25);
  type("Track/Start speed", "20 m/s");
  EXPECT_EQ(session_.document.start_speed, 20);
  EXPECT_EQ(find("Track/Start speed")->value, "72.00");
}

TEST_F(UnitsTest, a_typed_move_counts_in_the_shown_unit) {
  show_in(base::UnitSystem::feet);
  select(world::EntityKind::knot, 2);
  const float height = knot(2).position.y;
  hover(empty_ground());
  key(platform::Key::g);
  key(platform::Key::y);
  key(static_cast<platform::Key>(static_cast<int>(platform::Key::d0) + 2));
  key(platform::Key::enter);
  frame();
  EXPECT_NEAR(knot(2).position.y, height + 0.6096f, 1e-6f);
}

TEST_F(UnitsTest, limits_hold_in_every_unit_without_a_notice) {
  show_in(base::UnitSystem::feet);
  select(world::EntityKind::knot, 2);
  type("Inspector/Position/x", "100000 m");
  frame();
  EXPECT_EQ(knot(2).position.x, world::kMaxCoordinate);
  EXPECT_EQ(host_->toast().find("limit"), std::string::npos) << host_->toast();
  type("Inspector/Position/x", "1e39");
  frame();
  EXPECT_EQ(knot(2).position.x, world::kMaxCoordinate);
  EXPECT_NE(host_->toast().find("limit"), std::string::npos) << host_->toast();
}

TEST_F(UnitsTest, the_cursor_of_a_plot_is_in_the_shown_unit_and_moves_in_round_steps_of_it) {
  set<&world::Panels::show_laboratory>(true);
  set<&world::LabView::page>(world::LabPage::frames);
  select(world::EntityKind::segment, 1);
  const curve::ArcLengthMap& arc = session_.derived.shape(entity(world::EntityKind::segment, 1)).arc;
  const auto shown = [&] {
    const Widget* const plot = find("Laboratory/Curvature plot");
    return plot != nullptr ? std::strtod(plot->value.c_str(), nullptr) : -1;
  };
  const double metres = arc.distance(session_.settings.selected_t);
  EXPECT_NEAR(shown(), metres, 1e-3);
  show_in(base::UnitSystem::feet);
  EXPECT_NEAR(shown(), metres / 0.3048, 1e-3);
  click("Laboratory/Curvature plot");
  frames(2);
  const double feet = arc.distance(session_.settings.selected_t) / 0.3048;
  EXPECT_GT(std::abs(feet - metres / 0.3048), 1e-3) << "a click moves it to the middle of the axis";
  EXPECT_NEAR(feet * 20, std::round(feet * 20), 1e-3) << feet;
}

}  // namespace units_test
}  // namespace coaster::ui
