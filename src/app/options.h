// The command line: one table for the parser, --help, the manual page and the shell completion.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "script/statements.h"

namespace coaster::app {

struct Options {
  std::string file;
  bool headless = false;
  std::string script, record, out, envelope;
  std::optional<std::int64_t> frames;
  std::string size;           // as written
  int width = 0, height = 0;  // 0: the default of the mode
  std::int64_t seed = 0;      // not negative
  std::string camera;         // a name of world::CameraMode; empty: the default of the mode
  std::string movie;          // folder; empty: none
  int fps = script::kUsualMovieRate;
  bool gif = false;
  bool update_goldens = false, validate = false, json = false, hash_log = false, report = false;
  std::string address = "coaster:";  // prefix of shared links
  std::string config;                // folder of settings and autosaves; empty: the user's, only with a window
  bool reset_layout = false;
  bool help_script = false, help_man = false, help_completion = false;
};

// The kind of a word on the command line, for completion.
enum class ArgumentKind : std::uint8_t { nothing, track, script, json, folder, camera, rate, other };

struct OptionRow {
  std::string_view name;   // "--script"; "FILE": the positional argument
  std::string_view value;  // its value as shown in help; "" for a switch
  ArgumentKind word;       // kind of the value; nothing for a switch
  std::string_view help;   // one sentence, without a full stop
  std::variant<bool Options::*, std::string Options::*, int Options::*, std::int64_t Options::*,
               std::optional<std::int64_t> Options::*>
      member;
  std::string_view modes;  // in which it has an effect, by the letters of mode_rows()
};
// What the program does, by the first of these that the options ask for: v checks files, p prints a report, f films a
// script, s runs one, m films a ride, r rides, w opens a window. An option without an effect there is an error.
struct ModeRow {
  char letter;
  std::string_view words;  // "--headless FILE"
};
std::span<const ModeRow> mode_rows();
char mode_of(const Options& options);

// Returns the options in the order of help, without --help and --version.
std::span<const OptionRow> option_rows();
inline constexpr std::string_view kSummary = "Builds and rides roller coasters made of cubic Bezier curves.";
// Returns "coaster 0.1.0" and the libraries that the program was built with.
std::string version_text();

struct ParsedOptions {
  Options options;
  std::optional<int> exit_code;  // set if the program should exit at once
  std::string text;              // text to print then: to stdout for exit code 0, else to stderr
};

// Return the manual page, roff with the macros of man(7), section 6 (games), and a file for bash-completion: options,
// file names by extension, names of cameras and rates (options.cpp).
std::string manual_page();

// Parses the command line. Unknown arguments are errors: exit code 2.
ParsedOptions parse_options(int argc, const char* const* argv);

}  // namespace coaster::app
