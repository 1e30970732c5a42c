// The page Riders (ui/lab/ride_plots.cpp).
#include <cstdlib>
#include <sstream>

#include "edit/commands/codec.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/set_setting.h"
#include "sim/study/riders.h"
#include "ui/stage.h"
#include "world/appearance_settings.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace riders_test {

struct RidersTest : Stage {
  void SetUp() override {
    Stage::SetUp();
    run("start_speed 15");
    run("train @c1 cars 4 spacing 2");
    set<&world::Panels::show_laboratory>(true);
    set<&world::LabView::page>(world::LabPage::riders);
    set<&world::Panels::laboratory_height>(0.75f);
    resize(1920, 1080);
    frames(2);
    commands_.clear();
  }
  void run(const std::string& line) {
    std::vector<base::Token> tokens;
    base::TextError error;
    ASSERT_TRUE(base::tokenise(line, tokens, error));
    const auto command = edit::parse(tokens, error);
    ASSERT_TRUE(command) << error.message;
    ASSERT_TRUE(edit::apply(session_, files_, *command).ok()) << line;
  }
  template <auto Member>
  void set(world::ValueOf<Member> to) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<Member>{to}).ok());
    frames(2);
  }
  glm::vec2 at(const std::string& plot, float part) {
    EXPECT_TRUE(reach(plot)) << plot;
    const Widget& w = *find(plot);
    return {w.x + part * w.width, w.y + w.height / 2};
  }
  double shown(const std::string& path) {
    const Widget* const widget = find(path);
    return widget != nullptr ? std::strtod(widget->value.c_str(), nullptr) : NAN;
  }
  double train() const { return session_.motion.carts.items()[0].track_distance; }
  double value_at(int car, double distance, sim::RideValue value) {
    return sim::value_at(edit::SessionFindings(session_).riders()->car(car), distance, value).value_or(NAN);
  }
};

TEST_F(RidersTest, every_axis_has_a_plot_that_can_be_read) {
  for (const char* name :
       {"Vertical g", "Lateral g", "Longitudinal g", "Jerk", "Roll rate", "Roll acceleration", "Speed", "Height"}) {
    const std::string path = std::string("Laboratory/") + name + " plot";
    ASSERT_TRUE(reach(path)) << path;
    EXPECT_GE(find(path)->height, 110) << path;  // of the data alone
    EXPECT_GE(find(path)->width, 280) << path;
  }
}

TEST_F(RidersTest, a_value_that_hardly_changes_is_a_flat_line_and_not_noise) {
  run("new");
  for (const char* line : {"append at 0 4 0", "append at 40 4.0003 0", "append at 80 4 0.0002", "add_cart @s1 at 0.1"})
    run(line);
  const auto least_step = [&](const char* plot) {
    const std::string path = std::string("Laboratory/") + plot + " plot/axes";
    EXPECT_TRUE(reach(path)) << path;
    std::vector<double> ticks;
    std::istringstream words(find(path)->value.substr(find(path)->value.rfind(')') + 1));
    for (double tick; words >> tick;) ticks.push_back(tick);
    EXPECT_GE(ticks.size(), 2u) << find(path)->value;
    return ticks.size() < 2 ? 0 : ticks[1] - ticks[0];
  };
  EXPECT_GE(least_step("Vertical g"), 0.1);
  EXPECT_GE(least_step("Lateral g"), 0.1);
  EXPECT_GE(least_step("Jerk"), 0.2);
  EXPECT_GE(least_step("Roll rate"), 1);
  EXPECT_GE(least_step("Height"), 0.2);
  run("start_speed 0.5");
  set<&world::Appearance::units>(base::UnitSystem::feet);
  EXPECT_GE(least_step("Height"), 0.5) << "1 m is 3.3 ft";
}

TEST_F(RidersTest, the_legend_has_the_value_at_the_train_with_its_unit) {
  const auto value = [&](const char* plot) {
    const std::string path = std::string("Laboratory/") + plot + "/value";
    EXPECT_TRUE(reach(path)) << path;
    return find(path)->value;
  };
  const auto ends = [](const std::string& text, std::string_view unit) { return text.ends_with(unit); };
  EXPECT_PRED2(ends, value("Vertical g plot"), " g");
  EXPECT_PRED2(ends, value("Jerk plot"), " g/s");
  EXPECT_PRED2(ends, value("Roll rate plot"), " \u00B0/s");
  EXPECT_PRED2(ends, value("Roll acceleration plot"), " \u00B0/s\u00B2");
  EXPECT_PRED2(ends, value("Speed plot"), " m/s");
  set<&world::Appearance::units>(base::UnitSystem::feet);
  EXPECT_PRED2(ends, value("Speed plot"), " mph");
  EXPECT_PRED2(ends, value("Height plot"), " ft");
  set<&world::LabView::page>(world::LabPage::forces);
  EXPECT_PRED2(ends, value("Left plot"), " g");
  EXPECT_PRED2(ends, value("Right plot"), " mph");
}

TEST_F(RidersTest, dragging_in_a_plot_moves_the_train_so_that_the_seat_is_there) {
  for (const auto& [seat, car] : {std::pair(world::Seat::front, 0), std::pair(world::Seat::back, 3)}) {
    set<&world::LabView::seat>(seat);
    const std::size_t undo = session_.history.undo.size();
    hover(at("Laboratory/Speed plot", 0.3f));
    press();
    hover(at("Laboratory/Speed plot", 0.6f));
    release();
    frames(2);
    ASSERT_FALSE(all<edit::RideSeek>().empty());
    const double cursor = shown("Laboratory/Speed plot");
    EXPECT_NEAR(cursor, train() - 2 * car, 1e-3) << car;
    EXPECT_GT(cursor, 10);
    EXPECT_EQ(shown("Laboratory/Jerk plot"), cursor);  // one cursor
    EXPECT_EQ(session_.history.undo.size(), undo);
  }
}

TEST_F(RidersTest, a_riding_train_moves_the_cursor) {
  run("ride.start");
  edit::advance(session_, 60);
  frames(2);
  const double before = shown("Laboratory/Vertical g plot");
  EXPECT_NEAR(before, train() - 2 * 2, 1e-3);  // the middle one of four cars
  edit::advance(session_, 30);
  frames(2);
  EXPECT_GT(shown("Laboratory/Vertical g plot"), before + 2);
}

TEST_F(RidersTest, the_mouse_over_a_plot_marks_the_place_in_the_view_and_in_all_plots) {
  hover(at("Laboratory/Vertical g plot", 0.5f));
  frames(2);
  ASSERT_EQ(last_.hovered.kind, view::PickKind::curve);
  const auto index = *world::index_of(session_.derived.order, last_.hovered.entity);
  const double distance =
      session_.derived.starts[index] + session_.derived.shape_at(index).arc.distance(last_.hovered.t);
  EXPECT_NEAR(shown("Laboratory/Vertical g plot/value"), value_at(2, distance, sim::RideValue::vertical), 0.02);
  EXPECT_NEAR(shown("Laboratory/Speed plot/value"), value_at(2, distance, sim::RideValue::speed), 0.1);
  EXPECT_TRUE(commands_.empty());
}

TEST_F(RidersTest, the_mouse_over_the_track_shows_the_values_there) {
  set<&world::Panels::laboratory_height>(0);
  int shown_at = 0;
  for (double distance = 8; distance < session_.derived.length - 4; distance += 3) {
    const sim::TrackPlace place = sim::place_at(session_.derived, distance);
    const sim::SegmentShape& shape = session_.derived.shape_at(place.index);
    const auto pixel = view::project(host_->view(), curve::point(shape.key.cubic, shape.arc.parameter(place.s)));
    if (!pixel) continue;
    hover(glm::vec2(*pixel));
    frames(2);
    if (last_.hovered.kind != view::PickKind::curve) continue;  // a knot or a car is there
    EXPECT_NEAR(shown("Laboratory/Speed plot/value"), value_at(2, distance, sim::RideValue::speed), 0.2) << distance;
    ++shown_at;
  }
  EXPECT_GT(shown_at, 2);
}

TEST_F(RidersTest, the_seat_is_chosen_from_the_list) {
  click("Laboratory/Seat");
  click("Laboratory/Seat/Car 2");
  EXPECT_EQ(session_.settings.lab->seat, world::Seat::car);
  EXPECT_EQ(session_.settings.lab->seat_car, 2);
  click("Laboratory/Seat");
  EXPECT_EQ(find("Laboratory/Seat/Car 5"), nullptr);  // it has four
  click("Laboratory/Seat/All cars");
  EXPECT_EQ(session_.settings.lab->seat, world::Seat::all);
  frames(2);
  EXPECT_NE(find("Laboratory/Jerk plot/value")->value.find(" .. "), std::string::npos);
}

TEST_F(RidersTest, the_edge_of_the_strip_sets_its_height) {
  set<&world::Panels::laboratory_height>(0);
  const float before = find("Laboratory")->y;
  hover(middle(*find("Laboratory/Edge")));
  press();
  hover({middle(*find("Laboratory/Edge")).x, before - 150});
  release();
  frames(2);
  EXPECT_NEAR(find("Laboratory")->y, before - 150, 3);
  EXPECT_GT(session_.settings.panels->laboratory_height, 0.6f);
  click_at(middle(*find("Laboratory/Edge")));
  press();
  release();
  frames(2);
  EXPECT_EQ(session_.settings.panels->laboratory_height, 0);
  EXPECT_NEAR(find("Laboratory")->y, before, 1);
}

}  // namespace riders_test
}  // namespace coaster::ui
