#include "base/check.h"

#include <array>
#include <cstdio>

#include "base/crash_guard.h"

namespace coaster::base {

void check_failed(const char* condition, const char* why, const char* file, int line) {
  end_if_out_of_memory();
  static std::array<char, 512> reason;
  std::snprintf(reason.data(), reason.size(), "%s:%d: check failed: %s (%s)", file, line, condition, why);
  crash_because(reason.data());
}

}  // namespace coaster::base
