// Each workspace in real frames: every widget is in an area of the layout; none covers another or the view.
#include "ui/host/host.h"

#include <set>

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "ui/widgets/widgets.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace areas_test {

using platform::Key;
using world::Workspace;

struct AreasTest : Stage {
  template <auto Member>
  void set(world::ValueOf<Member> to) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Set<Member>{to}).ok());
    frames(3);
  }
  void go_to(Workspace workspace) { set<&world::Panels::workspace>(workspace); }
  Workspace workspace() const { return session_.settings.panels->workspace; }
  void window(int width, int height, float scale) {
    set<&world::Appearance::ui_scale>(scale);
    resize(width, height);
    frames(2);
  }
  float scene_share() const {
    const view::Viewport& scene = host_->view().viewport;
    return scene.width * scene.height / static_cast<float>(width_ * height_);
  }
  std::set<std::string> paths() const {
    std::set<std::string> all;
    for (const Widget& widget : host_->widgets()) all.insert(widget.path);
    return all;
  }
  static bool same_place(const Widget& a, const Widget& b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
  }

  // Edges lie over their areas, and a label may repeat the place of what it is about.
  static bool may_overlap(const Widget& a, const Widget& b) {
    return a.kind == "edge" || b.kind == "edge" || a.path.starts_with(b.path + "/") || b.path.starts_with(a.path + "/");
  }
  static bool overlap(const Widget& a, const Widget& b) {
    constexpr float kRounding = 0.6f;  // px
    return std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x) > kRounding &&
           std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y) > kRounding;
  }
  void expect_orderly(const std::string& where) const {
    const view::Viewport& scene = host_->view().viewport;
    // Panels scroll: the last row that shows may be cut.
    const bool strip = workspace() == Workspace::laboratory;
    const float foot = strip ? find("Status/Unsaved")->y : scene.y + scene.height;
    std::vector<Widget> seen;
    for (Widget widget : host_->widgets()) {
      if (!widget.visible || widget.covered) continue;
      if (widget.y < foot && !widget.path.starts_with("Laboratory"))
        widget.height = std::min(widget.height, foot - widget.y);
      seen.push_back(widget);
    }
    ASSERT_GT(seen.size(), 10u) << where;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Widget& w = seen[i];
      EXPECT_GE(w.x, 0) << w.path << ", " << where;
      EXPECT_LE(w.x + w.width, static_cast<float>(width_) + 0.5f) << w.path << ", " << where;
      const bool beside = w.x + w.width <= scene.x + 0.6f || w.x >= scene.x + scene.width - 0.6f ||
                          w.y + w.height <= scene.y + 0.6f || w.y >= scene.y + scene.height - 0.6f;
      EXPECT_TRUE(beside) << w.path << " lies over the view, " << where;
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(overlap(w, seen[k]) && !may_overlap(w, seen[k]))
            << w.path << " over " << seen[k].path << ", " << where;
    }
  }
};

TEST_F(AreasTest, widgets_of_every_workspace_keep_apart_and_off_the_view_at_every_size_and_scale) {
  constexpr std::tuple<int, int, float> kWindows[] = {
      {1280, 720, 1.0f}, {1280, 720, 1.5f}, {1920, 1080, 1.0f}, {1920, 1080, 1.5f}, {1920, 1080, 2.0f}};
  for (const auto& [width, height, scale] : kWindows) {
    window(width, height, scale);
    for (const Workspace one : {Workspace::build, Workspace::ride, Workspace::laboratory}) {
      go_to(one);
      const std::string where =
          std::string(base::name_of(one)) + " at " + std::to_string(width) + " times " + std::to_string(scale);
      expect_orderly(where);
      select(world::EntityKind::knot, 2);
      expect_orderly(where + " with a knot");
      select(world::EntityKind::section, 1);
      expect_orderly(where + " with a section");
      set<&world::EditingAids::show_element>(true);
      expect_orderly(where + " with an element");
      set<&world::EditingAids::show_element>(false);
      ASSERT_TRUE(edit::apply(session_, files_, edit::Select{}).ok());
    }
  }
}

// In sight or scrolled out of it, with every kind of panel: of the track, a knot, a hand-shaped section, one of forces,
// one that is planned, and an element.
TEST_F(AreasTest, no_button_is_too_narrow_for_its_label) {
  const auto good = [&](const edit::Command& command) {
    const base::Status status = edit::apply(session_, files_, command);
    ASSERT_TRUE(status.ok()) << status.message;
  };
  good(edit::SetStartSpeed{18});
  good(edit::AddForceSection{});
  good(edit::PlaceElement{world::usual_element(world::ElementKind::straight)});
  constexpr std::tuple<int, int, float> kWindows[] = {
      {1280, 720, 1.0f}, {1280, 720, 1.5f}, {1024, 768, 1.0f}, {1920, 1080, 1.0f}, {1920, 1080, 2.0f}};
  std::set<std::string> buttons;
  const auto check = [&](const std::string& where) {
    frames(3);
    for (const Widget& widget : host_->widgets()) {
      EXPECT_FALSE(widget.cut) << widget.path << ", " << where;
      buttons.insert(widget.path);
    }
  };
  for (const auto& [width, height, scale] : kWindows) {
    window(width, height, scale);
    for (const Workspace one : {Workspace::build, Workspace::ride, Workspace::laboratory, Workspace::all}) {
      go_to(one);
      const std::string where = std::string(base::name_of(one)) + " at " + std::to_string(width) + " times " +
                                std::to_string(scale) + " with ";
      good(edit::Select{});
      check(where + "nothing");
      select(world::EntityKind::knot, 2);
      if (one == Workspace::build && find("Shape/Smooth") == nullptr) click("Shape");
      check(where + "a knot");
      for (const std::uint32_t number : {1u, 2u, 3u}) {
        select(world::EntityKind::section, number);
        check(where + "section " + std::to_string(number));
      }
      set<&world::EditingAids::show_element>(true);
      check(where + "an element");
      set<&world::EditingAids::show_element>(false);
    }
  }
  for (const char* path :
       {"Section/By hand", "Section/Read forces", "Section/Equipment/Station", "Elements/Immelmann", "Shape/Duplicate"})
    EXPECT_TRUE(buttons.contains(path)) << path << " was never shown";
}

TEST_F(AreasTest, the_view_has_62_percent_in_build_and_85_in_ride) {
  window(1280, 720, 1);
  go_to(Workspace::build);
  EXPECT_GE(scene_share(), 0.62f);
  go_to(Workspace::ride);
  EXPECT_GE(scene_share(), 0.85f);
}

TEST_F(AreasTest, tabs_and_keys_choose_the_workspace_and_each_shows_only_its_panels) {
  frames(2);
  EXPECT_EQ(workspace(), Workspace::all);
  click("Menu/Workspace/Build");
  EXPECT_EQ(workspace(), Workspace::build);
  frames(2);
  EXPECT_NE(find("Elements/Loop"), nullptr);
  EXPECT_NE(find("Track/Name"), nullptr);
  EXPECT_NE(find("Forces/Plot"), nullptr);
  for (const char* path : {"Evaluation", "Ride", "Camera", "Statistics", "Laboratory", "Ride/Play"})
    EXPECT_EQ(find(path), nullptr) << path;
  key(Key::f9);
  EXPECT_EQ(workspace(), Workspace::ride);
  frames(2);
  for (const char* path : {"Ride/Play", "Ride/Speed", "Ride/Vertical g", "Ride/g up", "Ride/Height", "Ride/Time",
                           "Ride/Place", "Ride/Seat", "Ride/Camera", "Ride/Record"})
    EXPECT_NE(find(path), nullptr) << path;
  for (const char* path : {"Elements/Loop", "Track", "Forces", "Evaluation"}) EXPECT_EQ(find(path), nullptr) << path;
  click("Menu/Workspace/Laboratory");
  EXPECT_EQ(workspace(), Workspace::laboratory);
  EXPECT_TRUE(session_.settings.panels->show_laboratory);
  frames(2);
  for (const char* path : {"Evaluation/Horner", "Evaluation/Steps per segment", "Laboratory/Construction"})
    EXPECT_NE(find(path), nullptr) << path;
  EXPECT_EQ(find("Track"), nullptr);
  key(Key::f8);
  EXPECT_EQ(workspace(), Workspace::build);
  EXPECT_EQ(find("Menu/Workspace/Build")->value, "on");
}

TEST_F(AreasTest, the_palette_stays_where_it_is_whatever_is_selected) {
  go_to(Workspace::build);
  const auto places = [&] {
    std::vector<Widget> buttons;
    for (const world::ElementRow& row : world::elements())
      buttons.push_back(*find("Elements/" + std::string(row.label)));
    buttons.push_back(*find("Elements/Draw knots"));
    return buttons;
  };
  const std::vector<Widget> before = places();
  const view::Viewport scene = host_->view().viewport;
  const auto expect_still = [&] {
    const std::vector<Widget> now = places();
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_TRUE(same_place(now[i], before[i])) << now[i].path;
      EXPECT_TRUE(now[i].visible && !now[i].covered) << now[i].path;
    }
    EXPECT_EQ(host_->view().viewport.width, scene.width);
    EXPECT_EQ(host_->view().viewport.height, scene.height);
  };
  select(world::EntityKind::knot, 2);
  EXPECT_NE(find("Inspector/Roll"), nullptr);
  EXPECT_EQ(find("Track"), nullptr);
  expect_still();
  select(world::EntityKind::segment, 1);
  expect_still();
  click("Elements/Loop");
  frames(2);
  EXPECT_NE(find("Elements/Height"), nullptr);
  expect_still();
  ASSERT_TRUE(reach("Operation/Equipment"));  // scrolls the parameters
  expect_still();
}

TEST_F(AreasTest, the_graph_marks_the_place_under_the_mouse_in_the_view_and_a_drag_moves_the_train) {
  go_to(Workspace::build);
  const Widget plot = *find("Forces/Plot");
  hover({plot.x + plot.width * 0.7f, plot.y + plot.height * 0.5f});
  frames(2);
  ASSERT_EQ(last_.hovered.kind, view::PickKind::curve);
  const float there = last_.hovered.position.x;
  const std::string shown = find("Forces/Height/value")->value;
  hover({plot.x + plot.width * 0.2f, plot.y + plot.height * 0.5f});
  frames(2);
  EXPECT_LT(last_.hovered.position.x, there);
  EXPECT_NE(find("Forces/Height/value")->value, shown);
  const Widget cursor_at = *find("Forces/Plot");
  press();
  hover({cursor_at.x + cursor_at.width * 0.5f, cursor_at.y + cursor_at.height * 0.5f});
  release();
  EXPECT_FALSE(all<edit::RideSeek>().empty());
}

TEST_F(AreasTest, pointing_at_the_track_shows_the_values_there) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::LoadTrack{COASTER_SOURCE_DIR "/tracks/loop.json"}).ok());
  frames(3);
  go_to(Workspace::build);
  const std::string at_train = find("Forces/Height/value")->value;
  const auto& derived = session_.derived;
  const glm::dvec3 at = curve::point(derived.shape_at(1).key.cubic, 0.35);
  const auto pixel = view::project(host_->view(), glm::vec3(at));
  ASSERT_TRUE(pixel.has_value());
  hover(glm::vec2(*pixel));
  frames(2);
  ASSERT_EQ(last_.hovered.kind, view::PickKind::curve);
  EXPECT_NE(find("Forces/Height/value")->value, at_train);
  EXPECT_NEAR(std::strtod(find("Forces/Height/value")->value.c_str(), nullptr), at.y, 0.6);
}

TEST_F(AreasTest, the_edge_sets_the_height_of_the_graph_and_a_double_click_resets_it) {
  go_to(Workspace::build);
  const Widget edge = *find("Forces/Edge");
  const float before = host_->view().viewport.height;
  hover({600, edge.y + 2});
  press();
  hover({600, edge.y - 90});
  frame();
  release();
  frames(2);
  EXPECT_GT(session_.settings.panels->graph_height, 0.2f);
  EXPECT_NEAR(host_->view().viewport.height, before - 92, 4);
  const Widget now = *find("Forces/Edge");
  click_at({600, now.y + 2});
  press();
  release();
  frames(2);
  EXPECT_EQ(session_.settings.panels->graph_height, 0);
}

TEST_F(AreasTest, curves_hide_by_a_click_on_their_value) {
  go_to(Workspace::build);
  EXPECT_EQ(find("Forces/Speed")->value, "on");
  click("Forces/Speed");
  frame();
  EXPECT_EQ(find("Forces/Speed")->value, "off");
}

TEST_F(AreasTest, drawers_open_by_click_and_by_key_where_there_is_little_room) {
  window(1250, 720, 1.5f);
  go_to(Workspace::build);
  EXPECT_EQ(find("Parameters")->value, "closed");
  EXPECT_EQ(find("Track"), nullptr);
  EXPECT_EQ(find("Forces")->value, "closed");
  EXPECT_EQ(find("Forces/Plot"), nullptr);
  click("Parameters");
  frames(2);
  EXPECT_NE(find("Track/Name"), nullptr);
  key(Key::f5);
  frames(2);
  EXPECT_EQ(find("Track/Name"), nullptr);
  key(Key::f6);
  frames(2);
  EXPECT_NE(find("Forces/Plot"), nullptr);
  click("Forces");
  frames(2);
  EXPECT_EQ(find("Forces/Plot"), nullptr);
}

TEST_F(AreasTest, elements_are_chosen_and_placed_by_keys_alone) {
  go_to(Workspace::build);
  const std::size_t before = session_.document.track.segments.size();
  key(Key::n);
  EXPECT_TRUE(session_.settings.aids->show_element);
  const auto first = session_.settings.element.kind;
  key(Key::n);
  EXPECT_NE(session_.settings.element.kind, first);
  key(Key::n, {.shift = true});
  EXPECT_EQ(session_.settings.element.kind, first);
  frames(2);
  key(Key::enter);
  EXPECT_GT(session_.document.track.segments.size(), before);
}

TEST_F(AreasTest, the_ride_bar_plays_scrubs_and_chooses_the_camera) {
  go_to(Workspace::ride);
  EXPECT_EQ(find("Ride/Pause"), nullptr);
  click("Ride/Play");
  EXPECT_EQ(session_.motion.state, world::RideState::running);
  frames(2);
  click("Ride/Pause");
  EXPECT_EQ(session_.motion.state, world::RideState::paused);
  const Widget place = *find("Ride/Place");
  hover({place.x + place.width * 0.5f, place.y + place.height * 0.5f});
  press();
  frame();
  release();
  frames(2);
  ASSERT_FALSE(all<edit::RideSeek>().empty());
  EXPECT_NEAR(all<edit::RideSeek>().back().to, session_.derived.length / 2, session_.derived.length / 20);
  click("Ride/Camera");
  frames(2);
  click("Ride/Camera/Chase");
  EXPECT_EQ(session_.settings.camera_mode, world::CameraMode::chase);
  click("Ride/Record");
  EXPECT_EQ(last_.movie, MovieRequest::none) << "the wish is of one frame";
}

TEST_F(AreasTest, a_fast_speed_in_any_unit_keeps_off_its_label_in_the_ride_bar) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetStartSpeed{50}).ok());
  go_to(Workspace::ride);
  for (const base::UnitSystem units : {base::UnitSystem::m_s, base::UnitSystem::kmh, base::UnitSystem::feet})
    for (const float scale : {1.0f, 1.5f}) {
      set<&world::Appearance::units>(units);
      window(1280, 720, scale);
      frames(2);
      const Widget& speed = *find("Ride/Speed");
      EXPECT_GT(speed.width, text_size("Speed ").x + text_size(speed.value).x) << speed.value << " at " << scale;
    }
}

TEST_F(AreasTest, the_status_bar_shows_evaluator_and_steps_in_every_workspace_and_opens_the_list) {
  for (const Workspace one : {Workspace::all, Workspace::build, Workspace::ride, Workspace::laboratory}) {
    go_to(one);
    ASSERT_NE(find("Status/Evaluator"), nullptr) << base::name_of(one);
    EXPECT_NE(find("Status/Evaluator")->value.find("64 steps"), std::string::npos);
    EXPECT_NE(find("Status/Length"), nullptr);
    EXPECT_NE(find("Status/Speed"), nullptr);
  }
  go_to(Workspace::build);
  click("Status/Evaluator");
  frames(3);
  ASSERT_NE(find("Status/Evaluator/de Casteljau"), nullptr);
  click("Status/Evaluator/de Casteljau");
  EXPECT_EQ(curve::evaluators()[static_cast<std::size_t>(session_.settings.evaluation->evaluator)].name,
            "de_casteljau");
  key(Key::escape);
  frames(2);
  const auto before = session_.settings.evaluation->evaluator;
  key(Key::e);
  EXPECT_NE(session_.settings.evaluation->evaluator, before);
  key(Key::equal);
  EXPECT_EQ(session_.settings.evaluation->steps, 128);
  key(Key::minus);
  EXPECT_EQ(session_.settings.evaluation->steps, 64);
}

}  // namespace areas_test
}  // namespace coaster::ui
