#include "app/modes.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/frame.h"
#include "app/pictures.h"
#include "app/program.h"
#include "app/ride_summary.h"
#include "app/script_host.h"
#include "base/console.h"
#include "base/file_lock.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "edit/perform/apply.h"
#include "edit/session/ride_report.h"
#include "edit/session/session.h"
#include "exchange/challenge_file.h"
#include "exchange/formats.h"
#include "exchange/own/share_link.h"
#include "platform/signals.h"
#include "platform/surface.h"
#include "platform/system.h"
#include "query/challenge_rules.h"
#include "script/grammar.h"
#include "script/runner.h"
#include "sim/shape/folds.h"
#include "world/appearance_settings.h"
#include "world/panel_settings.h"

namespace coaster::app {
namespace {

// Errors of a script. finish_script() is finish(), and with --json prints "code" and the "errors" to stdout; an error
// of no script is one with a message alone.
using ScriptErrors = std::vector<script::ScriptError>;

// Prints an error and returns the exit code of a status.
int finish(const base::Status& status) {
  if (!status) base::print_error(status.message);
  return base::exit_code(status.code);
}

int finish_script(const Options& options, const base::Status& status, ScriptErrors errors) {
  if (!options.json) return finish(status);
  if (!status && errors.empty()) errors.push_back({{}, 0, 0, status.message, {}});
  exchange::JsonList list;
  for (const script::ScriptError& error : errors) list.push_back(script::to_json(error));
  base::print(
      exchange::json_members({{"code", std::int64_t{base::exit_code(status.code)}}, {"errors", std::move(list)}}));
  return finish(status);
}

// Returns the script in a file, or all its errors, one a line.
base::Result<script::Script> read_script(const std::string& path, ScriptErrors& errors) {
  base::Files files;
  auto parsed = script::parse_script_file(path, files);
  if (!parsed) return parsed.status();
  errors = parsed->problems;
  if (parsed->errors.empty()) return std::move(parsed->script);
  return base::Status{base::Code::usage, fmt::format("{}", fmt::join(parsed->errors, "\n"))};
}

// Prints the notices of a file that was opened, because without a window no panel shows them.
void print_notices(const edit::Session& session) {
  for (const edit::Notice& notice : session.notices.list) base::print_error(notice.text);
}

// Loads the force limits named by the options.
base::Status open_envelope(edit::Session& session, base::Files& files, const Options& options) {
  if (options.envelope.empty()) return {};
  return edit::apply(session, files, edit::LoadForceLimits{options.envelope});
}

// Returns the track named by the options, else the default one.
std::filesystem::path track_of(const Options& options) {
  return options.file.empty() ? default_track() : std::filesystem::path(options.file);
}

// Checks that a challenge's start track does not pass it, without a picture.
base::Status validate_challenge(const std::string& path) {
  base::Files files;
  edit::Session session = edit::make_session({});
  session.game.referee = query::referee();
  if (const base::Status begun = edit::apply(session, files, edit::StartChallenge{path}); !begun) return begun;
  print_notices(session);
  edit::ChallengeVerdict verdict = session.game.referee.judge(session, nullptr);
  if (session.game.challenge->file.judged != exchange::JudgedWhen::build &&
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
  base::print(fmt::format("{}: the start track does not pass, as it must: {}\n", path, verdict.reason));
  return {};
}

base::Status validate_file(const std::string& path) {
  base::Files files;
  if (std::filesystem::path(path).extension() == ".json")
    if (const auto text = files.read(path); text && exchange::looks_like_challenge(*text))
      return validate_challenge(path);
  const auto track = exchange::load_track(files, path);
  if (!track) {
    base::Status status = track.status();
    if (!exchange::is_link(path) && !exchange::format_of(path)) status.message += ", or a script ending in .coaster";
    return status;
  }
  for (const std::string& warning : track->warnings) base::print_error(warning);
  const sim::DerivedTrack shapes = sim::shapes_of(track->document);
  for (const std::string& text :
       {sim::tight_text(sim::tight_bends_of(shapes)), sim::deadlock_text(track->document, shapes)})
    if (!text.empty()) base::print_error(fmt::format("{}: warning: {}", path, text));
  return {};
}

// Check files, and print the report of the whole ride.
int run_validate(const Options& options) {
  ScriptErrors errors;
  for (const std::string& path : {options.file, options.script}) {
    if (path.empty()) continue;
    const bool script = path == options.script || std::filesystem::path(path).extension() == ".coaster";
    if (const base::Status valid = script ? read_script(path, errors).status() : validate_file(path); !valid)
      return finish_script(options, valid, errors);
  }
  if (!options.json) base::print("ok\n");
  return finish_script(options, {}, {});
}

int run_report(const Options& options) {
  base::Files files;
  edit::Session session = edit::make_session({});
  if (const base::Status opened = edit::apply(session, files, edit::LoadTrack{track_of(options).string()}); !opened)
    return finish({base::Code::bad_file, opened.message});
  print_notices(session);
  if (const base::Status limits = open_envelope(session, files, options); !limits) return finish(limits);
  const auto report = options.json ? edit::ride_report_json(session) : edit::ride_report(session);
  if (!report) return finish({base::Code::refused, "the track has no train, so there is no ride to report"});
  base::print(*report);
  return finish({});
}

// Draws a first frame, so that the viewport is known, then opens the track.
base::Status open_track(Program& program, const std::filesystem::path& path) {
  run_frame(program, {platform::Tick{0}}, 0);
  if (path.empty()) return apply(program, edit::NewTrack{});
  const base::Status loaded = apply(program, edit::LoadTrack{path.string()});
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

// Returns the folder of --out, whose path may contain links: the user named it. Without --out it is out/NAME in the
// current folder, where a stranger may have prepared links.
base::Result<base::FileRoot> open_out(const Options& options, const std::filesystem::path& name) {
  if (!options.out.empty()) return base::FileRoot().open(options.out);
  const auto here = base::FileRoot().open(".");
  const auto out = here ? here->open("out") : here;
  return out && !name.empty() ? out->open("out" / name) : out;
}

constexpr int kWindowSamples = 4;  // per pixel

// Returns the size named by the options, else the default of windows or of pictures without one.
platform::Size size_of(const Options& options) {
  return options.width > 0 ? platform::Size{options.width, options.height} : platform::Size{1280, 720};
}

void print_summary(const Options& options, const RideSummary& summary) {
  base::print(options.json ? to_json(summary) : to_text(summary));
}

MovieOrder movie_order(const Options& options) { return {options.movie, options.fps, options.gif}; }

base::Status choose_camera(Program& program, const std::string& name) {
  const auto mode = base::value_named<world::CameraMode>(name);
  return mode ? apply(program, edit::Set<&world::Settings::camera_mode>{*mode}) : base::Status{};
}

// Ends after a signal: autosaves unsaved changes, and returns the exit code of the signal, as shells define it.
int leave_by(Program& program, int signal) {
  const base::Status kept = autosave_now(program);
  if (!kept) base::print_error(kept.message);
  stop_keeping(program, false);
  return 128 + signal;
}

int leave_window(Program& program) {
  end_tutorial(program);
  const base::Status recorded = finish_recording(program);
  if (const int signal = platform::pending_signal()) return leave_by(program, signal);
  stop_keeping(program, program.quit);
  return finish(recorded);
}

int run_script(const Options& options) {
  ScriptErrors errors;
  const auto end = [&](const base::Status& status) { return finish_script(options, status, errors); };
  const auto script = read_script(options.script, errors);
  if (!script) return end(script.status());
  const auto out = open_out(options, std::filesystem::path(options.script).stem());
  if (!out) return end(out.status());
  const auto claim = base::claim_folder(*out);  // held until the end
  if (!claim && !options.out.empty()) base::print_error("warning: " + claim.status().message + ", too");
  else if (!claim)
    return end({claim.status().code, fmt::format("{}; give this run a folder of its own, such as --out {}-2",
                                                 claim.status().message, out->folder().string())});
  script::RunOptions run;
  run.out = *out;
  run.update_goldens = options.update_goldens;
  run.environment.seed = static_cast<std::uint64_t>(options.seed);
  if (options.width > 0) run.environment.width = options.width, run.environment.height = options.height;
  const platform::Size size{run.environment.width, run.environment.height};
  auto program = make_program(options, size, 0);
  if (!program) return end(program.status());
  Program& p = **program;
  p.stats.hide_times = true;
  p.files = base::Files(*out);
  platform::watch_signals();
  if (!options.config.empty()) {
    start_keeping(p, {options.config, options.config}, {}, options.reset_layout);  // the user named it
    run.environment.scale = p.session.settings.look->ui_scale;                     // until the script changes it
  }
  if (!options.file.empty())
    if (const base::Status opened = open_track(p, options.file); !opened) return end(opened);
  if (const base::Status limits = open_envelope(p.session, p.files, options); !limits) return end(limits);
  if (const base::Status started = start_recording(p); !started) return end(started);
  if (!options.movie.empty())
    if (const base::Status filming = start_movie(p, movie_order(options)); !filming) return end(filming);
  script::Host host = make_script_host(p);
  script::ScriptError error;
  run.error = &error;
  base::Status ran = script::run_script(*script, host, run);
  if (!error.file.empty()) errors = {std::move(error)};
  if (const base::Status filmed = finish_movie(p); ran && !filmed) ran = filmed;
  if (const base::Status recorded = finish_recording(p); ran && !recorded) ran = recorded;
  const int code = end(ran);
  if (const int signal = platform::pending_signal()) return leave_by(p, signal);
  stop_keeping(p, p.quit);
  return code;
}

// With --frames: draws that many frames. Else rides a lap (two minutes at most) without drawing, and takes one picture
// in its middle.
base::Status ride(Program& program, RideSummary& summary) {
  const auto tick = [&] { ride_tick(program, summary); };
  const auto draw = [&] { run_frame(program, {platform::Tick{2 * world::kTick}}, 0); };
  if (const base::Status started = apply(program, edit::RideStart{}); !started) return started;
  if (program.options.frames) {
    for (std::int64_t frame = 0; frame < *program.options.frames; ++frame) tick(), tick(), draw();
    finish_summary(program.session, summary);
  } else {
    while (summary.ticks < kMostRideTicks && !lap_is_done(program.session)) tick();
    finish_summary(program.session, summary);
    if (const base::Status again = begin_lap(program); !again) return again;
    advance(program, static_cast<int>(summary.ticks / 2));
  }
  draw(), draw();  // the second frame shows values of the first
  return {};
}

base::Status film_lap(Program& program, RideSummary& summary) {
  const Options& options = program.options;
  if (const base::Status chosen = choose_camera(program, options.camera.empty() ? "chase" : options.camera); !chosen)
    return chosen;
  return film_ride(program, movie_order(options), options.frames, summary);
}

int run_headless(const Options& options) {
  const auto root = options.movie.empty() ? open_out(options, "") : base::Result<base::FileRoot>(base::FileRoot());
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
    return finish(finish_recording(p));
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
  const base::Status recorded = finish_recording(p), drawn = write_picture(p, root->folder() / "ride.png");
  return finish(drawn ? recorded : drawn);
}

int run_window(const Options& options) {
  const base::UserFolders folders =
      options.config.empty() ? base::user_folders() : base::UserFolders{options.config, options.config};
  auto made = make_program(options, size_of(options), kWindowSamples);
  if (!made) return finish(made.status());
  const std::shared_ptr<Program> program = std::move(*made);
  Program& p = *program;
  start_keeping(p, folders, {}, options.reset_layout);
  platform::watch_signals();
  // `all` is for scripts, and for users who never chose a workspace.
  if (p.session.settings.panels->workspace == world::Workspace::all)
    (void)apply(p, edit::Set<&world::Panels::workspace>{world::Workspace::build});
  p.keeper->unasked = options.file.empty();
  const std::filesystem::path track = track_of(options);
  const bool asks = exchange::question_of(p.files, track).has_value();
  if (const base::Status opened = open_track(p, asks ? "" : track); !opened) return finish(opened);
  if (asks) p.ui->open(track.string());
  p.keeper->unasked = false;
  if (const base::Status limits = open_envelope(p.session, p.files, options); !limits) return finish(limits);
  if (const base::Status chosen = choose_camera(p, options.camera); !chosen) return finish(chosen);
  if (const base::Status started = start_recording(p); !started) return finish(started);
  if (options.file.empty() && p.keeper->state.settings.start_screen) p.ui->show_start();
  p.surface->answer_by([&p](const std::string& question) { return answer(p, question); });
  p.surface->before_leaving([&p] {
    (void)autosave_now(p);  // it reports errors itself
    return edit::dirty(p.session);
  });
  p.time.last_frame = p.surface->clock();
  const auto step = [program, left = options.frames]() mutable {
    if (program->quit || platform::pending_signal() || (left && (*left)-- <= 0)) return false;
    play_frame(*program);
    teach(*program);
    return true;
  };
  return platform::run_frames(step, [program] { return leave_window(*program); });
}

}  // namespace

int run_program(const Options& options) {
  if (options.validate) return run_validate(options);
  if (options.report) return run_report(options);
  if (!options.script.empty()) return run_script(options);
  return options.headless ? run_headless(options) : run_window(options);
}

}  // namespace coaster::app
