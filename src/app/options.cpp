// The table of options, the command line parsed by CLI11, whose exceptions are caught here, the manual page and the
// bash completion.
#include "app/options.h"

#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/version.h"
#include "base/exit_codes.h"
#include "base/text.h"
#include "exchange/formats.h"
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
    {"FILE", "", ArgumentKind::track,
     "Track to open; the file extension selects the format (docs/track-format.md). Or a shared link", &Options::file,
     kAnywhere},
    {"--headless", "", ArgumentKind::nothing,
     "Run FILE or a script without a display; without a script: ride FILE, write OUT/ride.png, print a summary",
     &Options::headless, "vpfsmr"},
    {"--script", "F", ArgumentKind::script, "Run a script (.coaster)", &Options::script, "vfs"},
    {"--record", "F", ArgumentKind::script, "Record the session as a script", &Options::record, "fsmrw"},
    {"--frames", "N", ArgumentKind::other, "End after N frames, or N pictures of a movie", &Options::frames, "mrw"},
    {"--size", "WxH", ArgumentKind::other, "Size of window or pictures, WIDTHxHEIGHT", &Options::size, "fsmrw"},
    {"--seed", "N", ArgumentKind::other, "Seed for scripts that do not set one", &Options::seed, "fs"},
    {"--out", "DIR", ArgumentKind::folder, "Output folder of scripts and pictures", &Options::out, "fsr"},
    {"--camera", "NAME", ArgumentKind::camera, "Camera: orbit, ride, chase or fly; default chase for a movie of a ride",
     &Options::camera, "mrw"},
    {"--movie", "DIR", ArgumentKind::folder,
     "Record the script, or one lap of FILE, as numbered pictures in this folder, and movie.mp4 if ffmpeg is "
     "installed; needs --headless",
     &Options::movie, "fm"},
    {"--fps", "N", ArgumentKind::rate,
     "Pictures per second of the movie: 10, 12, 15, 20, 24, 30, 40, 60 or 120; default 30", &Options::fps, "fm"},
    {"--gif", "", ArgumentKind::nothing, "Also write movie.gif, at most 640 pixels wide", &Options::gif, "fm"},
    {"--update-goldens", "", ArgumentKind::nothing, "Save the pictures of snap that fail or are new as golden pictures",
     &Options::update_goldens, "fs"},
    {"--validate", "", ArgumentKind::nothing,
     "Check FILE (a track, a challenge or a script) or the script without running it", &Options::validate, "v"},
    {"--json", "", ArgumentKind::nothing, "Print the summary of a ride, the report, or the errors of a script as JSON",
     &Options::json, "vpfsmr"},
    {"--report", "", ArgumentKind::nothing,
     "Print the report of the whole ride of FILE: times, forces, ratings; no graphics needed", &Options::report, "p"},
    {"--envelope", "F", ArgumentKind::json, "Force limits by duration (.json); not a compliance check",
     &Options::envelope, "pfsmrw"},
    {"--address", "URL", ArgumentKind::other,
     "Address of the page that opens the links you share; default coaster:", &Options::address, "fsw"},
    {"--hash-log", "", ArgumentKind::nothing, "Print the hashes of document and motion after each tick",
     &Options::hash_log, "fsmrw"},
    {"--config", "DIR", ArgumentKind::folder,
     "Folder for settings and autosaves instead of the user's; without it scripts keep none (docs/files.md)",
     &Options::config, "fsw"},
    {"--reset-layout", "", ArgumentKind::nothing, "Reset window, scale and panels to the defaults",
     &Options::reset_layout, "fsw"},
    {"--help-script", "", ArgumentKind::nothing, "Print the script language and exit", &Options::help_script,
     kAnywhere},
    {"--help-man", "", ArgumentKind::nothing, "Print the manual page (roff) and exit", &Options::help_man, kAnywhere},
    {"--help-completion", "", ArgumentKind::nothing, "Print the bash completion and exit", &Options::help_completion,
     kAnywhere},
};

std::string bash_completion() {
  const std::vector<std::string> cameras = base::names_of<world::CameraMode>();
  std::vector<std::string> names{"--help", "--version"}, endings;
  for (const OptionRow& row : option_rows())
    if (row.name.starts_with('-')) names.emplace_back(row.name);
  for (const exchange::TrackFormat& format : exchange::formats())
    if (format.parse) endings.emplace_back(format.ending.substr(1));
  const std::string tracks = fmt::format("{}", fmt::join(endings, "|"));
  const auto files = [](std::string_view pattern) { return fmt::format("_filedir '@({})'", pattern); };
  const auto one_of = [](const auto& words) {
    return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", fmt::join(words, " "));
  };
  std::string out =
      "# Completion of coaster for bash, generated by coaster --help-completion.\n"
      "_coaster() {\n"
      "  local cur prev words cword\n"
      "  _init_completion || return\n"
      "  case $prev in\n";
  for (const OptionRow& row : option_rows()) {
    if (row.value.empty() || !row.name.starts_with('-')) continue;
    std::string what = "return";
    switch (row.word) {
      case ArgumentKind::track: what = files(tracks); break;
      case ArgumentKind::script: what = files("coaster"); break;
      case ArgumentKind::json: what = files("json"); break;
      case ArgumentKind::folder: what = "_filedir -d"; break;
      case ArgumentKind::camera: what = one_of(cameras); break;
      case ArgumentKind::rate: what = one_of(script::kMovieRates); break;
      case ArgumentKind::nothing:
      case ArgumentKind::other: break;
    }
    out += fmt::format("    {}) {}{} ;;\n", row.name, what, what == "return" ? "" : "; return");
  }
  return out + fmt::format(
                   "  esac\n"
                   "  if [[ $cur == -* ]]; then\n"
                   "    {}\n"
                   "    return\n"
                   "  fi\n"
                   "  {}\n"
                   "}}\n"
                   "complete -F _coaster coaster\n",
                   one_of(names), files(tracks + "|coaster"));
}

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

// Escapes text for roff: "-" as a plain minus, no line that starts with a control character.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else out += c;
  }
  if (out.starts_with('.') || out.starts_with('\'')) out.insert(0, "\\&");
  return out;
}

void options_section(std::string& out) {
  out += ".SH OPTIONS\n";
  const auto row = [&](std::string_view name, std::string_view value, std::string_view help) {
    out += fmt::format(".TP\n\\f{}{}\\fR", name.starts_with('-') ? 'B' : 'I', roff(name));
    if (!value.empty()) out += fmt::format(" \\fI{}\\fR", roff(value));
    out += fmt::format("\n{}.\n", roff(help));
  };
  for (const OptionRow& option : option_rows()) row(option.name, option.value, option.help);
  row("--version", "", "Print the version and exit");
  row("--help", "", "Print a summary of the options and exit");
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

std::string manual_page() {
  std::string out = ".\\\" Generated by coaster --help-man.\n";
  out += fmt::format(".TH COASTER 6 \"{}\" \"coaster {}\" Games\n", kVersionDate, kVersion);
  out += ".SH NAME\ncoaster \\- roller\\-coaster builder and laboratory of cubic Bezier curves\n";
  out += ".SH SYNOPSIS\n.B coaster\n[\\fIOPTIONS\\fR] [\\fIFILE\\fR]\n";
  out += fmt::format(".SH DESCRIPTION\n{}\n", roff(kSummary));
  out +=
      "In a window you build tracks with the mouse and ride them. Without a display\n.B coaster \\-\\-headless\n"
      "rides them in memory, and scripts can do everything that a user can. The manual is in /usr/share/doc/coaster.\n";
  options_section(out);
  out += ".SH EXIT STATUS\n";
  for (const base::ExitCode& row : base::kExitCodes)
    out += fmt::format(".TP\n{}\n{}.\n", roff(row.code), roff(row.meaning));
  out +=
      ".SH ENVIRONMENT\n"
      ".TP\n\\fBCOASTER_DATA\\fR\nFolder of the sample tracks, envelopes and challenges, instead of the installed "
      "one.\n"
      ".TP\n\\fBCOASTER_HEADLESS\\fR\nLibrary that draws without a display: osmesa, egl or gles (EGL with OpenGL ES "
      "3.0); default OSMesa, "
      "or EGL where it is missing.\n"
      ".TP\n\\fBXDG_CONFIG_HOME\\fR, \\fBXDG_STATE_HOME\\fR\nFolders of settings and autosaves, in a folder "
      "coaster.\n"
      ".TP\n\\fBXDG_PICTURES_DIR\\fR, \\fBXDG_VIDEOS_DIR\\fR\nFolders for pictures and movies.\n";
  out +=
      ".SH EXAMPLES\n.EX\n"
      "coaster my\\-track.json\n"
      "coaster \\-\\-headless \\-\\-movie ride \\-\\-frames 600 my\\-track.json   # 20 s\n"
      "coaster \\-\\-headless \\-\\-script test.coaster \\-\\-out out\n.EE\n";
  return out;
}

}  // namespace coaster::app
