#include "exchange/own/settings_file.h"

#include <gtest/gtest.h>

namespace coaster::exchange {
namespace settings_file_test {

UserSettings unusual() {
  UserSettings s;
  s.ui_scale = 1.75f;
  s.theme = world::Theme::high_contrast;
  s.style = world::Style::blueprint;
  s.sound = 0.125f;
  s.panels = s.shadows = false;
  s.laboratory = s.reduced_motion = s.head_bob = true;
  s.autosave_seconds = 12.5;
  s.window = WindowPlace{-40, 7, 900, 601, true};
  s.recent = {"/a/b \"c\".json", "/\xc3\xa4.json"};
  s.hints = s.gizmo = s.start_screen = s.card = false;
  s.keys = {{"Undo", {"Ctrl+U"}}, {"Redo", {"Ctrl+R", "F4"}}, {"Reset", {}}, {"No such action", {"F9"}}};
  s.others = R"({"later":[1,2]})";
  return s;
}

TEST(settings_file, printing_and_parsing_gives_the_same_settings_back) {
  for (const UserSettings& settings : {UserSettings{}, unusual()}) {
    const auto loaded = parse_settings(print_settings(settings), "s");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_TRUE(loaded->settings == settings) << print_settings(loaded->settings);
    EXPECT_TRUE(loaded->warnings.empty());
  }
}

TEST(settings_file, a_wrong_member_becomes_its_default_and_is_told_while_the_others_hold) {
  const auto loaded = parse_settings(
      R"({"format": "coaster-settings", "version": 1, "ui_scale": 17, "theme": "pink", "style": "noon", "sound": -1, "panels": "yes", "autosave_seconds": 40,
    "window": {"x": 1, "y": 2}, "keys": {"Undo": 3}, "recent": "one"})",
      "s");
  ASSERT_TRUE(loaded);
  UserSettings expected;
  expected.autosave_seconds = 40;
  EXPECT_TRUE(loaded->settings == expected);
  ASSERT_EQ(loaded->warnings.size(), 8u);
  EXPECT_EQ(loaded->warnings[0], "ui_scale: expected a number from 0.75 to 3, found 17");
}

TEST(settings_file, what_is_no_settings_file_is_refused) {
  for (const char* text : {"", "garbage", "[1]", "{}", R"({"format": "coaster-track"})",
                           "{\"format\": \"coaster-settings\", ", "\xff\xfe"}) {
    const auto loaded = parse_settings(text, "s");
    EXPECT_EQ(loaded.status().code, base::Code::bad_file) << text;
  }
}

TEST(settings_file, members_of_later_versions_are_kept) {
  const auto loaded = parse_settings(R"({"format": "coaster-settings", "version": 9, "smell": {"of": "oil"}})", "s");
  ASSERT_TRUE(loaded);
  EXPECT_NE(print_settings(loaded->settings).find("\"oil\""), std::string::npos);
}

TEST(settings_file, the_newest_recent_file_is_first_once_and_ten_are_kept) {
  std::vector<std::string> recent;
  for (int i = 0; i < 14; ++i) remember(recent, std::to_string(i));
  remember(recent, "9");
  ASSERT_EQ(recent.size(), kMaxRecent);
  EXPECT_EQ(recent[0], "9");
  EXPECT_EQ(recent[1], "13");
  EXPECT_EQ(std::count(recent.begin(), recent.end(), "9"), 1);
}

}  // namespace settings_file_test
}  // namespace coaster::exchange
