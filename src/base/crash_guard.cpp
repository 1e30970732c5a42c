#include "base/crash_guard.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/memory_guard.h"

namespace coaster::base {
namespace {

constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};
std::array<struct sigaction, kSignals.size()> earlier{};
std::array<char, 1u << 16> own_stack;  // the crash may be the overflow of a stack

// The line and the exit code of explain_crashes(). Other threads read it only while `holds` is true.
struct Explanation {
  std::atomic<bool> holds = false;
  std::string line;
  int exit_code = 0;
};
Explanation& explanation() {
  static Explanation one;
  return one;
}

[[noreturn]] void leave(std::string_view line, int exit_code) {
  (void)!::write(STDERR_FILENO, line.data(), line.size());
  std::_Exit(exit_code);
}

// Uses only functions that are allowed in a signal handler.
extern "C" void crashed(int signal) {
  end_if_out_of_memory();
  if (const Explanation& known = explanation(); known.holds) leave(known.line, known.exit_code);
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (kSignals[i] == signal) sigaction(signal, &earlier[i], nullptr);  // and the instruction crashes again
}

}  // namespace

std::string stack_problem() {
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kLeastStack) return {};
  return fmt::format("The stack is limited to {} kB. coaster needs {} kB (ulimit -s {}).", limit.rlim_cur >> 10,
                     kLeastStack >> 10, kLeastStack >> 10);
}

void guard_crashes() {
  (void)explanation();  // a handler may not make it
  const stack_t stack{own_stack.data(), 0, own_stack.size()};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = crashed;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (struct sigaction now{}; sigaction(kSignals[i], nullptr, &now) == 0 && now.sa_handler != crashed) {
      earlier[i] = now;
      sigaction(kSignals[i], &action, nullptr);
    }
}

void explain_crashes(const std::string& line, int exit_code) {
  Explanation& now = explanation();
  now.holds = false;
  now.line = line + "\n", now.exit_code = exit_code;
  now.holds = !line.empty();
}

void end_if_out_of_memory() {
  void* const space = mmap(nullptr, kLeastSpace, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space != MAP_FAILED) {
    munmap(space, kLeastSpace);
    return;
  }
  leave("Out of memory.\n", kMemoryExitCode);
}

}  // namespace coaster::base
