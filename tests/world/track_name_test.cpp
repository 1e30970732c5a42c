// Part: src/world/document.
#include "world/document.h"

#include <gtest/gtest.h>

namespace coaster::world {
namespace track_name_test {

TEST(track_name, is_that_of_the_file_where_nobody_has_named_the_track) {
  EXPECT_EQ(track_name("Red Comet", "/a/loop.json"), "Red Comet");
  EXPECT_EQ(track_name("Untitled", "/a/my ride.json"), "my ride");
  EXPECT_EQ(track_name("", "b.csv"), "b");
  EXPECT_EQ(track_name("Untitled", ""), "Untitled");
}

}  // namespace track_name_test
}  // namespace coaster::world
