// For a web page, a system without signals, which reports crashes itself, and without threads: work runs in one.
#include <algorithm>
#include <cstdlib>

#include "base/console.h"
#include "base/crash_guard.h"
#include "base/parallel.h"

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

unsigned cores() { return 1; }
bool has_threads() { return false; }

void in_parts(std::size_t count, std::size_t grain, unsigned,
              const std::function<void(std::size_t begin, std::size_t end)>& work) {
  for (std::size_t begin = 0; begin < count; begin += grain) work(begin, std::min(begin + grain, count));
}

}  // namespace coaster::base
