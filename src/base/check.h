// Checks for programmer errors. Not for bad input: that is a Status (status.h).
#pragma once

namespace coaster::base {

// Prints the condition, its location and the reason to stderr and aborts. Never returns.
[[noreturn]] void check_failed(const char* condition, const char* why, const char* file, int line);

}  // namespace coaster::base

// Aborts if `cond` is false; on in every build. `why` names the broken invariant.
#define COASTER_CHECK(cond, why) ((cond) ? void(0) : ::coaster::base::check_failed(#cond, (why), __FILE__, __LINE__))
