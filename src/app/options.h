// The command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace coaster::app {

struct Options {
  std::string file;
  bool headless = false;
  std::string script, record, out, envelope;
  std::optional<std::int64_t> frames;
  int width = 0, height = 0;  // 0: the default of the mode
  std::uint64_t seed = 0;
  bool update_goldens = false, validate = false, json = false, hash_log = false, report = false;
  std::string config;         // folder of settings and autosaves; empty: the user's, for windows alone
  bool reset_layout = false;
};

struct ParsedOptions {
  Options options;
  std::optional<int> exit_code;  // set when the program is to end at once
  std::string text;              // what to print then: to stdout for exit code 0, else to stderr
};

// Unknown arguments are errors: exit code 2.
ParsedOptions parse_options(int argc, const char* const* argv);

}  // namespace coaster::app
