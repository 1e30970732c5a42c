// The palette, operated by mouse and keyboard.
#include <algorithm>

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/set_setting.h"
#include "ui/panels/element_equipment_fields.h"
#include "ui/panels/panels.h"
#include "ui/stage.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"

namespace coaster::ui {
namespace panel_elements_test {

struct PanelElementsTest : Stage {
  std::size_t knots() const { return session_.document.track.knots.size(); }
};

TEST_F(PanelElementsTest, every_element_has_its_button_its_fields_and_its_help) {
  for (std::size_t i = 0; i < world::elements().size(); ++i) {
    const world::ElementRow& row = world::elements()[i];
    click("Elements/" + std::string(row.label));
    frames(2);
    EXPECT_TRUE(session_.settings.aids->show_element);
    EXPECT_EQ(static_cast<std::size_t>(session_.settings.element.kind), i);
    for (const world::ElementParameter& p : row.parameters)
      EXPECT_EQ(find("Elements/" + std::string(p.label)) != nullptr, world::counts(session_.settings.element, p))
          << row.name << " " << p.label;
    for (const world::ElementParameter& p : row.parameters)
      EXPECT_STRNE(parameter_number(p, 0).unit, "deg") << "other panels show \u00B0: " << p.label;
    EXPECT_EQ(find("Elements/Left") != nullptr, row.sided) << row.name;
    for (const char* path : {"Elements/Spans", "Elements/Total length", "Elements/Fit error", "Elements/Place"})
      EXPECT_NE(find(path), nullptr) << row.name << " " << path;
  }
}

TEST_F(PanelElementsTest, place_adds_what_is_shown_in_one_step_of_undo) {
  click("Elements/Curve");
  type("Elements/Radius", "18");
  click("Elements/Right");
  const std::size_t before = knots(), steps = session_.history.undo.size();
  click("Elements/Place");
  ASSERT_EQ(all<edit::PlaceElement>().size(), 1u);
  EXPECT_EQ(all<edit::PlaceElement>()[0].what.values[0], 18);
  EXPECT_TRUE(all<edit::PlaceElement>()[0].what.right);
  EXPECT_GT(knots(), before);
  EXPECT_EQ(session_.history.undo.size(), steps + 1);
}

// The panel's own line may be out of sight.
TEST_F(PanelElementsTest, enter_on_an_element_that_does_not_fit_says_why) {
  key(platform::Key::enter);
  frames(2);
  EXPECT_NE(host_->toast().find("Choose an element first."), std::string::npos) << host_->toast();
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{{{world::EntityKind::knot, 3}}, {3.9f, 240, -2.3f}}).ok());
  click("Elements/Curve");
  frames(2);
  const std::size_t before = knots();
  key(platform::Key::enter);
  frames(2);
  EXPECT_NE(host_->toast().find("open end is"), std::string::npos) << host_->toast();
  EXPECT_EQ(knots(), before);
  EXPECT_TRUE(session_.settings.aids->show_element);
}

TEST_F(PanelElementsTest, enter_without_a_closing_section_says_why) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::MoveKnot{{{world::EntityKind::knot, 1}}, {-17, 240, 7}}).ok());
  ASSERT_TRUE(edit::apply(session_, files_, edit::Set<&world::EditingAids::circuit>{1}).ok());
  frames(3);
  ASSERT_EQ(find("Elements/Place proposal"), nullptr);
  key(platform::Key::enter);
  frames(2);
  EXPECT_NE(host_->toast().find("first knot is too sharp"), std::string::npos) << host_->toast();
  EXPECT_FALSE(session_.document.track.closed);
  EXPECT_EQ(session_.settings.aids->circuit, 1);
}

TEST_F(PanelElementsTest, the_palette_keeps_the_parameters_of_each_element) {
  click("Elements/Curve");
  type("Elements/Radius", "18");
  click("Elements/Right");
  click("Elements/Climb");
  type("Elements/Height", "31");
  frames(2);
  click("Elements/Curve");
  frames(2);
  EXPECT_EQ(session_.settings.element.kind, world::ElementKind::curve);
  EXPECT_EQ(world::value_of(session_.settings.element, "radius"), 18);
  EXPECT_TRUE(session_.settings.element.right);
  click("Elements/Climb");
  frames(2);
  EXPECT_EQ(world::value_of(session_.settings.element, "height"), 31);
}

TEST_F(PanelElementsTest, enter_places_and_escape_and_a_second_click_hide_the_preview) {
  const std::size_t before = knots();
  key(platform::Key::enter);
  EXPECT_EQ(knots(), before) << "nothing shows, nothing is placed";
  click("Elements/Straight");
  frames(2);
  key(platform::Key::enter);
  EXPECT_GT(knots(), before);
  key(platform::Key::escape);
  EXPECT_FALSE(session_.settings.aids->show_element);
  click("Elements/Straight");
  EXPECT_TRUE(session_.settings.aids->show_element);
  frames(30);
  click("Elements/Straight");
  EXPECT_FALSE(session_.settings.aids->show_element);
}

TEST_F(PanelElementsTest, a_closed_track_has_no_end_to_place_at) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetClosed{true}).ok());
  click("Elements/Loop");
  frames(2);
  ASSERT_TRUE(reach("Elements/Place"));
  EXPECT_FALSE(find("Elements/Place")->enabled);
  const std::size_t before = knots();
  key(platform::Key::enter);
  EXPECT_EQ(knots(), before);
}

}  // namespace panel_elements_test
}  // namespace coaster::ui
