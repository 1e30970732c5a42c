// The entry point: parses the command line, runs, returns the exit code. Everything else is in the other files of this
// room.
#include <cstdio>

#include "app/modes.h"

int main(int argc, char** argv) {
  const coaster::app::ParsedOptions parsed = coaster::app::parse_options(argc, argv);
  if (!parsed.exit_code) return coaster::app::run_program(parsed.options);
  std::fputs(parsed.text.c_str(), *parsed.exit_code == 0 ? stdout : stderr);
  return *parsed.exit_code;
}
