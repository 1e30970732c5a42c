#include "platform/signals.h"

#include <unistd.h>
#include <csignal>

#include <gtest/gtest.h>

namespace coaster::platform {
namespace signals_test {

TEST(signals_test, the_first_is_noted_and_the_second_ends_the_program) {
  for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGPWR})
    EXPECT_EXIT(
        {
          if (pending_signal() != 0) _exit(1);
          watch_signals();
          if (pending_signal() != 0) _exit(2);
          std::raise(number);
          if (pending_signal() != number) _exit(3);
          std::raise(number);
        },
        testing::KilledBySignal(number), "")
        << number;
}

TEST(signals_test, signals_that_the_system_repeats_are_noted_each_time) {
  for (const int number : {SIGPIPE, SIGXCPU})
    EXPECT_EXIT(
        {
          watch_signals();
          std::raise(number);
          std::raise(number);
          _exit(pending_signal());
        },
        testing::ExitedWithCode(number), "")
        << number;
}

// As nohup starts a program, and a shell its background jobs.
TEST(signals_test, signals_that_are_ignored_from_outside_stay_ignored) {
  for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGPWR, SIGPIPE, SIGXCPU})
    EXPECT_EXIT(
        {
          (void)std::signal(number, SIG_IGN);
          watch_signals();
          std::raise(number);
          std::raise(number);
          _exit(pending_signal());
        },
        testing::ExitedWithCode(0), "")
        << number;
}

}  // namespace signals_test
}  // namespace coaster::platform
