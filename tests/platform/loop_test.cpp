// The loop of frames.
#include "platform/system.h"

#include <gtest/gtest.h>

namespace coaster::platform {
namespace loop_test {

TEST(loop, steps_until_a_step_says_no_and_ends_with_the_code) {
  int steps = 0;
  EXPECT_EQ(run_frames([&] { return ++steps < 5; }, [&] { return 10 + steps; }), 15);
  EXPECT_EQ(steps, 5);
}

}  // namespace loop_test
}  // namespace coaster::platform
