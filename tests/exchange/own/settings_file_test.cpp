#include "exchange/own/settings_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "world/other_settings.h"

namespace coaster::exchange {
namespace settings_file_test {

UserSettings unusual() {
  UserSettings s;
  world::for_each_setting([&]<auto Setting>() {
    if constexpr (!world::setting_row<Setting>().kept_as.empty())
      world::value_in<Setting>(s.session) = test::other_value<Setting>();
  });
  s.autosave_seconds = 12.5;
  s.window = WindowPlace{-40, 7, 900, 601, true};
  s.recent = {"/a/b \"c\".json", "/\xc3\xa4.json"};
  s.start_screen = false;
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

TEST(settings_file, each_kept_setting_is_read_from_its_member) {
  world::for_each_setting([]<auto Setting>() {
    constexpr world::SettingRow row = world::setting_row<Setting>();
    if constexpr (!row.kept_as.empty()) {
      UserSettings changed;
      const world::Settings in_a_session;
      const auto at_first = world::value_in<Setting>(changed.session);
      const auto other = at_first == test::other_value<Setting>() ? world::value_in<Setting>(in_a_session)
                                                                  : test::other_value<Setting>();
      world::value_in<Setting>(changed.session) = other;
      const std::string text = print_settings(changed), member = "\"" + std::string(row.kept_as) + "\": ";
      ASSERT_NE(text.find(member), std::string::npos) << text;
      const auto loaded = parse_settings(text, "s");
      ASSERT_TRUE(loaded) << row.kept_as;
      EXPECT_EQ(world::value_in<Setting>(loaded->settings.session), other) << row.kept_as;
      EXPECT_TRUE(loaded->settings == changed) << row.kept_as;
    }
  });
}

TEST(settings_file, the_file_of_a_new_user_is_this) {
  EXPECT_EQ(print_settings(UserSettings{}), R"({
  "format": "coaster-settings",
  "version": 1,
  "ui_scale": 1,
  "theme": "dark",
  "style": "day",
  "scenery": "park",
  "units": "m_s",
  "shadows": true,
  "sound": 0.5,
  "panels": true,
  "laboratory": false,
  "laboratory_height": 0,
  "workspace": "all",
  "graph_height": 0,
  "reduced_motion": false,
  "head_bob": false,
  "follow": true,
  "autosave_seconds": 30,
  "window": null,
  "recent": [],
  "hints": true,
  "card": true,
  "gizmo": true,
  "new_land": "hills",
  "start_screen": true,
  "keys": {}
}
)");
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

TEST(settings_file, unknown_members_are_kept_up_to_a_limit) {
  const auto with = [](const std::string& members) {
    const auto loaded = parse_settings(R"({"format": "coaster-settings", "version": 1, )" + members + "}", "s");
    EXPECT_TRUE(loaded);
    return *loaded;
  };
  const LoadedSettings few = with(R"("smell": {"of": "oil"})");
  EXPECT_TRUE(few.warnings.empty());
  EXPECT_NE(print_settings(few.settings).find("\"oil\""), std::string::npos);
  const LoadedSettings large = with("\"smell\": \"" + std::string(kMaxOtherBytes, 'o') + "\", \"sound\": 0.25");
  ASSERT_EQ(large.warnings.size(), 1u);
  EXPECT_NE(large.warnings[0].find("1 unknown members"), std::string::npos) << large.warnings[0];
  EXPECT_LT(print_settings(large.settings).size(), 2000u);
  EXPECT_EQ(large.settings.session.look->sound, 0.25f);
  std::string many;
  for (int i = 0; i < 5000; ++i) many += fmt::format("\"m{}\": 0, ", i);
  EXPECT_EQ(with(many + "\"sound\": 1").warnings.size(), 1u);
}

TEST(settings_file, a_newer_version_is_refused) {
  for (const char* version : {"2", "1.5", "18446744073709551615", "1e300"}) {
    const auto loaded = parse_settings(fmt::format(R"({{"format": "coaster-settings", "version": {}}})", version), "s");
    ASSERT_EQ(loaded.status().code, base::Code::bad_file) << version;
    EXPECT_NE(loaded.status().message.find("newer"), std::string::npos) << loaded.status().message;
  }
  EXPECT_EQ(parse_settings(R"({"format": "coaster-settings"})", "s")->warnings.size(), 1u);
}

// The whole range of each number, not only those that are short.
RC_GTEST_PROP(settings_file, every_number_is_read_back_the_same, (std::uint32_t a, std::uint32_t b, std::uint64_t c)) {
  UserSettings settings;
  settings.session.look->sound = static_cast<float>(a) / 4294967296.0f;
  settings.session.look->ui_scale = 0.75f + static_cast<float>(b) / 4294967296.0f;
  settings.autosave_seconds = 5 + static_cast<double>(c % 3'000'000'000'000'000) / 1e12;
  const auto loaded = parse_settings(print_settings(settings), "s");
  RC_ASSERT(loaded.ok());
  RC_ASSERT(loaded->settings == settings);
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
