// The rows of all settings.
#include "world/settings.h"

#include <set>
#include <string_view>
#include <type_traits>

#include <gtest/gtest.h>

#include "world/aid_settings.h"
#include "world/heap_value.h"
#include "world/other_settings.h"
#include "world/settings_groups.h"

namespace coaster::world {
namespace settings_test {

TEST(settings, a_box_is_a_value) {
  HeapValue<EditingAids> box;
  box->circuit = 2;
  HeapValue<EditingAids> copy = box;
  EXPECT_TRUE(copy == box);
  copy->circuit = 1;
  EXPECT_EQ(box->circuit, 2) << "each has its own";
  box = copy;
  EXPECT_EQ((*box).circuit, 1);
  EXPECT_TRUE(copy == box);
}

TEST(settings, every_row_has_help_and_limits_that_hold_its_default) {
  const Settings settings;
  for_each_setting([&]<auto Setting>() {
    constexpr SettingRow row = setting_row<Setting>();
    using T = ValueOf<Setting>;
    EXPECT_TRUE(row.help.ends_with('.')) << row.word;
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const auto at_first = static_cast<double>(value_in<Setting>(settings));
      EXPECT_LT(row.low, row.high) << row.word;
      EXPECT_LE(row.low, at_first) << row.word;
      EXPECT_GE(row.high, at_first) << row.word;
    }
    if (row.for_user >= 0) {
      EXPECT_TRUE((std::is_same_v<T, bool> || std::is_enum_v<T>)) << row.word;
      EXPECT_FALSE(row.kept_as.empty()) << row.word;
    }
    EXPECT_NE(test::other_value<Setting>(), value_in<Setting>(settings)) << row.word;
  });
}

TEST(settings, no_two_rows_share_a_name) {
  std::set<std::string_view> words, queries, members;
  for_each_setting([&]<auto Setting>() {
    constexpr SettingRow row = setting_row<Setting>();
    EXPECT_TRUE(words.insert(row.word).second) << row.word;
    EXPECT_TRUE(queries.insert(row.query_name()).second) << row.query_name();
    if (!row.kept_as.empty()) {
      EXPECT_TRUE(members.insert(row.kept_as).second) << row.kept_as;
    }
  });
  EXPECT_GE(words.size(), 30u);
}

TEST(settings, a_copy_is_equal_until_one_of_the_two_changes) {
  for_each_setting([]<auto Setting>() {
    Settings settings;
    Settings copy = settings;
    EXPECT_TRUE(copy == settings);
    value_in<Setting>(copy) = test::other_value<Setting>();
    EXPECT_FALSE(copy == settings) << setting_row<Setting>().word;
    settings = copy;
    EXPECT_TRUE(copy == settings) << setting_row<Setting>().word;
  });
}

}  // namespace settings_test
}  // namespace coaster::world
