// A copy of unsaved changes that is ready for a crash (base/crash_guard.h): printed in a thread, at most half a second
// and one print older than the document.
#pragma once

#include <cstdint>
#include <future>
#include <optional>

namespace coaster::app {

struct Program;

struct CrashCopy {
  std::future<void> printing;
  std::optional<std::uint64_t> edits;  // Session::edits of the newest copy, or of the newest try; nothing: no copy
  double since = 0;                    // of it, s by the surface's clock
};

// Once per frame with unsaved changes. A frame without a change costs a comparison. Scripts print at once.
void follow_crash_copy(Program& program);

// Drops the copy: there is nothing unsaved any more.
void forget_crash_copy(CrashCopy& copy);

}  // namespace coaster::app
