#include "base/planned_crash.h"

#include <array>
#include <cstdlib>
#include <stdexcept>

#include "base/check.h"

namespace coaster::base {
namespace {

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

void crash(CrashWay way) {
  volatile int top = 0;
  switch (way) {
    case CrashWay::check: COASTER_CHECK(top != 0, "a planned crash"); break;
    case CrashWay::exception: throw std::runtime_error("a planned crash");
    case CrashWay::stack: descend(&top); break;
    case CrashWay::memory: take_memory(); [[fallthrough]];
    case CrashWay::access: write_to_nowhere();
  }
}

}  // namespace

void crash_if_planned(const std::optional<PlannedCrash>& plan, CrashPlace place) {
  if (plan && plan->place == place) crash(plan->way);
}

}  // namespace coaster::base
