// How a program ends that cannot go on, on every system: by a failed check, without memory, or by a planned crash.
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/console.h"
#include "base/crash_guard.h"

namespace coaster::base {
namespace {

// A new-handler gets no argument, so its state is global.
struct MemoryEndState {
  void* reserve = nullptr;
  std::thread::id owner;
  std::function<std::string()> save;
  std::atomic<std::thread::id> ending;  // the thread that ends the program
};
MemoryEndState& guard() {
  static MemoryEndState one;
  return one;
}

void end_of_memory() {
  MemoryEndState& g = guard();
  std::thread::id nobody;
  const std::thread::id here = std::this_thread::get_id();
  if (!g.ending.compare_exchange_strong(nobody, here)) {
    if (nobody == here) end_at_once("Out of memory.", kMemoryExitCode);  // again, while it saves
    for (;;) ::pause();                                                  // another thread is ending the program
  }
  std::free(std::exchange(g.reserve, nullptr));
  if (here != g.owner) end_at_once("Out of memory.", kMemoryExitCode);
  const std::string said = g.save ? g.save() : std::string();
  (void)finish_printing();
  print_error(said.empty() ? "Out of memory." : "Out of memory. " + said);
  std::_Exit(kMemoryExitCode);
}

// Is not turned into a loop: each call reads the one before. Ends only when the numbers do.
int descend(volatile int* above) {
  volatile int here = *above + 1;
  if (here < 0) return 0;
  return descend(&here) + *above;
}

void write_to_nowhere() {
  volatile std::uintptr_t nowhere = 64;
  *reinterpret_cast<volatile int*>(nowhere) = 1;
}

void take_memory() {
  constexpr std::size_t kPart = 1u << 20, kMost = 1u << 16;
  std::array<void* volatile, 1> part{};
  for (std::size_t i = 0; i < kMost; ++i)
    if (part[0] = std::malloc(kPart); part[0] == nullptr) return;
}

void crash(CrashCause way) {
  volatile int top = 0;
  switch (way) {
    case CrashCause::check: COASTER_CHECK(top != 0, "a planned crash"); break;
    case CrashCause::exception: throw std::runtime_error("a planned crash");
    case CrashCause::stack: descend(&top); break;
    case CrashCause::memory: take_memory(); [[fallthrough]];
    case CrashCause::access: write_to_nowhere();
  }
}

}  // namespace

void check_failed(const char* condition, const char* why, const char* file, int line) {
  end_if_out_of_memory();
  static std::array<char, 512> reason;
  std::snprintf(reason.data(), reason.size(), "%s:%d: check failed: %s (%s)", file, line, condition, why);
  crash_because(reason.data());
}

void guard_memory() {
  MemoryEndState& g = guard();
  if (g.reserve == nullptr) g.reserve = std::malloc(kMemoryReserve);
  g.owner = std::this_thread::get_id();
  std::set_new_handler(end_of_memory);
  guard_crashes();
}

void on_memory_end(std::function<std::string()> save) { guard().save = std::move(save); }

void crash_if_planned(const std::optional<PlannedCrash>& plan, CrashPlace place) {
  if (plan && plan->place == place) crash(plan->way);
}

}  // namespace coaster::base
