#include "base/crash_guard.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "base/memory_guard.h"

namespace coaster::base {
namespace {

constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGABRT};
std::array<struct sigaction, kSignals.size()> earlier{};
std::array<char, 1u << 16> own_stack;  // the crash may be the overflow of a stack

// Uses only functions that are allowed in a signal handler.
extern "C" void crashed(int signal) {
  end_if_out_of_memory();
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (kSignals[i] == signal) sigaction(signal, &earlier[i], nullptr);  // and the instruction crashes again
}

}  // namespace

void guard_crashes() {
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

void end_if_out_of_memory() {
  void* const space = mmap(nullptr, kLeastSpace, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space != MAP_FAILED) {
    munmap(space, kLeastSpace);
    return;
  }
  constexpr std::string_view kLine = "Out of memory.\n";
  (void)!::write(STDERR_FILENO, kLine.data(), kLine.size());
  std::_Exit(kMemoryExitCode);
}

}  // namespace coaster::base
