// The command line, by CLI11; its exceptions end here.
#include "app/options.h"

#include <CLI/CLI.hpp>

#include "base/words.h"
#include "script/help.h"

namespace coaster::app {
namespace {

constexpr const char* kVersion = "coaster 0.1.0";
constexpr const char* kExitCodes =
    "Exit codes: 0 ok, 1 an expectation failed, 2 usage or script error, 3 bad file, 4 no graphics,\n"
    "5 input or output, 6 timeout.";

}  // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
  ParsedOptions out;
  Options& o = out.options;
  bool help_script = false;
  std::string size;
  CLI::App cli("Builds and rides roller coasters made of cubic Bezier curves.", "coaster");
  cli.footer(kExitCodes);
  cli.set_version_flag("--version", kVersion);
  cli.add_option("FILE", o.file, "Track to open (.json, or another format that its ending tells: docs/track-format.md)");
  cli.add_flag("--headless", o.headless, "Draw into memory; without a script: ride FILE, write OUT/ride.png, print a summary");
  cli.add_option("--script", o.script, "Run a script (.coaster)");
  cli.add_option("--record", o.record, "Record what happens as a script");
  cli.add_option("--frames", o.frames, "End after N frames")->check(CLI::NonNegativeNumber);
  cli.add_option("--size", size, "Size of the picture, WIDTHxHEIGHT");
  cli.add_option("--seed", o.seed, "Seed for scripts that name none");
  cli.add_option("--out", o.out, "Folder that scripts and pictures are written to");
  cli.add_flag("--update-goldens", o.update_goldens, "Make the pictures that snap finds the golden ones");
  cli.add_flag("--validate", o.validate, "Check FILE (a track, a challenge or a script) or the script without running it");
  cli.add_flag("--json", o.json, "Print the ride's summary as JSON");
  cli.add_flag("--report", o.report, "Print the report of the whole ride of FILE: times, forces, ratings; no graphics needed");
  cli.add_option("--envelope", o.envelope, "Limits of force by duration (.json); not a compliance check");
  cli.add_flag("--hash-log", o.hash_log, "Print the hashes of document and motion after each tick");
  cli.add_option("--config", o.config, "Keep settings and autosaves in this folder instead of the user's; scripts keep none without it (docs/files.md)");
  cli.add_flag("--reset-layout", o.reset_layout, "Start with the window, scale and panels of the first start");
  cli.add_flag("--help-script", help_script, "Explain the script language and end");
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream text, errors;
    out.exit_code = cli.exit(error, text, errors) == 0 ? 0 : 2;
    out.text = *out.exit_code == 0 ? text.str() : "coaster: " + errors.str();
    return out;
  }
  if (help_script) {
    out.exit_code = 0;
    out.text = script::help();
  } else if (!size.empty() && !base::parse_size(size, o.width, o.height)) {
    out.exit_code = 2;
    out.text = "coaster: --size: expected WIDTHxHEIGHT such as 1280x720, found " + size + "\n";
  } else if (o.validate && o.file.empty() && o.script.empty()) {
    out.exit_code = 2;
    out.text = "coaster: --validate needs a FILE or a --script\n";
  }
  return out;
}

}  // namespace coaster::app
