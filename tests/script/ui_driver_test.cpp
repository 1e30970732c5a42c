// Widgets by label path: which one is selected, which are refused, and that a click takes a frame each for move, press
// and release.
#include "script/ui_driver.h"
#include "world/panel_settings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "edit/commands/commands_document.h"
#include "script/fake_host.h"

namespace coaster::script {
namespace ui_driver_test {

query::Widget widget(const std::string& path, const std::string& kind = "button", const std::string& value = "") {
  query::Widget w;
  w.path = path, w.kind = kind, w.value = value;
  w.x = 11, w.y = 23, w.width = 40, w.height = 10;
  return w;
}

TEST(widgets, a_path_is_found_whole_by_its_end_in_any_case_or_by_its_parts) {
  const std::vector<query::Widget> all{
      widget("Track/Insert point"), widget("Track/Delete"), widget("Inspector/Position/x", "number"),
      widget("Inspector/Delete"),   widget("Ride/Start"),   widget("Track/Start", "label")};
  EXPECT_EQ(*find_widget(all, "Track/Insert point"), 0u);
  EXPECT_EQ(*find_widget(all, "Insert point"), 0u);
  EXPECT_EQ(*find_widget(all, "track/insert POINT"), 0u);
  EXPECT_EQ(*find_widget(all, "Position/x"), 2u);
  EXPECT_EQ(*find_widget(all, "Inspector/x"), 2u);
  EXPECT_EQ(*find_widget(all, "Start"), 4u) << "labels stand back";
  EXPECT_EQ(find_widget(all, "Delete").status().message,
            "\"Delete\" matches several widgets: \"Track/Delete\" (button), \"Inspector/Delete\" (button)");
  EXPECT_EQ(find_widget(all, "Track/Insert pont").status().message,
            "no widget \"Track/Insert pont\"; did you mean \"Track/Insert point\"?");
  EXPECT_FALSE(find_widget(all, "oint").ok());
}

TEST(widgets, a_path_over_the_limit_matches_nothing) {
  const auto named = [](std::size_t bytes) {
    return std::vector<query::Widget>{{"Panel/" + std::string(bytes - 6, 'a')}};
  };
  EXPECT_TRUE(find_widget(named(kMostPathBytes), named(kMostPathBytes)[0].path));
  const auto longer = find_widget(named(kMostPathBytes + 1), named(kMostPathBytes + 1)[0].path);
  EXPECT_EQ(longer.status().message, "expected a widget's path of at most 1000 bytes, found 1001");
}

TEST(widgets, a_path_of_former_labels_finds_the_same_widget) {
  std::vector<query::Widget> all{widget("Forces/Suggest a fix"), widget("Forces/What is it")};
  all[0].alias = "Forces/What helps?";
  for (const char* path : {"Forces/Suggest a fix", "Suggest a fix", "Forces/What helps?", "What helps?", "what HELPS?"})
    EXPECT_EQ(*find_widget(all, path), 0u) << path;
  EXPECT_EQ(*find_widget(all, "What is it"), 1u);
}

TEST(ui_driver, a_click_moves_presses_and_releases_in_three_frames_and_its_command_is_in_the_last) {
  FakeHost fake;
  fake.widgets = {widget("Track/Add point")};
  fake.at_release = {edit::AppendKnot{{1.5f, 2.25f, 3.125f}}};
  ASSERT_TRUE(run_lines(fake, "frames 1\nui.click \"Track/Add point\"\nexpect uploads == 1\n").ok());
  ASSERT_GE(fake.frames.size(), 4u);
  const std::size_t n = fake.frames.size();
  const auto& move = std::get<platform::MouseMove>(fake.frames[n - 3].first.at(0));
  EXPECT_FLOAT_EQ(move.x, 31);
  EXPECT_FLOAT_EQ(move.y, 28);
  EXPECT_TRUE(std::get<platform::MouseButton>(fake.frames[n - 2].first.at(0)).down);
  EXPECT_FALSE(std::get<platform::MouseButton>(fake.frames[n - 1].first.at(0)).down);
}

TEST(ui_driver, disabled_covered_hidden_missing_and_ambiguous_widgets_are_refused_with_the_reason) {
  FakeHost fake;
  fake.widgets = {widget("A/off"), widget("A/under"), widget("A/gone"), widget("A/twin"), widget("A/twin")};
  fake.widgets[0].enabled = false;
  fake.widgets[1].covered = true;
  fake.widgets[2].visible = false;
  EXPECT_NE(run_lines(fake, "ui.click \"A/off\"\n").message.find("test.coaster:2:10: error: \"A/off\" is disabled"),
            std::string::npos);
  EXPECT_NE(run_lines(fake, "ui.click \"A/under\"\n").message.find("covered"), std::string::npos);
  EXPECT_NE(run_lines(fake, "ui.click \"A/gone\"\n").message.find("out of sight"), std::string::npos);
  EXPECT_EQ(run_lines(fake, "ui.click \"A/of\"\n").code, base::Code::usage);
  EXPECT_EQ(run_lines(fake, "ui.click \"A/twin\"\n").code, base::Code::usage);
  EXPECT_TRUE(run_lines(fake,
                        "expect not enabled \"A/off\"\nexpect enabled \"A/under\"\nexpect not visible "
                        "\"A/gone\"\nexpect not visible \"A/never\"\n")
                  .ok());
  EXPECT_EQ(run_lines(fake, "expect visible \"A/never\"\n").code, base::Code::expectation);
  EXPECT_EQ(run_lines(fake, "expect enabled \"A/off\"\n").code, base::Code::expectation);
  const auto contains = [&](const std::string& line, const std::string& text) {
    const base::Status status = run_lines(fake, line + "\n");
    EXPECT_NE(status.message.find(text), std::string::npos) << status.message;
  };
  contains("expect visible \"A/under\"", "expected visible \"A/under\", found covered by another window");
  contains("expect visible \"A/gone\"", "found out of sight");
  contains("expect visible \"A/twin\"", "matches several widgets");
  contains("expect enabled \"A/never\"", "no widget \"A/never\"");
}

TEST(ui_driver, a_wait_for_a_widget_ends_when_it_shows_and_else_suggests_the_nearest) {
  FakeHost fake;
  fake.widgets = {widget("A/later")};
  EXPECT_TRUE(run_lines(fake, "wait not visible \"A/never\" max 3 ticks\nlog visible \"A/later\"\n").ok());
  for (const char* const line : {"visible \"A/laetr\"", "not enabled \"A/laetr\"", "text \"A/laetr\" == on"}) {
    const base::Status late = run_lines(fake, fmt::format("wait {} max 3 ticks\n", line));
    EXPECT_EQ(late.code, base::Code::timeout);
    EXPECT_NE(late.message.find("no widget \"A/laetr\""), std::string::npos) << late.message;
    EXPECT_NE(late.message.find("did you mean \"A/later\"?"), std::string::npos) << late.message;
  }
  FakeHost later;
  Host host = later.host();
  host.widgets = [&later] {
    std::vector<query::Widget> shown{widget("A/later")};
    shown[0].enabled = later.frames.size() >= 5;
    return shown;
  };
  base::Files files;
  const ParsedScript parsed =
      parse_script("coaster-script 1\nwait enabled \"later\" max 60 frames\n", "a.coaster", test_folder(), files);
  EXPECT_TRUE(run_script(parsed.script, host, {*base::FileRoot().open(test_folder() / "out"), false, {}}).ok());
  EXPECT_EQ(later.frames.size(), 5u);
}

TEST(ui_driver, a_widget_of_another_workspace_is_refused_with_its_name_and_the_workspace_stays) {
  FakeHost fake;
  fake.widgets = {widget("Elements/Loop")};
  fake.elsewhere_widgets = {widget("Ride/Place")};
  const base::Status refused = run_lines(fake, "workspace build\nui.click \"Ride/Place\"\n");
  EXPECT_EQ(refused.code, base::Code::expectation);
  EXPECT_NE(refused.message.find("\"Ride/Place\" is in the workspace ride: write \"workspace ride\" before"),
            std::string::npos)
      << refused.message;
  EXPECT_EQ(fake.session.settings.panels->workspace, world::Workspace::build);
  EXPECT_TRUE(run_lines(fake, "workspace ride\nui.click \"Ride/Place\"\n").ok());
  const base::Status nowhere = run_lines(fake, "workspace build\nui.click \"Elements/Lop\"\n");
  EXPECT_EQ(nowhere.code, base::Code::usage);
  EXPECT_NE(nowhere.message.find("no widget \"Elements/Lop\""), std::string::npos) << nowhere.message;
}

TEST(ui_driver, check_clicks_only_a_box_that_shows_the_other) {
  FakeHost fake;
  fake.widgets = {widget("A/box", "checkbox", "on")};
  const auto presses = [&] {
    int count = 0;
    for (const auto& [events, ticks] : fake.frames)
      for (const platform::Event& event : events)
        if (const auto* const button = std::get_if<platform::MouseButton>(&event)) count += button->down;
    return count;
  };
  ASSERT_TRUE(run_lines(fake, "ui.check \"A/box\" on\n").ok());
  EXPECT_EQ(presses(), 0);
  ASSERT_TRUE(run_lines(fake, "ui.check \"A/box\" off\n").ok());
  EXPECT_EQ(presses(), 1);
}

TEST(ui_driver, typing_opens_the_field_selects_all_types_and_enters) {
  FakeHost fake;
  fake.widgets = {widget("Inspector/Position/x", "number", "3.00")};
  ASSERT_TRUE(run_lines(fake, "ui.type \"Inspector/Position/x\" \"-7.5\"\n").ok());
  std::string seen;
  for (const auto& [events, ticks] : fake.frames)
    for (const platform::Event& event : events) {
      if (const auto* const b = std::get_if<platform::MouseButton>(&event); b && b->down)
        seen += b->modifiers.ctrl ? "ctrl+press " : "press ";
      if (const auto* const k = std::get_if<platform::KeyPress>(&event); k && k->down)
        seen += platform::to_text({k->key, k->modifiers}) + " ";
      if (const auto* const t = std::get_if<platform::TextInput>(&event)) seen += t->utf8 + " ";
    }
  EXPECT_EQ(seen, "ctrl+press Ctrl+A -7.5 Enter ");
}

TEST(ui_driver, a_widget_of_another_kind_is_refused_before_it_is_pressed) {
  FakeHost fake;
  fake.widgets = {widget("A/box", "checkbox", "on"), widget("A/name", "text", "x"), widget("A/go", "button")};
  const std::string lines[][2] = {
      {"ui.type \"A/box\" \"x\"", "\"A/box\" is a checkbox, expected a field, slider or cell"},
      {"ui.type \"A/go\" \"x\"", "\"A/go\" is a button, expected a field, slider or cell"},
      {"ui.check \"A/name\" on", "\"A/name\" is a text, expected a checkbox or radio button"},
      {"ui.check \"A/go\" on", "\"A/go\" is a button, expected a checkbox or radio button"}};
  for (const auto& [line, expected] : lines) {
    const base::Status status = run_lines(fake, line + "\n");
    EXPECT_EQ(status.code, base::Code::usage) << line;
    EXPECT_NE(status.message.find(expected), std::string::npos) << status.message;
  }
  for (const auto& [events, ticks] : fake.frames)
    for (const platform::Event& event : events) EXPECT_FALSE(std::holds_alternative<platform::MouseButton>(event));
}

}  // namespace ui_driver_test
}  // namespace coaster::script
