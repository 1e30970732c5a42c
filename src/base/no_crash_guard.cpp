// For systems without signals, which report crashes themselves.
#include <cstdlib>

#include "base/console.h"
#include "base/crash_guard.h"

namespace coaster::base {

std::string stack_problem() { return {}; }
void guard_crashes() {}
HandlerStack::HandlerStack() = default;
HandlerStack::~HandlerStack() = default;
void keep_for_crash(std::vector<CrashFile>) {}
void explain_crashes(const std::string&, int) {}
void end_if_out_of_memory() {}
void crash_because(const char* reason) {
  print_error(reason);
  std::abort();
}
void end_at_once(std::string_view line, int exit_code) {
  print_error(line);
  std::_Exit(exit_code);
}

}  // namespace coaster::base
