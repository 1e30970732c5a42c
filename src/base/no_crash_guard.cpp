// For systems without signals, which report crashes themselves.
#include "base/crash_guard.h"

namespace coaster::base {

void guard_crashes() {}
void end_if_out_of_memory() {}

}  // namespace coaster::base
