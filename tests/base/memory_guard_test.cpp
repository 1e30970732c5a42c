// The end of memory.
#include "base/crash_guard.h"

#include <gtest/gtest.h>

#include <new>
#include <thread>

namespace coaster::base {
namespace memory_guard_test {

// What operator new does when malloc fails: it calls the handler, until one does not return.
void fail() {
  for (;;) std::get_new_handler()();
}

TEST(memory_guard, a_failed_allocation_saves_says_one_line_and_ends_with_70) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((guard_memory(), fail()), testing::ExitedWithCode(kMemoryExitCode), "^Out of memory.\n$");
  const auto saving = [] { return std::string("Saved."); };
  EXPECT_EXIT((guard_memory(), on_memory_end(saving), fail()), testing::ExitedWithCode(kMemoryExitCode),
              "^Out of memory. Saved.\n$");
}

TEST(memory_guard, one_that_fails_while_it_saves_ends_too) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto saving = [] {
    fail();
    return std::string("Saved.");
  };
  EXPECT_EXIT((guard_memory(), on_memory_end(saving), fail()), testing::ExitedWithCode(kMemoryExitCode),
              "^Out of memory.\n$");
}

TEST(memory_guard, another_thread_saves_nothing) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto saving = [] { return std::string("Saved."); };
  EXPECT_EXIT((guard_memory(), on_memory_end(saving), std::thread(fail).join()),
              testing::ExitedWithCode(kMemoryExitCode), "^Out of memory.\n$");
}

}  // namespace memory_guard_test
}  // namespace coaster::base
