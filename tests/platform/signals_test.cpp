#include "platform/signals.h"

#include <unistd.h>
#include <csignal>

#include <gtest/gtest.h>

namespace coaster::platform {
namespace signals_test {

TEST(signals_test, the_first_is_noted_and_the_second_ends_the_program) {
  for (const int number : {SIGTERM, SIGINT, SIGHUP})
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

TEST(signals_test, a_closed_pipe_is_noted_however_often_it_is_written_to) {
  EXPECT_EXIT(
      {
        watch_signals();
        std::raise(SIGPIPE);
        std::raise(SIGPIPE);
        _exit(pending_signal());
      },
      testing::ExitedWithCode(SIGPIPE), "");
}

}  // namespace signals_test
}  // namespace coaster::platform
