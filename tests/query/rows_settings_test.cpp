// Each setting's query returns the value that its command set.
#include <type_traits>

#include "edit/commands/codec.h"
#include "edit/commands/set_setting.h"
#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"
#include "world/other_settings.h"

namespace coaster::query {
namespace rows_settings_test {

class SettingQueries : public test::SessionTest {
 protected:
  std::string answer(std::string_view name) {
    const Query* const query = find_query(name);
    EXPECT_NE(query, nullptr) << name;
    if (query == nullptr) return {};
    const auto value = query->evaluate({session, stats, "", ""}, "");
    EXPECT_TRUE(value) << name;
    return value ? to_text(*value) : "";
  }
  FrameStats stats;
};

TEST_F(SettingQueries, what_a_command_sets_its_query_tells) {
  world::for_each_setting([&]<auto Setting>() {
    constexpr world::SettingRow row = world::setting_row<Setting>();
    const auto value = test::other_value<Setting>();
    const edit::Command set = edit::Set<Setting>{value};
    const std::string line = edit::print(set), before = answer(row.query_name());
    ASSERT_TRUE(line.starts_with(std::string(row.word) + " ")) << line;
    good(line);
    EXPECT_EQ(world::value_in<Setting>(session.settings), value) << line;
    EXPECT_NE(answer(row.query_name()), before) << line;
    EXPECT_EQ(std::string(row.word) + " " + answer(row.query_name()), line);
  });
}

TEST_F(SettingQueries, numbers_beyond_the_limits_are_clamped_to_them) {
  const world::Settings at_first;
  world::for_each_setting([&]<auto Setting>() {
    constexpr world::SettingRow row = world::setting_row<Setting>();
    using T = world::ValueOf<Setting>;
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      clamped(std::string(row.word) + " " + base::to_text(row.low - 1), "limit of");
      EXPECT_EQ(world::value_in<Setting>(session.settings), static_cast<T>(row.low)) << row.word;
      good(edit::print(edit::Set<Setting>{world::value_in<Setting>(at_first)}));
    }
  });
}

}  // namespace rows_settings_test
}  // namespace coaster::query
