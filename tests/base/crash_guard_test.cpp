#include "base/crash_guard.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "base/check.h"
#include "base/scratch_folder.h"

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
              testing::KilledBySignal(SIGABRT), "^coaster crashed \\(SIGABRT\\).\n$");
}

TEST(crash_guard, other_crashes_say_what_failed_and_stay_what_they_are) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((guard_crashes(), guard_crashes(), std::abort()), testing::KilledBySignal(SIGABRT),
              "^coaster crashed \\(SIGABRT\\).\n$");
  EXPECT_DEATH((guard_crashes(), check_failed("a", "b", "c", 1)), "^c:1: check failed: a \\(b\\).\n$");
  EXPECT_EXIT((guard_crashes(), std::thread([] { throw std::runtime_error("why"); }).join()),
              testing::KilledBySignal(SIGABRT), "^coaster crashed \\(exception: why\\).\n$");
  EXPECT_DEATH(check_failed("a", "b", "c", 1), "^c:1: check failed: a \\(b\\)\n$") << "without handlers, too";
  EXPECT_EXIT((end_if_out_of_memory(), std::_Exit(0)), testing::ExitedWithCode(0), "^$");
}

// What a process leaves that ends by a crash.
class CrashFiles : public testing::Test {
 protected:
  std::vector<CrashFile> made(const std::string& first, const std::string& second) {
    std::vector<CrashFile> all;
    all.push_back({std::move(*files.create(folder.path() / "first")), first});
    all.push_back({std::move(*files.create(folder.path() / "second")), second});
    return all;
  }
  // Runs `work` in a process of its own, which is silent; returns the signal that ended it.
  template <class Work>
  int crash(Work work) {
    const pid_t child = ::fork();
    if (child < 0) std::abort();
    if (child == 0) {
      const rlimit no_core{0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
      (void)std::freopen("/dev/null", "w", stderr);
      guard_crashes();
      work();
      std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }
  std::string text(const char* name) {
    const auto read = files.read(folder.path() / name);
    return read ? *read : "none";
  }

  test::ScratchFolder folder;
  Files files;
};

TEST_F(CrashFiles, a_crash_of_any_kind_completes_them_all) {
  const std::string large(3'000'000, 'x');  // more than a pipe or a page
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) {
    crash([&] {
      keep_for_crash(made(large, std::to_string(signal)));
      std::raise(signal);
    });
    EXPECT_EQ(text("first"), large) << signal;
    EXPECT_EQ(text("second"), std::to_string(signal));
  }
}

int descend(volatile int* above) {
  volatile int here = *above + 1;
  if (here < 0) return 0;
  return descend(&here) + *above;
}

TEST_F(CrashFiles, so_does_an_overflowed_stack_of_any_thread) {
  for (const bool in_thread : {false, true}) {
    crash([&] {
      keep_for_crash(made("a", in_thread ? "thread" : "main"));
      volatile int top = 0;
      if (!in_thread) descend(&top);
      std::thread([&] {
        const HandlerStack stack;
        descend(&top);
      }).join();
    });
    EXPECT_EQ(text("second"), in_thread ? "thread" : "main");
  }
}

TEST_F(CrashFiles, after_one_that_cannot_be_written_none_follows) {
  crash([&] { keep_for_crash(made("old", "old")), std::raise(SIGSEGV); });
  crash([&] {
    keep_for_crash(made(std::string(5000, 'x'), "new"));
    (void)std::signal(SIGXFSZ, SIG_IGN);
    const rlimit most{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &most);
    std::raise(SIGSEGV);
  });
  EXPECT_EQ(text("first"), "old");
  EXPECT_EQ(text("second"), "old");
}

TEST_F(CrashFiles, without_a_crash_nothing_is_left) {
  keep_for_crash(made("a", "b"));
  keep_for_crash(made("c", "d"));
  keep_for_crash({});
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 0);
}

// The files are of one keep_for_crash() each, however often another thread replaces them meanwhile.
TEST_F(CrashFiles, a_crash_while_they_are_replaced_completes_one_of_them) {
  for (int run = 0; run < 12; ++run) {
    crash([&] {
      keep_for_crash(made("0", "0"));
      std::thread([&] {
        for (int i = 1;; ++i)
          keep_for_crash(made(std::string(i % 7 * 1000, 'x') + std::to_string(i), std::to_string(i)));
      }).detach();
      std::this_thread::sleep_for(std::chrono::milliseconds(run % 4));
      std::raise(SIGABRT);
    });
    const std::string first = text("first"), second = text("second");
    EXPECT_EQ(first.substr(first.find_last_of('x') + 1), second);
    EXPECT_NE(second, "none");
  }
}

}  // namespace crash_guard_test
}  // namespace coaster::base
