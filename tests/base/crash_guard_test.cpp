#include "base/crash_guard.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "base/check.h"
#include "base/memory_guard.h"

namespace coaster::base {
namespace crash_guard_test {

// Leaves a quarter of kLeastSpace: stacks and the sanitizers' runtime still grow, but the guard's reservation fails.
void take_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + kLeastSpace / 4;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

TEST(crash_guard, a_crash_without_address_space_is_the_end_of_memory) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
    EXPECT_EXIT((guard_crashes(), take_space(), std::raise(signal)), testing::ExitedWithCode(kMemoryExitCode),
                "^Out of memory.\n$");
  EXPECT_EXIT((take_space(), end_if_out_of_memory()), testing::ExitedWithCode(kMemoryExitCode), "^Out of memory.\n$");
}

TEST(crash_guard, a_crash_with_an_explanation_prints_it_and_ends_with_its_code) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
    EXPECT_EXIT((guard_crashes(), explain_crashes("The driver.", 4), std::raise(signal)), testing::ExitedWithCode(4),
                "^The driver.\n$");
  EXPECT_EXIT((guard_crashes(), explain_crashes("The driver.", 4), take_space(), std::abort()),
              testing::ExitedWithCode(kMemoryExitCode), "^Out of memory.\n$");
  EXPECT_EXIT((guard_crashes(), explain_crashes("The driver.", 4), explain_crashes("", 0), std::abort()),
              testing::KilledBySignal(SIGABRT), "^$");
}

TEST(crash_guard, other_crashes_stay_what_they_are) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((guard_crashes(), guard_crashes(), std::abort()), testing::KilledBySignal(SIGABRT), "^$");
  EXPECT_DEATH((guard_crashes(), check_failed("a", "b", "c", 1)), "^c:1: check failed: a \\(b\\)\n$");
  EXPECT_EXIT((end_if_out_of_memory(), std::_Exit(0)), testing::ExitedWithCode(0), "^$");
}

}  // namespace crash_guard_test
}  // namespace coaster::base
