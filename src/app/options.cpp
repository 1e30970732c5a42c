// The table of options, and the command line parsed by CLI11, whose exceptions are caught here.
#include "app/options.h"

#include <CLI/CLI.hpp>

#include <type_traits>

#include <fmt/format.h>

#include "app/version.h"
#include "base/words.h"
#include "platform/sound.h"
#include "platform/surface.h"
#include "script/help.h"
#include "world/settings.h"

namespace coaster::app {
namespace {

constexpr OptionRow kRows[] = {
    {"FILE", "", Word::track,
     "Track to open; the file extension selects the format (docs/track-format.md). Or a shared link", &Options::file},
    {"--headless", "", Word::nothing,
     "Run FILE or a script without a display; without a script: ride FILE, write OUT/ride.png, print a summary",
     &Options::headless},
    {"--script", "F", Word::script, "Run a script (.coaster)", &Options::script},
    {"--record", "F", Word::script, "Record the session as a script", &Options::record},
    {"--frames", "N", Word::other, "End after N frames, or N pictures of a movie", &Options::frames},
    {"--size", "WxH", Word::other, "Size of window or pictures, WIDTHxHEIGHT", &Options::size},
    {"--seed", "N", Word::other, "Seed for scripts that do not set one", &Options::seed},
    {"--out", "DIR", Word::folder, "Output folder of scripts and pictures", &Options::out},
    {"--camera", "NAME", Word::camera, "Camera: orbit, ride, chase or fly; default chase for a movie of a ride",
     &Options::camera},
    {"--movie", "DIR", Word::folder,
     "Record the script, or one lap of FILE, as numbered pictures in this folder, and movie.mp4 if ffmpeg is "
     "installed; needs --headless",
     &Options::movie},
    {"--fps", "N", Word::rate, "Pictures per second of the movie: 10, 12, 15, 20, 24, 30, 40, 60 or 120; default 30",
     &Options::fps},
    {"--gif", "", Word::nothing, "Also write movie.gif, at most 640 pixels wide", &Options::gif},
    {"--update-goldens", "", Word::nothing, "Save the pictures of snap as new golden pictures",
     &Options::update_goldens},
    {"--validate", "", Word::nothing, "Check FILE (a track, a challenge or a script) or the script without running it",
     &Options::validate},
    {"--json", "", Word::nothing, "Print the summary of the ride as JSON", &Options::json},
    {"--report", "", Word::nothing,
     "Print the report of the whole ride of FILE: times, forces, ratings; no graphics needed", &Options::report},
    {"--envelope", "F", Word::json, "Force limits by duration (.json); not a compliance check", &Options::envelope},
    {"--address", "URL", Word::other,
     "Address of the page that opens the links you share; default coaster:", &Options::address},
    {"--hash-log", "", Word::nothing, "Print the hashes of document and motion after each tick", &Options::hash_log},
    {"--config", "DIR", Word::folder,
     "Folder for settings and autosaves instead of the user's; without it scripts keep none (docs/files.md)",
     &Options::config},
    {"--reset-layout", "", Word::nothing, "Reset window, scale and panels to the defaults", &Options::reset_layout},
    {"--help-script", "", Word::nothing, "Print the script language and exit", &Options::help_script},
    {"--help-man", "", Word::nothing, "Print the manual page (roff) and exit", &Options::help_man},
    {"--help-completion", "", Word::nothing, "Print the bash completion and exit", &Options::help_completion},
};

constexpr ExitCodeRow kExitCodes[] = {{"0", "success"},
                                      {"1", "failed expectation"},
                                      {"2", "usage or script error"},
                                      {"3", "bad file"},
                                      {"4", "no graphics"},
                                      {"5", "input or output"},
                                      {"6", "timeout"},
                                      {"70", "out of memory"},
                                      {"77", "skipped"},
                                      {"128+N", "ended by signal N"}};

std::string exit_code_line() {
  std::string line = "Exit codes:";
  for (const ExitCodeRow& row : kExitCodes)
    line += fmt::format("{} {} {}", row.code == "0" ? "" : ",", row.code, row.meaning);
  return line + ".";
}

void add(CLI::App& cli, const OptionRow& row, Options& options) {
  const std::string name(row.name), help(row.help);
  CLI::Option* const option = std::visit(
      [&]<class T>(T Options::*member) {
        if constexpr (std::is_same_v<T, bool>) return cli.add_flag(name, options.*member, help);
        else return cli.add_option(name, options.*member, help);
      },
      row.member);
  if (!row.value.empty()) option->option_text(std::string(row.value));
}

constexpr std::int64_t kMostFrames = 10'000'000;

// Returns the first conflict between options, "" if there is none.
std::string trouble(Options& o) {
  if (!o.size.empty() && !base::parse_size(o.size, o.width, o.height))
    return fmt::format("--size: expected {}, found {}", base::kSizeWords, o.size);
  if (o.validate && o.file.empty() && o.script.empty()) return "--validate needs a FILE or a --script";
  if (o.frames && (*o.frames < 0 || *o.frames > kMostFrames))
    return fmt::format("--frames: expected 0 to {}, found {}", kMostFrames, *o.frames);
  if (o.seed < 0) return fmt::format("--seed: expected a whole number from 0, found {}", o.seed);
  if (!script::is_movie_rate(o.fps)) return fmt::format("--fps: expected {}, found {}", script::kMovieRateWords, o.fps);
  if (!o.camera.empty() && !base::value_named<world::CameraMode>(o.camera))
    return fmt::format("--camera: expected {}, found {}", base::alternatives_of<world::CameraMode>(), o.camera);
  if (o.headless && o.file.empty() && o.script.empty() && !o.validate && !o.report)
    return "--headless needs a FILE or a --script, such as: coaster --headless FILE";
  if (!o.movie.empty() && !o.headless) return "--movie needs --headless; in a window use File/Record movie";
  return {};
}

}  // namespace

std::span<const OptionRow> option_rows() { return kRows; }
std::span<const ExitCodeRow> exit_code_rows() { return kExitCodes; }

std::string version_text() {
  return fmt::format("coaster {}\nwindow: {}; sound: {}\n", kVersion, platform::window_library(),
                     platform::sound_library());
}

ParsedOptions parse_options(int argc, const char* const* argv) {
  ParsedOptions out;
  Options& o = out.options;
  CLI::App cli(std::string(kSummary), "coaster");
  cli.footer(exit_code_line());
  bool version = false;
  cli.add_flag("--version", version, "Print the version and exit");
  for (const OptionRow& row : kRows) add(cli, row, o);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream text, errors;
    out.exit_code = cli.exit(error, text, errors) == 0 ? 0 : 2;
    out.text = *out.exit_code == 0 ? text.str() : "coaster: " + errors.str();
    if (*out.exit_code != 0 && out.text.ends_with('\n')) out.text.pop_back();
    return out;
  }
  const auto print = [&](std::string text) { out.exit_code = 0, out.text = std::move(text); };
  if (version) print(version_text());
  else if (o.help_script) print(script::help());
  else if (o.help_man) print(manual_page());
  else if (o.help_completion) print(bash_completion());
  else if (const std::string wrong = trouble(o); !wrong.empty())
    out.exit_code = 2, out.text = fmt::format("coaster: {}", wrong);
  return out;
}

}  // namespace coaster::app
