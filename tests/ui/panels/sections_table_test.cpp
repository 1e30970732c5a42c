#include "ui/panels/selected_sections.h"

#include "edit/commands/set_setting.h"
#include "ui/sections_stage.h"
#include "world/appearance_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"
#include "world/selection.h"

namespace coaster::ui {
namespace sections_table_test {

using platform::Key;

struct SectionsTable : SectionsStage {
  void SetUp() override {
    SectionsStage::SetUp();
    key(Key::t);
    frames(2);
  }
  // The rows from top to bottom.
  std::vector<std::string> rows() const {
    std::vector<std::pair<float, std::string>> found;
    for (const Widget& widget : host_->widgets())
      if (widget.path.starts_with("Sections/q") && widget.kind == "item")
        found.emplace_back(widget.y, widget.path.substr(9));
    std::sort(found.begin(), found.end());
    std::vector<std::string> names;
    for (const auto& [y, name] : found) names.push_back(name);
    return names;
  }
  void double_click(const std::string& path) {
    rest();
    ASSERT_TRUE(reach(path)) << path;
    hover(middle(*find(path)));
    for (int i = 0; i < 2; ++i) press(), release();
    frames(2);
  }
  void type_in_cell(const std::string& text, Key last = Key::enter) {
    frames(3);
    EXPECT_TRUE(host_->wants_keyboard());
    frame({platform::TextInput{text}});
    key(last);
    frame();
  }
  std::vector<world::Entity> selected() const { return world::selected_sections(session_.document, session_.settings); }
  float scene_share() const {
    const view::Viewport& scene = host_->view().viewport;
    return scene.width * scene.height / static_cast<float>(width_ * height_);
  }
};

using Names = std::vector<std::string>;

TEST_F(SectionsTable, a_key_and_a_tab_open_it_beside_the_force_graph) {
  EXPECT_EQ(find("Sections")->value, "open");
  EXPECT_EQ(find("Forces")->value, "closed");
  EXPECT_EQ(find("Forces/Plot"), nullptr);
  EXPECT_EQ(rows(), (Names{"q1", "q2", "q3", "q4"}));
  EXPECT_GE(scene_share(), 0.62f);
  click("Forces");
  frames(2);
  EXPECT_NE(find("Forces/Plot"), nullptr);
  EXPECT_TRUE(rows().empty());
  click("Sections");
  frames(2);
  EXPECT_EQ(rows().size(), 4u);
  key(Key::t);
  frames(2);
  EXPECT_TRUE(rows().empty());
  EXPECT_EQ(find("Sections")->value, "closed");
}

TEST_F(SectionsTable, a_heading_sorts_and_a_second_click_turns_the_order) {
  click("Sections/Table/Length");
  frames(2);
  const auto length = [&](const std::string& name) {
    const world::SectionRun of = run(static_cast<std::uint32_t>(std::stoul(name.substr(1))));
    return session_.derived.starts[of.end()] - session_.derived.starts[of.first];
  };
  Names shown = rows();
  ASSERT_EQ(shown.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LE(length(shown[i - 1]), length(shown[i])) << shown[i];
  EXPECT_EQ(find("Sections/Table/Length")->value, "ascending");
  click("Sections/Table/Length");
  frames(2);
  Names turned = rows();
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(turned, shown);
  EXPECT_EQ(find("Sections/Table/Length")->value, "descending");
  // It follows a change of what it shows.
  good(edit::ChangeSection{
      {{world::EntityKind::section, 1}}, false, {world::ElementKind::straight, false, {500, 0, 0, 4, 3}}});
  frames(2);
  EXPECT_EQ(rows().front(), "q1");
  click("Sections/Table/Kind");
  frames(2);
  EXPECT_EQ(rows(), (Names{"q2", "q3", "q4", "q1"})) << "climb, dive, loop, straight";
  good(edit::Set<&world::Panels::sections_by>{world::SectionColumn::track});
  frames(2);
  EXPECT_EQ(rows(), (Names{"q1", "q2", "q3", "q4"}));
}

TEST_F(SectionsTable, what_the_ride_does_not_reach_comes_last_both_ways) {
  good(edit::Set<&world::Panels::sections_by>{world::SectionColumn::speed_out});
  frames(2);
  EXPECT_NE(rows().front(), "q4") << "the train starts at 1 m/s and rolls back on the climb";
  const Names up = rows();
  good(edit::Set<&world::Panels::sections_descending>{true});
  frames(2);
  EXPECT_EQ(rows().back(), up.back());
}

TEST_F(SectionsTable, rows_are_selected_one_by_one_with_shift_and_as_a_range_with_ctrl) {
  click("Sections/q2");
  EXPECT_EQ(selected(), std::vector{section(2)});
  frames(2);
  EXPECT_EQ(find("Sections/q2")->value, "on");
  click("Sections/q4", {.shift = true});
  EXPECT_EQ(selected(), (std::vector{section(2), section(4)}));
  click("Sections/q2", {.shift = true});
  EXPECT_EQ(selected(), std::vector{section(4)});
  click("Sections/q1", {.ctrl = true});
  EXPECT_EQ(session_.settings.selected, section(1));
  EXPECT_EQ(selected().size(), 4u);
  click("Sections/q3");
  EXPECT_EQ(selected(), std::vector{section(3)});
}

TEST_F(SectionsTable, equipment_goes_to_all_selected_rows) {
  click("Sections/q2");
  click("Sections/q3", {.shift = true});
  click("Section/Equipment/Brake");
  EXPECT_TRUE(all_equipped(2, "brake") && all_equipped(3, "brake") && all_equipped(4, "-"));
}

TEST_F(SectionsTable, a_double_click_on_a_parameter_types_it) {
  double_click("Sections/q2/Height");
  EXPECT_EQ(session_.settings.selected, section(2));
  type_in_cell("30");
  EXPECT_EQ(parameter(2, "height"), 30);
  EXPECT_EQ(all<edit::ChangeSection>().size(), 1u);
  EXPECT_EQ(find("Sections/q2/Height")->kind, "cell");
  EXPECT_EQ(find("Sections/q2/Height")->value, "30.00");
  EXPECT_EQ(find("Sections/q4/Radius"), nullptr) << "a loop has none";
  EXPECT_EQ(find("Sections/q2/Length"), nullptr) << "the length of a climb follows from its parameters";
  double_click("Sections/q1/Length");
  type_in_cell("2 * 21");
  EXPECT_EQ(parameter(1, "length"), 42);
  // Escape discards, and so does the number that is there.
  double_click("Sections/q2/Height");
  frame({platform::TextInput{"7"}});
  key(Key::escape);
  double_click("Sections/q2/Height");
  type_in_cell("30");
  EXPECT_EQ(parameter(2, "height"), 30);
  EXPECT_EQ(all<edit::ChangeSection>().size(), 2u);
}

TEST_F(SectionsTable, enter_types_in_the_selected_row_and_tab_goes_on) {
  click("Sections/q2");
  frames(2);
  key(Key::enter);
  type_in_cell("28", Key::tab);
  type_in_cell("24");
  EXPECT_EQ(parameter(2, "height"), 28);
  EXPECT_EQ(parameter(2, "radius"), 24);
  EXPECT_EQ(parameter(2, "angle"), 35);
  // The last cell of the row ends it.
  key(Key::enter);
  type_in_cell("29", Key::tab);
  type_in_cell("25", Key::tab);
  type_in_cell("40", Key::tab);
  EXPECT_EQ(parameter(2, "angle"), 40);
  frames(4);
  EXPECT_FALSE(host_->wants_keyboard());
  // All selected rows that have the parameter.
  click("Sections/q4");
  click("Sections/q1", {.shift = true});
  click("Sections/q3", {.shift = true});
  frames(2);
  const std::size_t before = all<edit::ChangeSection>().size(), steps = session_.history.undo.size();
  key(Key::enter);
  type_in_cell("18");
  EXPECT_EQ(parameter(3, "height"), 18);
  EXPECT_EQ(parameter(4, "height"), 18);
  EXPECT_EQ(parameter(1, "length"), 30);
  EXPECT_EQ(all<edit::ChangeSection>().size(), before + 2);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
}

TEST_F(SectionsTable, a_refused_number_is_told_in_words) {
  double_click("Sections/q2/Height");
  type_in_cell("tall");
  EXPECT_NE(host_->toast().find("Sections/q2/Height: \"tall\" is not a number"), std::string::npos) << host_->toast();
  EXPECT_EQ(parameter(2, "height"), 25);
  double_click("Sections/q2/Height");
  type_in_cell("5000");
  frames(2);
  EXPECT_EQ(parameter(2, "height"), 300);
  ASSERT_NE(find("Section/Refusal"), nullptr);
  EXPECT_NE(host_->toast().find("300"), std::string::npos) << host_->toast();
  // A row without parameters gives a notice.
  edit::Knots knots;
  knots.names = {{world::EntityKind::knot, 1}, {world::EntityKind::knot, 2}};
  good(edit::MakeSection{knots});
  frames(2);
  key(Key::enter);
  frames(2);
  EXPECT_NE(host_->toast().find("no editable number"), std::string::npos) << host_->toast();
}

TEST_F(SectionsTable, the_mouse_over_a_row_marks_its_section_in_the_view) {
  hover(middle(*find("Sections/q3")));
  frames(2);
  ASSERT_EQ(last_.hovered.kind, view::PickKind::curve);
  EXPECT_EQ(world::segment(session_.document, last_.hovered.entity).section, section(3));
}

TEST_F(SectionsTable, it_fits_at_every_size_and_scale) {
  for (const auto& [width, height, scale] :
       {std::tuple{1280, 720, 1.0f}, {1280, 720, 1.5f}, {1920, 1080, 1.0f}, {1920, 1080, 2.0f}}) {
    good(edit::Set<&world::Appearance::ui_scale>{scale});
    resize(width, height);
    if (find("Sections")->value == "closed") key(Key::t);
    frames(3);
    ASSERT_FALSE(rows().empty()) << width << " at " << scale;
    for (const Widget& widget : host_->widgets()) {
      if (!widget.path.starts_with("Sections/")) continue;
      EXPECT_LE(widget.x + widget.width, static_cast<float>(width) + 0.5f) << widget.path;
    }
  }
}

TEST_F(SectionsTable, the_workspace_all_has_it_as_a_panel_with_the_columns_that_find_room) {
  good(edit::Set<&world::Panels::workspace>{world::Workspace::all});
  frames(2);
  ASSERT_NE(find("Sections"), nullptr);
  EXPECT_EQ(find("Sections")->value, "closed");
  click("Sections");
  ASSERT_TRUE(reach("Sections/q2"));
  EXPECT_NE(find("Sections/Table/Length"), nullptr);
  EXPECT_EQ(find("Sections/Table/Lateral"), nullptr);
  click("Sections/q2");
  EXPECT_EQ(selected(), std::vector{section(2)});
}

}  // namespace sections_table_test
}  // namespace coaster::ui
