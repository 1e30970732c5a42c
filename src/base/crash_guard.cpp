#include "base/crash_guard.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <utility>

namespace coaster::base {
namespace {

struct CrashSignal {
  int number;
  std::string_view name;
};
constexpr std::array<CrashSignal, 5> kSignals{{{SIGSEGV, "SIGSEGV, an invalid memory access"},
                                               {SIGBUS, "SIGBUS, an invalid memory access"},
                                               {SIGABRT, "SIGABRT"},
                                               {SIGFPE, "SIGFPE, an arithmetic error"},
                                               {SIGILL, "SIGILL, an invalid instruction"}}};
constexpr std::size_t kHandlerStack = 1u << 16;  // bytes

// What handlers read. A handler gets no argument, so its state is global; it is never destroyed.
struct CrashState {
  std::array<struct sigaction, kSignals.size()> earlier{};
  std::atomic<std::vector<CrashFile>*> kept = nullptr;
  std::atomic<pid_t> crashed = 0;  // the thread that handles a crash
  std::atomic<const char*> reason = nullptr;
  bool installed = false;
  // The line and the exit code of explain_crashes(). Other threads read it only while `explains` is true.
  std::atomic<bool> explains = false;
  std::string line;
  int exit_code = 0;
};
CrashState& crash_state() {
  static CrashState* const one = new CrashState;
  return *one;
}

void say(std::string_view text) { (void)!::write(STDERR_FILENO, text.data(), text.size()); }

// Waits for ever if another thread handles a crash: that one ends the program. True the first time.
bool begin_crash(CrashState& g) {
  pid_t nobody = 0;
  if (g.crashed.compare_exchange_strong(nobody, ::gettid())) return true;
  while (nobody != ::gettid()) ::pause();
  return false;
}

// Writes the kept files, then prints one line: the reason, and whether the changes were written.
void tell_crash(CrashState& g, std::string_view start, std::string_view what, std::string_view end) {
  std::string_view fate;
  if (std::vector<CrashFile>* const kept = begin_crash(g) ? g.kept.load() : nullptr; kept != nullptr) {
    fate = " Unsaved changes were kept, and the next start offers them.";
    for (CrashFile& file : *kept)
      if (!file.file.write(file.text) || !file.file.put_in_place()) {
        fate = " Unsaved changes could not be written.";
        break;
      }
  }
  say(start), say(what), say(end), say(fate), say("\n");
}

// Uses only functions that are allowed in a signal handler.
extern "C" void crashed(int signal, siginfo_t* info, void*) {
  CrashState& g = crash_state();
  end_if_out_of_memory();
  if (g.explains) end_at_once(g.line, g.exit_code);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    if (kSignals[i].number != signal) continue;
    const char* const reason = g.reason;
    if (reason != nullptr) tell_crash(g, reason, "", ".");
    else tell_crash(g, "coaster crashed (", kSignals[i].name, ").");
    sigaction(signal, &g.earlier[i], nullptr);  // and the instruction crashes again
    if (info->si_code <= 0) ::raise(signal);    // but not one that a process sent
  }
}

[[noreturn]] void unhandled_exception() {
  static std::array<char, 512> text;
  try {
    std::rethrow_exception(std::current_exception());
  } catch (const std::exception& e) {
    *fmt::format_to_n(text.data(), text.size() - 1, "coaster crashed (exception: {})", e.what()).out = 0;
  } catch (...) {
    *fmt::format_to_n(text.data(), text.size() - 1, "coaster crashed (unknown exception)").out = 0;
  }
  crash_because(text.data());
}

}  // namespace

std::string stack_problem() {
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kLeastStack) return {};
  return fmt::format("The stack is limited to {} kB. coaster needs {} kB (ulimit -s {}).", limit.rlim_cur >> 10,
                     kLeastStack >> 10, kLeastStack >> 10);
}

HandlerStack::HandlerStack() : stack_(new char[kHandlerStack]) {
  const stack_t stack{stack_.get(), 0, kHandlerStack};
  sigaltstack(&stack, &before_);
}
HandlerStack::~HandlerStack() { sigaltstack(&before_, nullptr); }

void guard_crashes() {
  static const HandlerStack& own = *new HandlerStack;  // a handler may run until the very end
  (void)own;
  struct sigaction action {};
  action.sa_sigaction = crashed;
  action.sa_flags = SA_ONSTACK | SA_SIGINFO;
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (struct sigaction now{}; sigaction(kSignals[i].number, nullptr, &now) == 0 && now.sa_sigaction != crashed) {
      crash_state().earlier[i] = now;
      sigaction(kSignals[i].number, &action, nullptr);
    }
  std::set_terminate(unhandled_exception);
  crash_state().installed = true;
}

// A handler marks the crash before it reads `kept`. The previous files are deleted only when no handler can use them.
void keep_for_crash(std::vector<CrashFile> files) {
  CrashState& g = crash_state();
  auto* const next = files.empty() ? nullptr : new std::vector<CrashFile>(std::move(files));
  const std::unique_ptr<std::vector<CrashFile>> before(g.kept.exchange(next));
  while (g.crashed != 0) ::pause();
}

void crash_because(const char* reason) {
  crash_state().reason = reason;
  if (!crash_state().installed) say(reason), say("\n");
  std::abort();
}

void explain_crashes(const std::string& line, int exit_code) {
  CrashState& g = crash_state();
  g.explains = false;
  g.line = line, g.exit_code = exit_code;
  g.explains = !line.empty();
}

void end_at_once(std::string_view line, int exit_code) {
  tell_crash(crash_state(), line, "", "");
  std::_Exit(exit_code);
}

void end_if_out_of_memory() {
  void* const space = mmap(nullptr, kLeastSpace, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (space == MAP_FAILED) end_at_once("Out of memory.", kMemoryExitCode);
  munmap(space, kLeastSpace);
}

}  // namespace coaster::base
