// The panel of the selected sections.
#include "base/text.h"
#include "ui/sections_stage.h"
#include "world/panel_settings.h"
#include "world/selection.h"

namespace coaster::ui {
namespace section_test {

using platform::Key;

struct SectionPanel : SectionsStage {
  void choose(std::initializer_list<std::uint32_t> numbers) {
    std::vector<world::EntityName> names;
    for (const std::uint32_t number : numbers) names.push_back({world::EntityKind::section, number});
    good(edit::SelectSections{edit::Sections(names)});
    frames(2);
  }
  std::size_t steps() const { return session_.history.undo.size(); }
};

// What a person does who wants a lift hill 5 m higher: a click and a number.
TEST_F(SectionPanel, a_hill_is_raised_by_a_click_and_a_number_and_everything_follows) {
  const glm::dvec3 before = end();
  const std::size_t undo = steps();
  click_at(pixel_on(2));
  frames(2);
  type("Section/Height", "30");
  EXPECT_EQ(parameter(2, "height"), 30);
  EXPECT_EQ(steps(), undo + 1);
  EXPECT_NEAR(end().y, before.y + 5, 1e-3);
  for (const std::uint32_t number : {1u, 2u, 3u, 4u})
    EXPECT_EQ(value(number).kind, world::SectionKind::element) << "q" << number << " keeps its plan";
  good(edit::Undo{});
  EXPECT_EQ(end(), before);
}

TEST_F(SectionPanel, a_drag_of_a_number_is_one_step_of_undo) {
  choose({2});
  ASSERT_TRUE(reach("Section/Angle"));
  const std::size_t undo = steps();
  const glm::vec2 at = middle(*find("Section/Angle"));
  hover(at);
  press();
  for (int i = 1; i <= 5; ++i) hover(at + glm::vec2(6 * i, 0));
  EXPECT_GT(parameter(2, "angle"), 35);
  release();
  frames(2);
  EXPECT_EQ(steps(), undo + 1);
  EXPECT_EQ(parameter(3, "angle"), 55) << "its neighbour keeps its plan";
  good(edit::Undo{});
  EXPECT_EQ(parameter(2, "angle"), 35);
}

TEST_F(SectionPanel, a_refusal_stands_below_its_field_until_the_next_change) {
  choose({1});
  EXPECT_EQ(find("Section/Refusal"), nullptr);
  type("Section/Roll", "45");  // the climb behind it would tilt
  frames(2);
  EXPECT_EQ(parameter(1, "roll"), 0);
  const Widget* const refusal = find("Section/Refusal");
  ASSERT_NE(refusal, nullptr);
  EXPECT_EQ(refusal->value, session_.notices.list.back().text);
  EXPECT_GT(refusal->y, find("Section/Roll")->y);
  type("Section/Length", "31");
  frames(2);
  EXPECT_EQ(parameter(1, "length"), 31);
  EXPECT_EQ(find("Section/Refusal"), nullptr);
}

TEST_F(SectionPanel, equipment_is_one_click_and_survives_a_change) {
  choose({2});
  click("Section/Equipment/Lift");
  EXPECT_TRUE(all_equipped(2, "lift")) << equipment(2);
  frames(2);
  EXPECT_EQ(find("Section/Equipment/Lift")->value, "on");
  EXPECT_EQ(find("Section/Equipment/None")->value, "off");
  type("Section/Speed", "3");
  type("Section/Height", "33");
  EXPECT_TRUE(all_equipped(2, "lift")) << equipment(2);
  EXPECT_EQ(session_.document.entities.get<world::Equipment>(session_.document.track.segments[run(2).first]).speed, 3);
  click("Section/Equipment/None");
  type("Section/Height", "28");
  EXPECT_TRUE(all_equipped(2, "-")) << equipment(2);
}

TEST_F(SectionPanel, several_share_equipment_and_the_parameters_that_all_have) {
  choose({3, 2});
  EXPECT_EQ(find("Section/Selected")->value, "2 sections");
  EXPECT_EQ(find("Section/Title"), nullptr);
  for (const char* shared : {"Section/Height", "Section/Angle", "Section/Radius"})
    EXPECT_NE(find(shared), nullptr) << shared;
  std::size_t undo = steps();
  type("Section/Height", "22");
  EXPECT_EQ(parameter(2, "height"), 22);
  EXPECT_EQ(parameter(3, "height"), 22);
  EXPECT_EQ(steps(), undo + 1) << "one step";
  EXPECT_EQ(parameter(2, "angle"), 35) << "the others stay";
  EXPECT_EQ(parameter(3, "angle"), 55);
  undo = steps();
  click("Section/Equipment/Brake");
  EXPECT_TRUE(all_equipped(2, "brake") && all_equipped(3, "brake"));
  EXPECT_EQ(steps(), undo + 1);
  choose({4, 2});
  frames(2);
  EXPECT_NE(find("Section/Height"), nullptr);
  EXPECT_EQ(find("Section/Angle"), nullptr) << "a loop has none";
}

TEST_F(SectionPanel, a_drag_changes_several_as_if_they_were_typed_at_its_end) {
  choose({3, 2});
  ASSERT_TRUE(reach("Section/Height"));
  const glm::vec2 at = middle(*find("Section/Height"));
  hover(at);
  press();
  for (int i = 1; i <= 6; ++i) hover(at + glm::vec2(5 * i, 0));
  release();
  frames(2);
  const double height = parameter(2, "height");
  EXPECT_GT(height, 20.5);
  EXPECT_EQ(parameter(3, "height"), height);
  const glm::dvec3 dragged = end();
  good(edit::Undo{});
  type("Section/Height", base::to_text(height));
  EXPECT_LT(glm::distance(end(), dragged), 1e-3);
}

TEST_F(SectionPanel, buttons_mirror_move_copy_and_delete) {
  choose({4});
  click("Section/Mirror");
  EXPECT_TRUE(value(4).element.right);
  click("Section/Move before");
  EXPECT_EQ(run(4).end(), run(3).first);
  click("Section/Copy");
  EXPECT_NE(session_.copied.find("loop"), std::string::npos);
  click("Section/Paste");
  EXPECT_FALSE(last_.wants_paste) << "the wish is of one frame";
  choose({4, 1});
  const std::size_t undo = steps();
  key(Key::del);
  frames(2);
  EXPECT_EQ(world::sections_of(session_.document).size(), 2u);
  EXPECT_EQ(steps(), undo + 1);
}

TEST_F(SectionPanel, keys_do_everything) {
  key(Key::page_down);
  EXPECT_EQ(session_.settings.selected, section(1));
  key(Key::page_down);
  EXPECT_EQ(session_.settings.selected, section(2));
  key(Key::page_down, {.shift = true});
  EXPECT_EQ(world::selected_sections(session_.document, session_.settings), (std::vector{section(2), section(3)}));
  key(Key::page_up);
  EXPECT_EQ(session_.settings.selected, section(2));
  EXPECT_TRUE(session_.settings.also.empty());
  // A number, and by Tab the next.
  frames(2);
  key(Key::p);
  frames(3);
  frame({platform::TextInput{"29"}});
  key(Key::tab);
  frames(3);
  EXPECT_EQ(parameter(2, "height"), 29);
  EXPECT_TRUE(session_.settings.panels->show_panels) << "Tab was for the fields";
  frame({platform::TextInput{"41"}});
  key(Key::enter);
  frames(2);
  EXPECT_EQ(parameter(2, "angle"), 41);
  key(Key::c, {.ctrl = true});
  EXPECT_NE(session_.copied.find("climb"), std::string::npos);
  key(Key::page_down, {.ctrl = true});
  EXPECT_EQ(run(2).first, run(3).end());
  key(Key::page_up, {.ctrl = true});
  EXPECT_EQ(run(2).end(), run(3).first);
}

TEST_F(SectionPanel, behind_the_last_section_is_the_first_of_a_closed_track_and_a_word_on_an_open_one) {
  const auto chosen = [&] { return session_.settings.selected; };
  key(Key::page_up);
  const world::Entity last = world::sections_of(session_.document).back().section;
  EXPECT_EQ(chosen(), last);
  key(Key::page_down);
  EXPECT_EQ(chosen(), last);
  EXPECT_EQ(host_->toast(), "This is the last section.");
  choose({1});
  key(Key::page_up);
  EXPECT_EQ(chosen(), section(1));
  EXPECT_EQ(host_->toast(), "This is the first section.");
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetClosed{true}).ok());
  const world::Entity home = world::sections_of(session_.document).back().section;
  key(Key::page_up);
  EXPECT_EQ(chosen(), home);
  key(Key::page_down);
  EXPECT_EQ(chosen(), section(1));
}

TEST_F(SectionPanel, a_segment_and_knots_get_equipment_in_one_click_too) {
  select(world::EntityKind::segment, 2);
  click("Operation/Equipment/Launch");
  EXPECT_TRUE(session_.document.entities.find<world::Equipment>(entity(world::EntityKind::segment, 2)));
  std::vector<world::EntityName> names;
  for (std::size_t i = run(3).first; i <= run(3).end(); ++i)
    names.push_back(world::name_of(session_.document, session_.document.track.knots[i]));
  good(edit::SelectKnots{edit::Knots(names)});
  frames(2);
  const std::size_t undo = steps();
  click("Operation/Equipment/Brake");
  EXPECT_TRUE(all_equipped(3, "brake")) << equipment(3);
  EXPECT_EQ(steps(), undo + 1);
}

}  // namespace section_test
}  // namespace coaster::ui
