// For systems without signals, which report crashes themselves.
#include "base/crash_guard.h"

#include <string>

namespace coaster::base {

std::string stack_problem() { return {}; }
void guard_crashes() {}
void explain_crashes(const std::string&, int) {}
void end_if_out_of_memory() {}

}  // namespace coaster::base
