#include "exchange/own/json_output.h"

#include <gtest/gtest.h>

#include <limits>

namespace coaster::exchange {
namespace json_output_test {

TEST(json_values, members_of_every_kind_keep_their_order) {
  EXPECT_EQ(json_members({{"z", 0.1}, {"a", std::int64_t{-7}}, {"b", true}, {"c", "a\"\n"}, {"d", nullptr}}),
            "{\n  \"z\": 0.1,\n  \"a\": -7,\n  \"b\": true,\n  \"c\": \"a\\\"\\n\",\n  \"d\": null\n}\n");
  EXPECT_EQ(json_members({{"at", std::array{1.0, 0.5, -2.0}}}),
            "{\n  \"at\": [\n    1.0,\n    0.5,\n    -2.0\n  ]\n}\n");
  EXPECT_EQ(json_members(JsonMembers()), "{}\n");
}

TEST(json_values, what_json_lacks_is_replaced) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(json_members({{"a", std::numeric_limits<double>::quiet_NaN()}, {"b", -infinity}, {"a\xff", "\xc3"}}),
            "{\n  \"a\": null,\n  \"b\": null,\n  \"a\xEF\xBF\xBD\": \"\xEF\xBF\xBD\"\n}\n");
}

TEST(json_values, of_members_with_one_name_the_last_value_counts) {
  EXPECT_EQ(json_members({{"a", 1.5}, {"b", false}, {"a", nullptr}}), "{\n  \"a\": null,\n  \"b\": false\n}\n");
}

}  // namespace json_output_test
}  // namespace coaster::exchange
