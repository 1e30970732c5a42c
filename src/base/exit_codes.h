// The program's exit codes in words, for --help, --help-script, the manual page and the table of docs/script.md.
#pragma once

#include <string>
#include <string_view>

namespace coaster::base {

struct ExitCode {
  std::string_view code, meaning;
};
// Those of base::Code, kMemoryExitCode (base/crash_guard.h), and of signals, in ascending order.
inline constexpr ExitCode kExitCodes[] = {{"0", "success"},
                                          {"1", "failed expectation"},
                                          {"2", "usage or script error"},
                                          {"3", "bad file"},
                                          {"4", "no graphics"},
                                          {"5", "input or output"},
                                          {"6", "timeout"},
                                          {"70", "out of memory"},
                                          {"77", "skipped"},
                                          {"128+N", "ended by signal N"}};

// Returns "Exit codes: 0 success, 1 failed expectation, ...", with a full stop at the end.
inline std::string exit_codes_sentence() {
  std::string text = "Exit codes:";
  for (const ExitCode& row : kExitCodes)
    text.append(&row == kExitCodes ? " " : ", ").append(row.code).append(" ").append(row.meaning);
  return text + ".";
}

}  // namespace coaster::base
