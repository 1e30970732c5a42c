// The entry point: parses the command line, runs, returns the exit code. Everything else is in the other files of this
// room.
#include <csignal>
#include <string>

#include "app/modes.h"
#include "base/console.h"
#include "base/crash_guard.h"

namespace {

int run(int argc, char** argv) {
  const coaster::app::ParsedOptions parsed = coaster::app::parse_options(argc, argv);
  if (!parsed.exit_code) return coaster::app::run_program(parsed.options);
  if (*parsed.exit_code == 0) coaster::base::print(parsed.text);
  else coaster::base::print_error(parsed.text);
  return *parsed.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  coaster::base::hold_streams();
  if (const std::string problem = coaster::base::stack_problem(); !problem.empty()) {
    coaster::base::print_error(problem);
    return coaster::base::kMemoryExitCode;
  }
  coaster::base::guard_memory();
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a file over the size limit is then an error like a full disk
  const int code = run(argc, argv);
  const coaster::base::Status printed = coaster::base::finish_printing();
  if (printed) return code;
  coaster::base::print_error(printed.message);
  return code == 0 ? coaster::base::exit_code(printed.code) : code;
}
