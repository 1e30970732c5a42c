// In place of check_failed() of program_end.cpp where the curve room is a library (cmake/curve_library.cmake): its
// programs handle crashes themselves.
#include <cstdio>
#include <cstdlib>

#include "base/check.h"

namespace coaster::base {

void check_failed(const char* condition, const char* why, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, condition, why);
  std::abort();
}

}  // namespace coaster::base
