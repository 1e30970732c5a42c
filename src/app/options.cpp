// The table of options, and the command line parsed by CLI11, whose exceptions are caught here.
#include "app/options.h"

#include <CLI/CLI.hpp>

#include <type_traits>

#include <fmt/format.h>

#include "app/version.h"
#include "base/exit_codes.h"
#include "base/words.h"
#include "platform/sound.h"
#include "platform/surface.h"
#include "script/grammar.h"
#include "world/settings.h"

namespace coaster::app {
namespace {

constexpr ModeRow kModes[] = {{'v', "--validate"}, {'p', "--report"},           {'f', "--script F --movie"},
                              {'s', "--script F"}, {'m', "--headless --movie"}, {'r', "--headless FILE"},
                              {'w', "a window"}};
constexpr std::string_view kAnywhere = "vpfsmrw";

constexpr OptionRow kRows[] = {
    {"FILE", "", Word::track,
     "Track to open; the file extension selects the format (docs/track-format.md). Or a shared link", &Options::file,
     kAnywhere},
    {"--headless", "", Word::nothing,
     "Run FILE or a script without a display; without a script: ride FILE, write OUT/ride.png, print a summary",
     &Options::headless, "vpfsmr"},
    {"--script", "F", Word::script, "Run a script (.coaster)", &Options::script, "vfs"},
    {"--record", "F", Word::script, "Record the session as a script", &Options::record, "fsmrw"},
    {"--frames", "N", Word::other, "End after N frames, or N pictures of a movie", &Options::frames, "mrw"},
    {"--size", "WxH", Word::other, "Size of window or pictures, WIDTHxHEIGHT", &Options::size, "fsmrw"},
    {"--seed", "N", Word::other, "Seed for scripts that do not set one", &Options::seed, "fs"},
    {"--out", "DIR", Word::folder, "Output folder of scripts and pictures", &Options::out, "fsr"},
    {"--camera", "NAME", Word::camera, "Camera: orbit, ride, chase or fly; default chase for a movie of a ride",
     &Options::camera, "mrw"},
    {"--movie", "DIR", Word::folder,
     "Record the script, or one lap of FILE, as numbered pictures in this folder, and movie.mp4 if ffmpeg is "
     "installed; needs --headless",
     &Options::movie, "fm"},
    {"--fps", "N", Word::rate, "Pictures per second of the movie: 10, 12, 15, 20, 24, 30, 40, 60 or 120; default 30",
     &Options::fps, "fm"},
    {"--gif", "", Word::nothing, "Also write movie.gif, at most 640 pixels wide", &Options::gif, "fm"},
    {"--update-goldens", "", Word::nothing, "Save the pictures of snap that fail or are new as golden pictures",
     &Options::update_goldens, "fs"},
    {"--validate", "", Word::nothing, "Check FILE (a track, a challenge or a script) or the script without running it",
     &Options::validate, "v"},
    {"--json", "", Word::nothing, "Print the summary of a ride, the report, or the errors of a script as JSON",
     &Options::json, "vpfsmr"},
    {"--report", "", Word::nothing,
     "Print the report of the whole ride of FILE: times, forces, ratings; no graphics needed", &Options::report, "p"},
    {"--envelope", "F", Word::json, "Force limits by duration (.json); not a compliance check", &Options::envelope,
     "pfsmrw"},
    {"--address", "URL", Word::other,
     "Address of the page that opens the links you share; default coaster:", &Options::address, "fsw"},
    {"--hash-log", "", Word::nothing, "Print the hashes of document and motion after each tick", &Options::hash_log,
     "fsmrw"},
    {"--config", "DIR", Word::folder,
     "Folder for settings and autosaves instead of the user's; without it scripts keep none (docs/files.md)",
     &Options::config, "fsw"},
    {"--reset-layout", "", Word::nothing, "Reset window, scale and panels to the defaults", &Options::reset_layout,
     "fsw"},
    {"--help-script", "", Word::nothing, "Print the script language and exit", &Options::help_script, kAnywhere},
    {"--help-man", "", Word::nothing, "Print the manual page (roff) and exit", &Options::help_man, kAnywhere},
    {"--help-completion", "", Word::nothing, "Print the bash completion and exit", &Options::help_completion,
     kAnywhere},
};

CLI::Option* add(CLI::App& cli, const OptionRow& row, Options& options) {
  const std::string name(row.name), help(row.help);
  CLI::Option* const option = std::visit(
      [&]<class T>(T Options::*member) {
        if constexpr (std::is_same_v<T, bool>) return cli.add_flag(name, options.*member, help);
        else return cli.add_option(name, options.*member, help);
      },
      row.member);
  if (!row.value.empty()) option->option_text(std::string(row.value));
  return option;
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
  if (o.reset_layout && o.config.empty() && !o.script.empty()) return "--reset-layout of a script needs --config";
  return {};
}

// Returns the error of an option that does nothing in this mode.
std::string without_effect(const OptionRow& row, char mode) {
  std::string now, others;
  for (const ModeRow& one : kModes) {
    if (one.letter == mode) now = one.words;
    if (row.modes.find(one.letter) != std::string_view::npos)
      others += fmt::format("{}{}", others.empty() ? "" : ", ", one.words);
  }
  return fmt::format("{} has no effect with {}; it works with: {}", row.name, now, others);
}

}  // namespace

std::span<const ModeRow> mode_rows() { return kModes; }
char mode_of(const Options& o) {
  if (o.validate || o.report) return o.validate ? 'v' : 'p';
  if (!o.script.empty()) return o.movie.empty() ? 's' : 'f';
  return !o.headless ? 'w' : o.movie.empty() ? 'r' : 'm';
}

std::span<const OptionRow> option_rows() { return kRows; }

std::string version_text() {
  return fmt::format("coaster {}\nwindow: {}; sound: {}\n", kVersion, platform::window_library(),
                     platform::sound_library());
}

ParsedOptions parse_options(int argc, const char* const* argv) {
  ParsedOptions out;
  Options& o = out.options;
  CLI::App cli(std::string(kSummary), "coaster");
  cli.footer(base::exit_codes_sentence() + " Options without an effect together are refused.");
  bool version = false;
  cli.add_flag("--version", version, "Print the version and exit");
  std::vector<std::pair<const OptionRow*, const CLI::Option*>> all;
  for (const OptionRow& row : kRows) all.emplace_back(&row, add(cli, row, o));
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
  if (out.exit_code) return out;
  std::string wrong = trouble(o);
  for (const auto& [row, option] : all)
    if (wrong.empty() && option->count() > 0 && row->modes.find(mode_of(o)) == std::string_view::npos)
      wrong = without_effect(*row, mode_of(o));
  if (!wrong.empty()) out.exit_code = 2, out.text = fmt::format("coaster: {}", wrong);
  return out;
}

}  // namespace coaster::app
