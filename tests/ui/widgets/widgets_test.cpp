#include "ui/widgets/widgets.h"

#include <imgui_internal.h>

#include <ctime>

#include "base/text.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/appearance_settings.h"
#include "world/evaluation_settings.h"

namespace coaster::ui {
namespace widgets_test {

struct WidgetsTest : Stage {};

TEST_F(WidgetsTest, a_click_on_a_radio_chooses_that_evaluator_and_no_other) {
  click("Evaluation/Forward differences");
  ASSERT_EQ(all<edit::Set<&world::Evaluation::evaluator>>().size(), 1u);
  const curve::EvaluatorId chosen = session_.settings.evaluation->evaluator;
  EXPECT_EQ(base::row_of(chosen).label, "Forward differences");
  EXPECT_EQ(find("Evaluation/Forward differences")->value, "on");
  EXPECT_EQ(find("Evaluation/Horner")->value, "off");
  click("Evaluation/Forward differences");
  EXPECT_EQ(all<edit::Set<&world::Evaluation::evaluator>>().size(), 1u) << "already on: nothing to ask for";
}

TEST_F(WidgetsTest, a_changed_label_is_shown_and_its_former_path_is_kept_as_an_alias) {
  select(world::EntityKind::segment, 1);
  const Widget* const now = find("Inspector/Position t");
  ASSERT_NE(now, nullptr);
  EXPECT_EQ(now->path, "Inspector/Position t");
  EXPECT_EQ(now->alias, "Inspector/Place");
  EXPECT_EQ(find("Inspector/Place"), now);
  EXPECT_EQ(find("Inspector/Turns")->alias, "");
  type("Inspector/Place", "0.25");
  EXPECT_DOUBLE_EQ(session_.settings.selected_t, 0.25);
  for (const Widget& widget : host_->widgets()) EXPECT_EQ(widget.path.find("###"), std::string::npos) << widget.path;
}

TEST_F(WidgetsTest, a_text_too_long_for_its_room_keeps_as_much_as_fits_beside_dots) {
  frame();
  const std::string text = "Gr\u00FCner Berg \u2013 Achterbahn", dots = "\u2026";
  EXPECT_EQ(shortened(text, text_size(text).x), text);
  for (float room = 0; room < text_size(text).x; ++room)
    for (const bool end : {false, true}) {
      const std::string cut = shortened(text, room, end);
      EXPECT_LE(text_size(cut).x, room);
      EXPECT_TRUE(base::is_printable_utf8(cut)) << cut;
      if (cut.empty()) continue;
      ASSERT_TRUE(end ? cut.starts_with(dots) : cut.ends_with(dots)) << cut;
      const std::string kept = end ? cut.substr(dots.size()) : cut.substr(0, cut.size() - dots.size());
      EXPECT_TRUE(end ? text.ends_with(kept) : text.starts_with(kept)) << cut;
      const std::size_t next = text.size() - kept.size();
      const std::size_t more =
          end ? base::utf8_start(text, next - 1).size() : kept.size() + base::utf8_length(text.substr(kept.size()));
      const std::string longer = end ? dots + text.substr(more) : text.substr(0, more) + dots;
      EXPECT_GE(text_size(longer).x, room) << "one more character does not fit; sizes are rounded up";
    }
}

TEST_F(WidgetsTest, a_very_long_text_is_shortened_in_little_time) {
  frame();
  const std::string text(100'000, 'x');
  const auto seconds = [](const auto& work) {
    const std::clock_t from = std::clock();
    work();
    return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
  };
  const double measured = seconds([&] {
    for (int i = 0; i < 20; ++i) (void)text_size(text);
  });
  for (const bool end : {false, true})
    EXPECT_LT(seconds([&] { (void)shortened(text, 300, end); }), 2 * measured + 0.01) << "as 40 times measuring it";
}

TEST_F(WidgetsTest, the_tooltip_of_a_text_that_is_cut_has_all_of_it) {
  ASSERT_TRUE(edit::apply(session_, files_, edit::SetTrackName{"Oblivion of the Northern Mountains and Lakes"}).ok());
  ASSERT_TRUE(reach("Track/Name"));
  hover(middle(*find("Track/Name")));
  frames(60);
  const ImGuiWindow* tooltip = nullptr;
  for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
    if ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active) tooltip = window;
  ASSERT_NE(tooltip, nullptr);
  EXPECT_GT(tooltip->Size.x, text_size("Oblivion of the Northern Mountains").x);
}

TEST_F(WidgetsTest, a_press_and_release_in_one_frame_is_a_click) {
  ASSERT_TRUE(reach("Track/Closed"));
  const glm::vec2 at = middle(*find("Track/Closed"));
  hover(at);
  frame({platform::MouseButton{platform::Button::left, true, {}},
         platform::MouseButton{platform::Button::left, false, {}}});
  frames(2);
  EXPECT_TRUE(session_.document.track.closed);
}

// What a click or a key shows often lies under the tooltip: the parameters of an element, the items of a list.
TEST_F(WidgetsTest, a_click_or_a_key_ends_the_tooltip_until_the_mouse_has_left) {
  const auto tooltip = [] {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    for (const ImGuiWindow* const window : g.Windows)
      if ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active) return true;
    return false;
  };
  ASSERT_TRUE(reach("Elements/Loop"));
  const glm::vec2 at = middle(*find("Elements/Loop")), away = at + glm::vec2(0, 400);
  const auto rest = [&] {
    hover(away);
    hover(at);
    frames(40);
  };
  rest();
  EXPECT_TRUE(tooltip());
  click_at(at);
  frames(60);
  EXPECT_FALSE(tooltip()) << "after a click";
  rest();
  EXPECT_TRUE(tooltip()) << "the mouse has come back";
  key(platform::Key::f);
  frames(60);
  EXPECT_FALSE(tooltip()) << "after a key";
}

TEST_F(WidgetsTest, a_disabled_button_asks_for_nothing) {
  frames(2);
  ASSERT_FALSE(find("Track/Delete")->enabled);
  click("Track/Delete");
  EXPECT_TRUE(commands_.empty());
}

TEST_F(WidgetsTest, a_list_opens_covers_what_is_under_it_and_chooses) {
  click("Evaluation/Arc length");
  const auto methods = curve::arc_length_methods();
  const std::string second = "Evaluation/Arc length/" + std::string(methods[1].label);
  ASSERT_NE(find(second), nullptr);
  EXPECT_FALSE(find(second)->covered);
  EXPECT_EQ(find(second)->kind, "item");
  EXPECT_TRUE(find("Evaluation/Show polyline")->covered) << "the list takes the mouse from the panel";
  EXPECT_TRUE(host_->wants_keyboard());
  click_at(middle(*find(second)));
  EXPECT_EQ(session_.settings.evaluation->arc_length, static_cast<curve::ArcLengthId>(1));
  EXPECT_EQ(find(second), nullptr);
  EXPECT_FALSE(find("Evaluation/Show polyline")->covered);
}

TEST_F(WidgetsTest, keys_choose_in_a_list_and_do_not_reach_the_track) {
  const auto methods = curve::arc_length_methods();
  const auto chosen = [&] { return static_cast<std::size_t>(session_.settings.evaluation->arc_length); };
  const auto choose = [&](std::initializer_list<platform::Key> keys) {
    click("Evaluation/Arc length");
    for (const platform::Key k : keys) key(k), frames(2);
    EXPECT_FALSE(host_->wants_keyboard()) << "the list is closed";
    return chosen();
  };
  using platform::Key;
  const std::size_t first = chosen(), last = methods.size() - 1;
  ASSERT_LT(first + 2, last);
  EXPECT_EQ(choose({Key::down, Key::down, Key::enter}), first + 2) << "it starts at the current choice";
  EXPECT_EQ(choose({Key::up, Key::keypad_enter}), first + 1);
  EXPECT_EQ(choose({Key::end, Key::enter}), last);
  EXPECT_EQ(choose({Key::home, Key::down, Key::enter}), 1u);
  EXPECT_EQ(choose({Key::down, Key::escape}), 1u);
  EXPECT_TRUE(all<edit::PlaceElement>().empty());
  EXPECT_EQ(session_.motion.state, world::RideState::stopped);
}

TEST_F(WidgetsTest, keys_walk_through_menus_from_the_first_item_on) {
  using platform::Key;
  const auto press_keys = [&](std::initializer_list<Key> keys) {
    for (const Key k : keys) key(k), frames(2);
  };
  click("Menu/Edit");
  frames(2);
  ASSERT_TRUE(find("Menu/Edit/Undo")->enabled);
  const std::size_t knots = session_.document.track.knots.size(), steps = session_.history.undo.size();
  press_keys({Key::down, Key::enter});
  EXPECT_EQ(session_.history.undo.size(), steps - 1);
  press_keys({Key::enter, Key::space, Key::down});
  EXPECT_EQ(session_.history.undo.size(), steps - 1) << "the menu is closed";
  EXPECT_EQ(session_.motion.state, world::RideState::running) << "Space is the ride's again";
  EXPECT_EQ(session_.document.track.knots.size(), knots);
}

TEST_F(WidgetsTest, escape_closes_a_list_before_its_dialog) {
  user_.emplace();
  key(platform::Key::comma, {.ctrl = true});
  frames(3);
  ASSERT_NE(find("Settings/Theme"), nullptr);
  click("Settings/Theme");
  const std::string item = "Settings/Theme/" + std::string(base::row_of(world::Theme::light).label);
  ASSERT_NE(find(item), nullptr);
  key(platform::Key::escape);
  frames(2);
  EXPECT_EQ(find(item), nullptr);
  ASSERT_NE(find("Settings/Theme"), nullptr);
  click("Settings/Theme");
  key(platform::Key::down), frames(2), key(platform::Key::enter), frames(2);
  EXPECT_NE(session_.settings.look->theme, world::Theme::dark) << "not the dialog's Enter";
  key(platform::Key::escape);
  frames(2);
  EXPECT_EQ(find("Settings/Theme"), nullptr);
}

TEST_F(WidgetsTest, a_closed_header_hides_its_panel_and_opens_again) {
  click("Evaluation");
  EXPECT_EQ(find("Evaluation")->value, "closed");
  EXPECT_EQ(find("Evaluation/Horner"), nullptr);
  click("Evaluation");
  EXPECT_NE(find("Evaluation/Horner"), nullptr);
}

TEST_F(WidgetsTest, what_is_scrolled_out_is_not_visible) {
  resize(640, 360);
  ASSERT_NE(find("Statistics/Samples"), nullptr);
  EXPECT_FALSE(find("Statistics/Samples")->visible);
  ASSERT_TRUE(reach("Statistics/Samples"));
  EXPECT_FALSE(find("Evaluation/Horner")->visible);
}

TEST_F(WidgetsTest, menus_list_their_actions_and_run_them) {
  select(world::EntityKind::knot, 2);
  click("Menu/Edit");
  ASSERT_NE(find("Menu/Edit/Delete"), nullptr);
  EXPECT_TRUE(find("Menu/Edit/Delete")->enabled);
  EXPECT_FALSE(find("Menu/Edit/Redo")->enabled);
  click_at(middle(*find("Menu/Edit/Delete")));
  EXPECT_EQ(session_.document.track.knots.size(), 2u);
  EXPECT_EQ(find("Menu/Edit/Delete"), nullptr);
}

TEST(fixed_text, never_shows_a_negative_zero) {
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(1234.5, 1), "1234.5");
}

}  // namespace widgets_test
}  // namespace coaster::ui
