// Clicks that select sections (ui/tools/selecting.h).
#include "ui/tools/selecting.h"

#include "edit/commands/set_setting.h"
#include "ui/sections_stage.h"
#include "ui/widgets/widgets.h"
#include "view/gizmo.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"
#include "world/selection.h"

namespace coaster::ui {
namespace section_clicks_test {

using world::EntityKind;

struct SectionClicks : SectionsStage {
  bool is(EntityKind kind) const {
    const world::EntityName* const name =
        session_.document.entities.find<world::EntityName>(session_.settings.selected);
    return name && name->kind == kind;
  }
  std::size_t inner_knot(std::uint32_t number) const { return run(number).first + 1; }
};

TEST_F(SectionClicks, the_first_click_selects_a_section_the_second_a_place_or_a_knot) {
  click_at(pixel_on(3));
  EXPECT_EQ(session_.settings.selected, section(3));
  rest();
  click_at(pixel_on(3));
  EXPECT_TRUE(is(EntityKind::segment));
  EXPECT_EQ(world::segment(session_.document, session_.settings.selected).section, section(3));
  rest();
  click_at(pixel_of_knot(inner_knot(3)));
  EXPECT_EQ(session_.settings.selected, session_.document.track.knots[inner_knot(3)]) << "it is open";
  rest();
  click_at(pixel_of_knot(inner_knot(4)));
  EXPECT_EQ(session_.settings.selected, section(4)) << "of another section the section first";
  rest();
  click_at(pixel_of_knot(inner_knot(4)));
  EXPECT_EQ(session_.settings.selected, session_.document.track.knots[inner_knot(4)]);
}

TEST_F(SectionClicks, a_knot_between_two_belongs_to_the_selected_one) {
  const std::size_t joint = run(3).first;
  click_at(pixel_of_knot(joint));
  EXPECT_EQ(session_.settings.selected, section(2)) << "without one to the earlier";
  good(edit::Select{{{EntityKind::section, 3}}});
  frames(2);
  rest();
  click_at(pixel_of_knot(joint));
  EXPECT_EQ(session_.settings.selected, session_.document.track.knots[joint]);
}

TEST_F(SectionClicks, a_quick_second_click_inserts_no_knot_and_a_drag_moves_none) {
  const std::size_t knots = session_.document.track.knots.size();
  click_at(pixel_on(2));
  click_at(pixel_on(2));
  EXPECT_TRUE(is(EntityKind::segment));
  EXPECT_EQ(session_.document.track.knots.size(), knots);
  good(edit::Select{});
  rest();
  const world::Document before = session_.document;
  hover(pixel_of_knot(inner_knot(2)));
  press();
  for (int i = 1; i < 5; ++i) hover(pixel_of_knot(inner_knot(2)) + glm::vec2(9 * i, 4 * i));
  release();
  frame();
  EXPECT_TRUE(session_.document == before);
}

TEST_F(SectionClicks, shift_adds_a_section_and_takes_it_out_again) {
  click_at(pixel_on(2));
  rest();
  click_at(pixel_on(4), {.shift = true});
  EXPECT_EQ(world::selected_sections(session_.document, session_.settings), (std::vector{section(2), section(4)}));
  rest();
  click_at(pixel_on(2), {.shift = true});
  EXPECT_EQ(world::selected_sections(session_.document, session_.settings), std::vector{section(4)});
  rest();
  click_at(pixel_on(2), {.shift = true});
  rest();
  click_at(pixel_on(4));
  EXPECT_EQ(world::selected_sections(session_.document, session_.settings), std::vector{section(4)})
      << "of several that one alone";
}

TEST_F(SectionClicks, the_mouse_names_the_section_under_it) {
  good(edit::SetSectionTitle{{{EntityKind::section, 3}}, "First drop"});
  hover(pixel_on(3));
  frames(2);
  ASSERT_NE(find("View/Section"), nullptr);
  EXPECT_EQ(find("View/Section")->value, "First drop");
  hover(pixel_on(4));
  frames(2);
  ASSERT_NE(find("View/Section"), nullptr);
  EXPECT_EQ(find("View/Section")->value, "Loop");
  hover(empty_ground());
  frames(2);
  EXPECT_EQ(find("View/Section"), nullptr);
}

TEST_F(SectionClicks, the_mouse_shows_the_spin_that_it_drags) {
  const std::size_t knot = inner_knot(3);
  good(edit::Select{{world::name_of(session_.document, session_.document.track.knots[knot])}});
  frames(2);
  const auto ring = view::spin_ring_of(session_.document, session_.settings, host_->view());
  ASSERT_TRUE(ring);
  const auto at = view::project(host_->view(), glm::vec3(ring->handle()));
  ASSERT_TRUE(at);
  hover(glm::vec2(*at));
  press();
  hover(glm::vec2(*at) + glm::vec2(15, 5));
  hover(glm::vec2(*at) + glm::vec2(30, 10));
  frames(2);
  const auto spins = all<edit::SetSpin>();
  ASSERT_FALSE(spins.empty());
  ASSERT_NE(find("View/Section"), nullptr);
  EXPECT_EQ(find("View/Section")->value, "Spin " + fixed(spins.back().to, 2) + " \u00B0/m");
  release();
}

TEST_F(SectionClicks, other_workspaces_and_tracks_without_plans_select_at_once) {
  good(edit::Set<&world::Panels::workspace>{world::Workspace::all});
  frames(3);
  look_at_all();
  click_at(pixel_of_knot(inner_knot(3)));
  EXPECT_TRUE(is(EntityKind::knot));
  good(edit::Set<&world::Panels::workspace>{world::Workspace::build});
  good(edit::NewTrack{});
  build_track(session_, files_);
  frames(3);
  look_at_all();
  rest();
  click_at(pixel_of_knot(1));
  EXPECT_TRUE(is(EntityKind::knot));
  EXPECT_FALSE(picks_sections(session_));
}

TEST_F(SectionClicks, a_drag_of_the_handle_changes_the_height_in_one_step) {
  click_at(pixel_on(2));
  frames(2);
  const std::size_t undo = session_.history.undo.size();
  const auto place = [&] { return view::section_handle(session_.document, session_.derived, section(2))->at; };
  const glm::dvec3 from = place();
  const glm::vec2 at = pixel(glm::vec3(from)), to = pixel(glm::vec3(from) + glm::vec3(0, 6, 0));
  hover(at);
  ASSERT_EQ(last_.hovered.kind, view::PickKind::section);
  press();
  for (int i = 1; i <= 4; ++i) hover(at + (to - at) * (static_cast<float>(i) / 4));
  EXPECT_NEAR(parameter(2, "height"), 31, 0.3);
  frame();
  ASSERT_NE(find("View/Section"), nullptr);
  EXPECT_NE(find("View/Section")->value.find("Height 3"), std::string::npos);
  release();
  frames(2);
  EXPECT_EQ(session_.history.undo.size(), undo + 1);
  EXPECT_EQ(session_.settings.selected, section(2));
  good(edit::Undo{});
  EXPECT_EQ(parameter(2, "height"), 25);
  frames(40);
  click_at(pixel(glm::vec3(place())));
  EXPECT_EQ(session_.settings.selected, session_.document.track.knots[run(2).end()]) << "a click is for the knot below";
}

TEST_F(SectionClicks, drags_of_the_rings_turn_and_bank_by_degrees) {
  good(edit::PlaceElement{{world::ElementKind::curve, true, {25, 90, 40, 0, 0}}});
  good(edit::Select{{{EntityKind::section, 5}}});
  frames(2);
  look_at_all();
  const auto handle = [&](view::PickKind kind) {
    return *view::angle_handle(session_.document, session_.derived, section(5), kind);
  };
  const struct {
    view::PickKind kind;
    const char *parameter, *label;
    double was, to;
  } kCases[] = {{view::PickKind::turn, "angle", "Angle 1", 90, 131}, {view::PickKind::bank, "bank", "Bank ", 40, 21}};
  for (const auto& one : kCases)
    for (const bool snaps : {false, true}) {
      const view::AngleHandle of = handle(one.kind);
      const glm::vec2 at = pixel(glm::vec3(of.at(of.angle))), to = pixel(glm::vec3(of.at(one.to)));
      const std::size_t undo = session_.history.undo.size();
      hover(at);
      ASSERT_EQ(last_.hovered.kind, one.kind);
      press({.ctrl = snaps});
      for (int i = 1; i <= 8; ++i) hover(at + (to - at) * (static_cast<float>(i) / 8));
      frame();
      EXPECT_NEAR(parameter(5, one.parameter), one.to, snaps ? 2.5 : 0.8);
      EXPECT_EQ(std::remainder(parameter(5, one.parameter), snaps ? 5 : 0.5), 0);
      ASSERT_NE(find("View/Section"), nullptr);
      EXPECT_TRUE(find("View/Section")->value.starts_with(one.label)) << find("View/Section")->value;
      release();
      EXPECT_EQ(session_.history.undo.size(), undo + 1);
      good(edit::Undo{});
      EXPECT_EQ(parameter(5, one.parameter), one.was);
      frames(2);
    }
}

}  // namespace section_clicks_test
}  // namespace coaster::ui
