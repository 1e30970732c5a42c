// Crashes on purpose.
#include "base/crash_guard.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace coaster::base {
namespace planned_crash_test {

TEST(planned_crash, it_comes_at_its_place_alone_and_in_its_way) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  crash_if_planned({}, CrashPlace::ticks);
  const PlannedCrash plan{CrashPlace::ticks, CrashCause::exception};
  crash_if_planned(plan, CrashPlace::drawing);
  EXPECT_THROW(crash_if_planned(plan, CrashPlace::ticks), std::runtime_error);
  EXPECT_DEATH(crash_if_planned(PlannedCrash{CrashPlace::job, CrashCause::check}, CrashPlace::job), "a planned crash");
}

}  // namespace planned_crash_test
}  // namespace coaster::base
