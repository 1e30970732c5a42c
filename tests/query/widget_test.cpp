#include "query/widget.h"

#include <gtest/gtest.h>

namespace coaster::query {
namespace widget_test {

TEST(widget, shows_its_value_and_a_button_or_text_without_one_its_label) {
  EXPECT_EQ((Widget{.path = "Track/Length", .kind = "label", .value = "7 m"}.text()), "7 m");
  EXPECT_EQ((Widget{.path = "Track/Length", .kind = "label"}.text()), "Length");
  EXPECT_EQ((Widget{.path = "Track/Points/Insert", .kind = "button"}.text()), "Insert");
  EXPECT_EQ((Widget{.path = "Goal", .kind = "button"}.text()), "Goal");
  EXPECT_EQ((Widget{.path = "Track/Title", .kind = "text"}.text()), "") << "an empty field";
}

TEST(widget, is_called_by_its_path_and_by_its_alias) {
  const Widget renamed{.path = "Start/Back to the track", .alias = "Start/Build on"};
  EXPECT_TRUE(renamed.is("Start/Back to the track"));
  EXPECT_TRUE(renamed.is("Start/Build on"));
  EXPECT_FALSE(renamed.is("Build on"));
  EXPECT_FALSE((Widget{.path = "Start/Quit"}.is(""))) << "it has no alias";
}

}  // namespace widget_test
}  // namespace coaster::query
