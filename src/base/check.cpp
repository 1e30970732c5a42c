#include "base/check.h"

#include <cstdio>
#include <cstdlib>

#include "base/crash_guard.h"

namespace coaster::base {

void check_failed(const char* condition, const char* why, const char* file, int line) {
  end_if_out_of_memory();
  std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, condition, why);
  std::abort();
}

}  // namespace coaster::base
