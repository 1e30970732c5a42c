// The program's modes and the order in which each starts up.
#include "app/modes.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "app/frame.h"
#include "app/pictures.h"
#include "app/program.h"
#include "app/ride_summary.h"
#include "app/script_host.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/perform/apply.h"
#include "exchange/challenge_file.h"
#include "exchange/formats.h"
#include "platform/signals.h"
#include "query/challenge.h"
#include "script/grammar.h"
#include "script/runner.h"
#include "world/look.h"

namespace coaster::app {
namespace {

int finish(const base::Status& status) {
  std::fflush(stdout);
  if (status) return 0;
  if (isatty(STDERR_FILENO)) std::fputs("\r", stderr);
  std::fprintf(stderr, "%s\n", status.message.c_str());
  return base::exit_code(status.code);
}

base::Result<script::Script> read_script(const std::string& path) {
  base::Files files;
  auto parsed = script::parse_script_file(path, files);
  if (!parsed) return parsed.status();
  if (parsed->errors.empty()) return std::move(parsed->script);
  return base::Status{base::Code::usage, fmt::format("{}", fmt::join(parsed->errors, "\n"))};
}

// Prints the notices of a file that was opened: without a window nobody sees them.
void print_notices(const edit::Session& session) {
  for (const edit::Notice& notice : session.notices.list) std::fprintf(stderr, "%s\n", notice.text.c_str());
}

// Checks that a challenge's start track does not pass it, without a picture.
base::Status validate_challenge(const std::string& path) {
  base::Files files;
  edit::Session session = edit::make_session({});
  session.game.referee = query::referee();
  if (const base::Status begun = edit::apply(session, files, edit::StartChallenge{path}); !begun) return begun;
  print_notices(session);
  edit::Verdict verdict = session.game.referee.judge(session, nullptr);
  if (session.game.challenge->file.judged != exchange::Judged::build &&
      edit::apply(session, files, edit::RideStart{})) {
    const int most = static_cast<int>(exchange::kMaxChallengeSeconds) * world::kTicksPerSecond;
    edit::advance(session, most);
    verdict = session.game.challenge->last;
    if (session.game.challenge->judged == 0) verdict.reason = "its ride does not end";
  }
  if (verdict.medal > 0)
    return {base::Code::bad_file,
            fmt::format("{}: error: its start track passes it already ({}): expected one that does not", path,
                        query::medal_name(verdict.medal))};
  std::printf("%s: the start track does not pass, as it must: %s\n", path.c_str(), verdict.reason.c_str());
  return {};
}

base::Status validate_file(const std::string& path) {
  base::Files files;
  if (std::filesystem::path(path).extension() == ".json")
    if (const auto text = files.read(path); text && exchange::looks_like_challenge(*text))
      return validate_challenge(path);
  const auto track = exchange::load_track(files, path);
  if (!track) return track.status();
  for (const std::string& warning : track->warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  return {};
}

int validate(const Options& options) {
  for (const std::string& path : {options.file, options.script}) {
    if (path.empty()) continue;
    if (path == options.script || std::filesystem::path(path).extension() == ".coaster") {
      if (const auto script = read_script(path); !script) return finish(script.status());
    } else if (const base::Status valid = validate_file(path); !valid) {
      return finish(valid);
    }
  }
  std::puts("ok");
  return 0;
}

base::Status open_envelope(edit::Session& session, base::Files& files, const Options& options) {
  if (options.envelope.empty()) return {};
  return edit::apply(session, files, edit::LoadEnvelope{options.envelope});
}

// Draws a first frame, so that the viewport is known, then opens the track.
base::Status open_track(Program& program, const std::filesystem::path& path) {
  run_frame(program, {platform::Tick{0}}, 0);
  if (path.empty()) return apply(program, edit::NewTrack{});
  const base::Status loaded = apply(program, edit::Load{path.string()});
  if (loaded && !program.surface->is_window()) print_notices(program.session);
  return loaded ? loaded : base::Status{base::Code::bad_file, loaded.message};
}

base::Status start_recording(Program& program) {
  if (program.options.record.empty()) return {};
  auto recorder = script::Recorder::start(program.files, program.options.record, program.session);
  if (!recorder) return {base::Code::io, recorder.status().message};
  program.recorder = std::move(*recorder);
  return {};
}

constexpr int kWindowSamples = 4;  // per pixel

// The track that the options name, else the default one.
std::filesystem::path track_of(const Options& options) {
  return options.file.empty() ? default_track() : std::filesystem::path(options.file);
}

// The size that the options name, else that of windows and of pictures without one.
platform::Size size_of(const Options& options) {
  return options.width > 0 ? platform::Size{options.width, options.height} : platform::Size{1280, 720};
}

void print_summary(const Options& options, const RideSummary& summary) {
  std::fputs((options.json ? to_json(summary) : to_text(summary)).c_str(), stdout);
}

MovieOrder movie_order(const Options& options) { return {options.movie, options.fps, options.gif}; }

base::Status choose_camera(Program& program, const std::string& name) {
  const auto mode = base::value_named<world::CameraMode>(name);
  return mode ? apply(program, edit::Set<&world::Settings::camera_mode>{*mode}) : base::Status{};
}

// Ends after a signal: autosaves unsaved changes, and returns the exit code of the signal, as shells define it.
int leave_by(Program& program, int signal) {
  const base::Status kept = autosave_now(program);
  if (!kept) std::fprintf(stderr, "%s\n", kept.message.c_str());
  stop_keeping(program, false);
  std::fflush(stdout);
  return 128 + signal;
}

int run_script(const Options& options) {
  const auto script = read_script(options.script);
  if (!script) return finish(script.status());
  script::RunOptions run;
  run.out = options.out.empty() ? std::filesystem::path("out") / std::filesystem::path(options.script).stem()
                                : std::filesystem::path(options.out);
  run.update_goldens = options.update_goldens;
  run.environment.seed = options.seed;
  if (options.width > 0) run.environment.width = options.width, run.environment.height = options.height;
  const auto out = base::Root().open(run.out);
  if (!out) return finish(out.status());
  const platform::Size size{run.environment.width, run.environment.height};
  auto program = make_program(options, size, 0);
  if (!program) return finish(program.status());
  Program& p = **program;
  p.stats.hide_times = true;
  p.files = base::Files(*out);
  if (!options.config.empty()) {
    start_keeping(p, {options.config, options.config}, {}, options.reset_layout);  // the user named it
    platform::watch_signals();
    run.environment.scale = p.session.settings.look->ui_scale;  // until the script changes it
  }
  if (!options.file.empty())
    if (const base::Status opened = open_track(p, options.file); !opened) return finish(opened);
  if (const base::Status limits = open_envelope(p.session, p.files, options); !limits) return finish(limits);
  if (const base::Status started = start_recording(p); !started) return finish(started);
  if (!options.movie.empty())
    if (const base::Status filming = start_movie(p, movie_order(options)); !filming) return finish(filming);
  script::Host host = make_script_host(p);
  base::Status ran = script::run_script(*script, host, run);
  if (const base::Status filmed = finish_movie(p); ran && !filmed) ran = filmed;
  if (const int signal = platform::pending_signal()) return leave_by(p, signal);
  stop_keeping(p, p.quit);
  return finish(ran);
}

// With --frames: draws that many frames. Else rides a lap (two minutes at most) without drawing, and takes one picture
// in its middle.
base::Status ride(Program& program, RideSummary& summary) {
  const auto tick = [&] {
    advance(program, 1);
    measure(program.session, summary);
  };
  const auto draw = [&] { run_frame(program, {platform::Tick{2 * world::kTick}}, 0); };
  if (const base::Status started = apply(program, edit::RideStart{}); !started) return started;
  if (program.options.frames) {
    for (std::int64_t frame = 0; frame < *program.options.frames; ++frame) tick(), tick(), draw();
    summary.end = end_of_ride(program.session, summary);
  } else {
    while (summary.ticks < kMostRideTicks && !lap_is_done(program.session)) tick();
    summary.end = end_of_ride(program.session, summary);
    if (const base::Status again = begin_lap(program); !again) return again;
    advance(program, static_cast<int>(summary.ticks / 2));
  }
  draw(), draw();  // the second frame shows values of the first
  return {};
}

// Prints the report of the whole ride; needs no graphics.
int run_report(const Options& options) {
  base::Files files;
  edit::Session session = edit::make_session({});
  if (const base::Status opened = edit::apply(session, files, edit::Load{track_of(options).string()}); !opened)
    return finish({base::Code::bad_file, opened.message});
  print_notices(session);
  if (const base::Status limits = open_envelope(session, files, options); !limits) return finish(limits);
  const auto report = edit::ride_report(session);
  if (!report) return finish({base::Code::refused, "the track has no cart, so there is no ride to report"});
  std::fputs(report->c_str(), stdout);
  return finish({});
}

base::Status film_lap(Program& program, RideSummary& summary) {
  const Options& options = program.options;
  if (const base::Status chosen = choose_camera(program, options.camera.empty() ? "chase" : options.camera); !chosen)
    return chosen;
  return film_ride(program, movie_order(options), options.frames, summary);
}

int run_headless(const Options& options) {
  const std::filesystem::path out = options.out.empty() ? "out" : options.out;
  const auto root = options.movie.empty() ? base::Root().open(out) : base::Result<base::Root>(base::Root());
  if (!root) return finish(root.status());
  auto program = make_program(options, size_of(options), kWindowSamples);
  if (!program) return finish(program.status());
  Program& p = **program;
  p.files = base::Files(*root);
  if (const base::Status opened = open_track(p, track_of(options)); !opened) return finish(opened);
  if (const base::Status limits = open_envelope(p.session, p.files, options); !limits) return finish(limits);
  if (const base::Status started = start_recording(p); !started) return finish(started);
  p.stats.hide_times = true;
  RideSummary summary = begin_summary(p.session);
  if (!options.movie.empty()) {
    if (const base::Status filmed = film_lap(p, summary); !filmed) return finish(filmed);
    print_summary(options, summary);
    return finish({});
  }
  if (const base::Status chosen = choose_camera(p, options.camera); !chosen) return finish(chosen);
  if (summary.segments > 0 && p.session.motion.carts.size() > 0) {
    if (const base::Status rode = ride(p, summary); !rode) return finish(rode);
  } else {
    for (std::int64_t frame = 0; frame < options.frames.value_or(2); ++frame)
      run_frame(p, {platform::Tick{2 * world::kTick}}, 2);
    if (options.frames.value_or(2) == 0) run_frame(p, {platform::Tick{0}}, 0);
  }
  print_summary(options, summary);
  return finish(write_picture(p, out / "ride.png"));
}

int run_window(const Options& options) {
  auto program = make_program(options, size_of(options), kWindowSamples);
  if (!program) return finish(program.status());
  Program& p = **program;
  const base::UserFolders folders =
      options.config.empty() ? base::user_folders() : base::UserFolders{options.config, options.config};
  start_keeping(p, folders, {}, options.reset_layout);
  platform::watch_signals();
  p.keeper->unasked = options.file.empty();
  if (const base::Status opened = open_track(p, track_of(options)); !opened) return finish(opened);
  p.keeper->unasked = false;
  if (const base::Status limits = open_envelope(p.session, p.files, options); !limits) return finish(limits);
  if (const base::Status chosen = choose_camera(p, options.camera); !chosen) return finish(chosen);
  if (const base::Status started = start_recording(p); !started) return finish(started);
  if (options.file.empty() && p.keeper->state.settings.start_screen) p.ui->show_start();
  p.time.last_frame = p.surface->clock();
  for (std::int64_t frame = 0; !p.quit && !platform::pending_signal() && (!options.frames || frame < *options.frames);
       ++frame) {
    play_frame(p);
    if (std::exchange(p.tutorial.wanted, false)) run_tutorial(p);
  }
  if (const int signal = platform::pending_signal()) return leave_by(p, signal);
  stop_keeping(p, p.quit);
  return finish({});
}

}  // namespace

int run_program(const Options& options) {
  if (options.validate) return validate(options);
  if (options.report) return run_report(options);
  if (!options.script.empty()) return run_script(options);
  return options.headless ? run_headless(options) : run_window(options);
}

}  // namespace coaster::app
